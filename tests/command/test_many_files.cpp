// Several charts in one call: which files the words stand for, what becomes of the others where one
// is wrong, and where the results go.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "command/charts.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

using Names = std::vector<std::string>;

constexpr const char* crowded_chart = "graph G{initial 0 0->0:=1}";
constexpr const char* broken_chart = "graph G { initial 0\n 0 -> 1 : =1 }\n";

/// A chart with one input and one output, called `name`.
std::string small_chart(const std::string& name) {
    return "grafcet " + name +
           "\n\ninput  a\noutput V\n\ngraph G {\n  initial 0\n  step 1 : V\n\n  0 -> 1 : a\n"
           "  1 -> 0 : /a\n}\n";
}

/// A folder of charts that are all laid out otherwise than fmt would, so that its --check lists
/// them.
class Charts {
  public:
    explicit Charts(const Names& names) {
        for (const std::string& name : names) {
            std::filesystem::create_directories(
                std::filesystem::path(folder_.path(name)).parent_path());
            folder_.file(name, crowded_chart);
        }
    }
    std::string path(const std::string& name) const { return folder_.path(name); }

    /// What words stand for, without the folder.
    Names found(const Names& words) const {
        Names arguments{"fmt", "--check"};
        for (const std::string& word : words) arguments.push_back(path(word));
        const Ran ran = grafwire_with(arguments);
        CHECK(ran.err.empty());
        Names names;
        std::string rest = ran.out;
        const std::string before = path("");
        while (!rest.empty()) {
            const std::string line = rest.substr(0, rest.find('\n'));
            REQUIRE(line.rfind(before, 0) == 0);
            names.push_back(line.substr(before.size()));
            rest.erase(0, line.size() + 1);
        }
        return names;
    }

  private:
    ScratchFolder folder_;
};

}  // namespace

TEST_CASE("a folder stands for every chart below it, name by name in the order of bytes") {
    const Charts charts({"c/b.grafcet", "c/a/z.grafcet", "c/a-b.grafcet", "c/A.grafcet", "c/no.txt",
                         "d/é.grafcet"});
    CHECK(charts.found({"c"}) ==
          Names{"c/A.grafcet", "c/a/z.grafcet", "c/a-b.grafcet", "c/b.grafcet"});
    CHECK(charts.found({"d", "c/a"}) == Names{"d/é.grafcet", "c/a/z.grafcet"});
    CHECK(charts.found({"c/a/"}) == Names{"c/a/z.grafcet"});
    // What was there before is not there twice, however it is spelled.
    CHECK(charts.found({"c/b.grafcet", "c/./a/../b.grafcet", "c/a", "c"}) ==
          Names{"c/b.grafcet", "c/a/z.grafcet", "c/A.grafcet", "c/a-b.grafcet"});
}

TEST_CASE("patterns are read as shells read them") {
    const Charts charts({"x.grafcet", "xy.grafcet", "é.grafcet", ".h.grafcet", "c/x.grafcet",
                         "c/d/x.grafcet", "c/d/y.grafcet", ".c/x.grafcet"});
    CHECK(charts.found({"*.grafcet"}) == Names{"x.grafcet", "xy.grafcet", "é.grafcet"});
    CHECK(charts.found({"?.grafcet"}) == Names{"x.grafcet", "é.grafcet"});
    CHECK(charts.found({"x*.g*t"}) == Names{"x.grafcet", "xy.grafcet"});
    CHECK(charts.found({".*.grafcet"}) == Names{".h.grafcet"});
    CHECK(charts.found({"*/x.grafcet"}) == Names{"c/x.grafcet"});
    CHECK(charts.found({"*/*/?.grafcet"}) == Names{"c/d/x.grafcet", "c/d/y.grafcet"});
    CHECK(charts.found({"**/x.grafcet"}) == Names{"c/d/x.grafcet", "c/x.grafcet", "x.grafcet"});
    CHECK(charts.found({"c/**"}) == Names{"c/d/x.grafcet", "c/d/y.grafcet", "c/x.grafcet"});
    CHECK(charts.found({"**/d/**/y.grafcet"}) == Names{"c/d/y.grafcet"});
    // A folder that fits stands for what is below it, as it would after a shell.
    CHECK(charts.found({"c*"}) == charts.found({"c"}));
    CHECK(charts.found({"*y*"}) == Names{"xy.grafcet"});
}

TEST_CASE("a file whose name looks like a pattern is that file") {
    const Charts charts({"a*.grafcet", "ab.grafcet"});
    CHECK(charts.found({"a*.grafcet"}) == Names{"a*.grafcet"});
    CHECK(charts.found({"?b.grafcet"}) == Names{"ab.grafcet"});
}

TEST_CASE("links to folders are followed where they are written, not below") {
    const Charts charts({"c/x.grafcet"});
    std::filesystem::create_directory_symlink(charts.path("c"), charts.path("c/round"));
    std::filesystem::create_directory_symlink(charts.path("c"), charts.path("link"));
    CHECK(charts.found({"c"}) == Names{"c/x.grafcet"});
    CHECK(charts.found({"link"}) == Names{"link/x.grafcet"});
    CHECK(charts.found({"c/**/x.grafcet"}) == Names{"c/x.grafcet"});
}

TEST_CASE("where nothing is found is told, and does not stop the others") {
    const ScratchFolder folder;
    const std::string chart = folder.file("a.grafcet", small_chart("a"));
    std::filesystem::create_directory(folder.path("empty"));
    const std::string pattern = folder.path("*.none");
    const Ran ran = grafwire_with({"info", folder.path("empty"), chart, pattern});
    CHECK(ran.status == 2);
    CHECK(contains(ran.err, folder.path("empty") +
                                ": error: there is no .grafcet file in this folder, nor below it"));
    CHECK(contains(ran.err, pattern + ": error: no file fits this pattern\n"));
    CHECK(contains(ran.out, "==> " + chart + " <==\nGRAFCET a\n"));
    CHECK(contains(grafwire_with({"info", pattern, "--lang", "fr"}).err,
                   "aucun fichier ne correspond à ce motif"));
}

TEST_CASE("one that fails does not stop the others, in any command; the status is the worst") {
    const ScratchFolder folder;
    const std::string first = folder.file("first.grafcet", small_chart("first"));
    const std::string broken = folder.file("broken.grafcet", broken_chart);
    const std::string last = folder.file("last.grafcet", small_chart("last"));
    const std::string out = folder.path("out");
    for (const Names& command :
         {Names{"equations"}, Names{"netlist", "--style", "nand", "--to", "verilog"},
          Names{"netlist", "--style", "nand", "--to", "svg"}, Names{"plc", "--to", "st"}}) {
        CAPTURE(command);
        Names arguments = command;
        arguments.insert(arguments.end(), {"-o", out, first, broken, last});
        const Ran ran = grafwire_with(arguments);
        CHECK(ran.status == 2);
        CHECK(ran.out.empty());
        CHECK(contains(ran.err, broken + ":2:7: error: "));
        Names names;
        for (const auto& entry : std::filesystem::directory_iterator(out)) {
            names.push_back(entry.path().stem().string());
        }
        std::sort(names.begin(), names.end());
        CHECK(names == Names{"first", "last"});
        std::filesystem::remove_all(out);
    }
    // Where nothing comes of it, no folder stays behind.
    CHECK(grafwire_with({"equations", broken, folder.path("none"), "-o", out}).status == 2);
    CHECK(!std::filesystem::exists(out));
}

TEST_CASE("files in the folder of -o are what single calls write") {
    const ScratchFolder folder;
    const Names charts{folder.file("a.grafcet", small_chart("one")),
                       folder.file("b.grafcet", small_chart("two"))};
    const std::string stimuli = folder.file("a.stim", "0ms : Init=1\n10ms : Init=0\n+1ms : end\n");
    const std::string out = folder.path("new/out");
    struct Case {
        Names command;
        Names files;  ///< of the first chart
    };
    for (const Case& test :
         {Case{{"equations", "--to", "latex"}, {"a.tex"}},
          Case{{"netlist", "--style", "nand", "--to", "json"}, {"a.json"}},
          Case{{"netlist", "--style", "nand", "--to", "verilog", "--stim", stimuli, "--bench"},
               {"a.v", "a_bench.v"}},
          Case{{"plc", "--to", "ladder-svg"}, {"a.svg"}}}) {
        CAPTURE(test.command);
        Names single = test.command;
        single.insert(single.end(), {charts[0], "-o", folder.path(test.files[0])});
        REQUIRE(grafwire_with(single).status == 0);
        Names many = test.command;
        many.insert(many.end(), {charts[0], charts[1], "-o", out});
        CHECK(grafwire_with(many).status == 0);
        std::size_t count = 0;
        for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(out)) ++count;
        CHECK(count == 2 * test.files.size());
        for (const std::string& file : test.files) {
            CHECK(text_of(out + "/" + file) == text_of(folder.path(file)));
        }
        std::filesystem::remove_all(out);
    }
    const Ran ran = grafwire_with({"plc", "--to", "s7-200", charts[0], charts[1], "-o", out,
                                   "--addresses", folder.path("tables")});
    CHECK(ran.status == 0);
    CHECK(std::filesystem::exists(out + "/b.awl"));
    CHECK(std::filesystem::exists(folder.path("tables/b.io")));
}

TEST_CASE("a folder or a pattern has several results however many charts there are") {
    const ScratchFolder folder;
    const std::string chart = folder.file("a.grafcet", small_chart("a"));
    const std::string alone = grafwire_with({"info", chart}).out;
    CHECK(grafwire_with({"info", folder.path("*.grafcet")}).out ==
          "==> " + chart + " <==\n" + alone);
    CHECK(grafwire_with({"equations", folder.path(""), "-o", folder.path("out")}).status == 0);
    CHECK(text_of(folder.path("out/a.txt")) == grafwire_with({"equations", chart}).out);
}

TEST_CASE("two results of one name are refused before anything is written") {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder.path("x"));
    const std::string first = folder.file("a.grafcet", small_chart("a"));
    const std::string other = folder.file("x/a.grafcet", small_chart("b"));
    const Ran ran = grafwire_with({"equations", first, other, "-o", folder.path("out")});
    CHECK(ran.status == 2);
    CHECK(ran.err == "grafwire: error: " + first + " and " + other +
                         ": the results of both would be called a; give them to two calls, with a "
                         "folder each\n");
    CHECK(!std::filesystem::exists(folder.path("out")));
    // One behind the other they need no names.
    CHECK(grafwire_with({"equations", first, other}).status == 0);
}

TEST_CASE("on standard output: text under the name of its file, a line of JSON each, or not") {
    const ScratchFolder folder;
    const std::string first = folder.file("a.grafcet", small_chart("a"));
    const std::string other = folder.file("b.grafcet", small_chart("b"));
    for (const std::string form : {"text", "markdown"}) {
        CHECK(grafwire_with({"equations", first, other, "--to", form}).out ==
              "==> " + first + " <==\n" + grafwire_with({"equations", first, "--to", form}).out +
                  "\n==> " + other + " <==\n" +
                  grafwire_with({"equations", other, "--to", form}).out);
    }
    const Ran lines = grafwire_with({"equations", first, other, "--to", "json"});
    CHECK(lines.status == 0);
    CHECK(std::count(lines.out.begin(), lines.out.end(), '\n') == 2);
    CHECK(lines.out.rfind("{\"file\":\"" + first + "\",\"name\":\"a\",", 0) == 0);
    CHECK(contains(lines.out, "\n{\"file\":\"" + other + "\",\"name\":\"b\","));
    for (const Names& command :
         {Names{"equations", "--to", "latex"}, Names{"equations", "--to", "csv"},
          Names{"netlist", "--style", "nand", "--to", "blif"}, Names{"plc", "--to", "c"}}) {
        Names arguments = command;
        arguments.insert(arguments.end(), {first, other});
        const Ran ran = grafwire_with(arguments);
        CHECK(ran.status == 2);
        CHECK(ran.out.empty());
        CHECK(ran.err ==
              "grafwire: error: several GRAFCETs in a form that cannot stand one behind "
              "the other: name a folder with -o\n");
    }
}

TEST_CASE("standard input is one of several") {
    const ScratchFolder folder;
    const std::string other = folder.file("b.grafcet", small_chart("b"));
    const Ran ran =
        grafwire_with({"plc", "-", other, "--to", "c", "-o", folder.path("out")}, small_chart("a"));
    CHECK(ran.status == 0);
    CHECK(std::filesystem::exists(folder.path("out/stdin.c")));
    CHECK(std::filesystem::exists(folder.path("out/b.c")));
}

TEST_CASE("commands for one chart say which are for several") {
    CHECK(grafwire_with({"draw", sequence_chart, sequence_stimuli, sequence_chart}).err ==
          "grafwire: error: '" + std::string(sequence_chart) +
              "' is one word too many; check, equations, fmt, info, netlist and plc take several "
              "GRAFCETs\n'grafwire draw --help' shows what there is.\n");
}

}  // namespace grafwire::testing
