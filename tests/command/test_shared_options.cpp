// grafwire.toml: where it is looked for, what it changes, and what is wrong with one.

#include <doctest/doctest.h>

#include <filesystem>

#include "command/charts.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

using Words = std::vector<std::string>;

/// A folder `a/b` with a chart, and a file of shared options where it is wanted.
class Shared {
  public:
    Shared() {
        std::filesystem::create_directories(folder_.path("a/b"));
        chart = folder_.file("a/b/chart.grafcet", text_of(rule_5_chart));
    }
    std::string config(const std::string& place, const std::string& text) const {
        return folder_.file(place + "grafwire.toml", text);
    }
    std::string path(const std::string& name) const { return folder_.path(name); }
    std::string file(const std::string& name, const std::string& text) const {
        return folder_.file(name, text);
    }
    void remove(const std::string& name) const { std::filesystem::remove_all(folder_.path(name)); }

    std::string chart;

  private:
    ScratchFolder folder_;
};

/// The first line of a report, which names the style.
std::string verdict(const Words& arguments) {
    Words words{"check"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const Ran ran = grafwire_with(words);
    INFO(ran.err);
    CHECK(ran.status < 2);
    return ran.out.substr(ran.out.find('(') + 1, ran.out.find(',') - ran.out.find('(') - 1);
}

}  // namespace

TEST_CASE("the nearest file counts, in the folder of the chart or above, within its repository") {
    const Shared shared;
    CHECK(verdict({shared.chart}) == "style nand");
    shared.config("", "[check]\nstyle = \"nor\"\n");
    CHECK(verdict({shared.chart}) == "style nor");
    shared.config("a/", "[check]\nstyle = \"rs\"\n");
    CHECK(verdict({shared.chart}) == "style rs");
    shared.config("a/b/", "[info]\nstrict = false\n");
    CHECK(verdict({shared.chart}) == "style nand");
    shared.remove("a/b/grafwire.toml");
    shared.remove("a/grafwire.toml");
    std::filesystem::create_directory(shared.path("a/.git"));
    CHECK(verdict({shared.chart}) == "style nand");
    shared.config("a/", "[check]\nstyle = \"rs\"\n");
    CHECK(verdict({shared.chart}) == "style rs");
    // Of folders and patterns as of files.
    CHECK(verdict({shared.path("a")}) == "style rs");
    CHECK(verdict({shared.path("a/*/*.grafcet")}) == "style rs");
    CHECK(verdict({shared.path("a/b/../b/")}) == "style rs");
}

TEST_CASE("the command line comes first, and --no-config leaves the file alone") {
    const Shared shared;
    shared.config("",
                  "[check]\nstyle = [\"nor\", \"rs\"]\nstrict = true\nj = 1\n"
                  "assume = [\"m + /m\"]\nmax-cases = 5\n");
    CHECK(grafwire_with({"check", shared.chart, "--no-config"}).status == 0);
    const Ran ran = grafwire_with({"check", shared.chart});
    CHECK(ran.status == 2);
    CHECK(contains(ran.err, "unknown variable 'm'"));
    shared.config("", "[check]\nstyle = [\"nor\", \"rs\"]\nmax-cases = 5\n");
    CHECK(grafwire_with({"check", shared.chart}).status == 3);
    CHECK(contains(grafwire_with({"check", shared.chart}).err, "2 checks"));
    CHECK(verdict({shared.chart, "--style", "gates", "--max-cases", "0"}) == "style gates");
    CHECK(verdict({"--max-cases=0", "--style=gates", "--", shared.chart}) == "style gates");
    CHECK(grafwire_with({"--no-config", "check", shared.chart}).status == 0);
    // What is required may be shared.
    shared.config("", "[netlist]\nstyle = \"nand\"\nto = \"blif\"\n");
    CHECK(grafwire_with({"netlist", shared.chart}).out ==
          grafwire_with({"netlist", shared.chart, "--no-config", "--style", "nand", "--to", "blif"})
              .out);
    CHECK(grafwire_with({"netlist", shared.chart, "--no-config"}).status == 2);
}

TEST_CASE("a shared option that has no effect on a call is none that is refused") {
    const Shared shared;
    shared.config("",
                  "[check]\nstyle = \"nor\"\nchanges = \"one\"\n\n"
                  "[equations]\nstandalone = true\n");
    const std::string netlist = shared.file(
        "n.blif", grafwire_with({"netlist", shared.chart, "--style", "nand", "--to", "blif"}).out);
    CHECK(grafwire_with({"check", shared.chart, "--against", netlist}).status == 0);
    CHECK(grafwire_with({"check", shared.chart, "--style", "clocked"}).status == 0);
    CHECK(grafwire_with({"equations", shared.chart, "--to", "csv"}).status == 0);
    CHECK(grafwire_with({"equations", shared.chart, "--to", "csv", "--standalone"}).status == 2);
}

TEST_CASE("what is wrong with a file is told with its place, whichever command it is for") {
    const Shared shared;
    struct Case {
        std::string text;
        std::string place;
        std::string message;
    };
    for (const Case& test :
         {Case{"[check]\nstyel = \"nand\"\n", "2:1",
               "there is no option '--styel'; did you mean '--style'?"},
          Case{"[check]\nstyle = \"xor\"\n", "2:1", "--style: xor not in {"},
          Case{"[check]\nmax-cases = -1\n", "2:1", "'-1' is no whole number"},
          Case{"[check]\nmax-cases = \"many\"\n", "2:1", "'many' is no whole number"},
          Case{"[check]\nstrict = \"yes\"\n", "2:1", "--strict is either true or false"},
          Case{"[check]\nstyle = true\n", "2:1", "--style has a value, and is not true or false"},
          Case{"[check]\nstyle = {a = 1}\n", "2:9", "--style takes a text, a number"},
          Case{"[check]\nstyle = []\n", "2:9", "--style takes a text, a number"},
          Case{"[check]\nagainst = \"n.blif\"\n", "2:1",
               "--against belongs to a single call, and cannot be shared"},
          Case{"[chek]\nstyle = \"nand\"\n", "1:2", "did you mean 'check'?"},
          Case{"[s7]\n", "1:2", "there is no command 's7'"},
          Case{"\nstyle = \"nand\"\n", "2:1", "'style' stands below no command"},
          Case{"[check]\nstyle = nand\n", "2:12", "this is no TOML: "},
          Case{"[plc]\ncpu = \"999\"\n", "2:1", "--cpu: "}}) {
        CAPTURE(test.text);
        const std::string config = shared.config("", test.text);
        const Ran ran = grafwire_with({"check", shared.chart});
        CHECK(ran.status == 2);
        CHECK(ran.out.empty());
        CHECK(contains(ran.err, "grafwire.toml:" + test.place + ": error: "));
        CHECK(contains(ran.err, test.message));
        CHECK(grafwire_with({"check", shared.chart, "--no-config"}).status == 0);
    }
    shared.config("", "[check]\nstrict = 1\n");
    CHECK(contains(grafwire_with({"check", shared.chart, "--lang", "fr"}).err,
                   "--strict vaut true ou false"));
}

TEST_CASE("charts with different files do not go into one call") {
    const Shared shared;
    shared.config("a/b/", "[check]\nstyle = \"rs\"\n");
    const std::string other = shared.file("other.grafcet", text_of(sequence_chart));
    const Ran ran = grafwire_with({"check", shared.chart, other});
    CHECK(ran.status == 2);
    CHECK(contains(ran.err, "different shared options"));
    CHECK(contains(ran.err, "a/b/grafwire.toml"));
    CHECK(grafwire_with({"check", shared.chart, other, "--no-config"}).status == 0);
}

}  // namespace grafwire::testing
