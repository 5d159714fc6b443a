// What the page saves is what the command line writes, byte for byte.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "playground/asked.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

using Words = std::vector<std::string>;

/// A folder with a chart and its stimuli, and the requests about them on both ways.
class Desk {
  public:
    explicit Desk(const std::string& example)
        : text_(chart_text(example)), stimuli_(example_text(example + ".stim")) {
        folder_.file("chart.grafcet", text_);
        folder_.file("chart.stim", stimuli_);
    }

    /// The first file of an export.
    Json asked(const Json& row, Json more = Json::object()) const {
        Json args{{"text", text_}, {"kind", row.at("kind")}, {"format", row.at("format")}};
        for (const Json& name : row.at("takes")) {
            if (name == "stimuli" && row.at("kind") != "netlist" && row.at("kind") != "drawing") {
                args["stimuli"] = stimuli_;
            }
        }
        args.update(more);
        return ask("export", args).at("files");
    }
    std::string written(const Words& command) const { return run_program(begun(command)).out; }
    const std::string& stimuli() const { return stimuli_; }
    std::string file(const std::string& name) const { return text_of(folder_.path(name)); }

  private:
    Words begun(const Words& command) const {
        Words words = {"sh",
                       "-c",
                       "cd \"$1\" && shift && exec \"$@\"",
                       "sh",
                       folder_.path("."),
                       GRAFWIRE_PROGRAM};
        words.insert(words.end(), command.begin(), command.end());
        return words;
    }

    std::string text_;
    std::string stimuli_;
    ScratchFolder folder_;
};

/// The request on the command line that writes what a row of `exports` stands for.
Words command_for(const Json& row) {
    const std::string kind = row.at("kind");
    const std::string format = row.at("format");
    const std::string chart = "chart.grafcet";
    const std::string stimuli = "chart.stim";
    if (kind == "chart") return {"fmt", chart};
    if (kind == "drawing") return {"draw", chart, "--to", format};
    if (kind == "equations") return {"equations", chart, "--to", format};
    if (kind == "netlist") return {"netlist", chart, "--style", "nand", "--to", format};
    if (kind == "program") return {"plc", chart, "--to", format};
    if (kind == "trace") return {"run", chart, stimuli, "--to", format};
    if (kind == "gates") return {"simulate", chart, stimuli, "--to", format};
    if (kind == "waveform") return {"run", chart, stimuli, "-o", "trace.csv", "--vcd", "-"};
    if (kind == "gate-waveform") {
        return {"simulate", chart, stimuli, "-o", "trace.csv", "--vcd", "-"};
    }
    if (kind == "story") return {"run", chart, stimuli, "--explain"};
    if (kind == "gate-story") return {"simulate", chart, stimuli, "--explain"};
    return {"check", chart, "--to", format};
}

/// JUnit reports say how long a check took.
std::string without_seconds(std::string text) {
    for (std::size_t at = 0; (at = text.find(" time=\"", at)) != std::string::npos; ++at) {
        text.erase(at, text.find('"', at + 7) + 1 - at);
    }
    return text;
}

}  // namespace

TEST_CASE("every export is what the command line writes") {
    const Json rows = ask("exports").at("exports");
    REQUIRE(rows.size() > 30);
    for (const std::string name : {"nine-steps", "manipulator"}) {
        const Desk desk(name);
        for (const Json& row : rows) {
            CAPTURE(name);
            CAPTURE(row.dump());
            const Json files = desk.asked(row);
            CHECK(files.at(0).at("name") == "chart" + row.at("suffix").get<std::string>());
            CHECK(without_seconds(files.at(0).at("text")) ==
                  without_seconds(desk.written(command_for(row))));
        }
    }
}

TEST_CASE("exports cover every format that the command line offers") {
    const Json list = ask("exports").at("exports");
    const auto count = [&](const std::string& kind) {
        std::size_t found = 0;
        for (const Json& row : list) found += row.at("kind") == kind ? 1 : 0;
        return found;
    };
    CHECK(count("netlist") == choices_of("netlist", "--to").size());
    CHECK(count("program") == choices_of("plc", "--to").size());
    CHECK(count("equations") == choices_of("equations", "--to").size());
    CHECK(count("drawing") == choices_of("draw", "--to").size());
    CHECK(count("trace") == choices_of("run", "--to").size());
    CHECK(count("report") == choices_of("check", "--to").size());
}

TEST_CASE("a bench stands beside its netlist") {
    const Desk desk("manipulator");
    const Json row{{"kind", "netlist"}, {"format", "verilog"}, {"takes", Json::array()}};
    const Json files = desk.asked(row, {{"stimuli", desk.stimuli()}, {"bench", true}});
    desk.written({"netlist", "chart.grafcet", "--style", "nand", "--to", "verilog", "--stim",
                  "chart.stim", "--bench", "-o", "chart.v"});
    REQUIRE(files.size() == 2);
    CHECK(files.at(0).at("text") == desk.file("chart.v"));
    CHECK(files.at(1).at("name") == "chart_bench.v");
    CHECK(files.at(1).at("text") == desk.file("chart_bench.v"));
}

TEST_CASE("a program has the options and the addresses of the command line") {
    const Desk desk("manipulator");
    const Json row{{"kind", "program"}, {"format", "s7-200"}, {"takes", Json::array()}};
    const Json files = desk.asked(
        row, {{"mnemonics", "iec"}, {"offsets", "off"}, {"addresses", true}, {"lang", "fr"}});
    const std::string written =
        desk.written({"plc", "chart.grafcet", "--to", "s7-200", "--mnemonics", "iec", "--offsets",
                      "off", "--lang", "fr", "--addresses", "chart.io"});
    REQUIRE(files.size() == 2);
    CHECK(files.at(0).at("text") == written);
    CHECK(files.at(1).at("text") == desk.file("chart.io"));
    const Json again = desk.asked(row, {{"io", files.at(1).at("text")}});
    CHECK(again.at(0).at("text") ==
          desk.written({"plc", "chart.grafcet", "--to", "s7-200", "--io", "chart.io"}));
}

}  // namespace grafwire::testing
