// What files say at their heads of how they were made: the request there makes the same bytes.

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "command/charts.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

constexpr const char* machine_chart = R"(
grafcet machine "Une machine, l'été"
input m, épais
output KM1
graph G {
  initial 0
  step 1 : KM1
  0 -> 1 : ↑m . épais
  1 -> 0 : 2s/X1
}
)";

/// A folder with the chart under a name that a shell has to have quoted.
class MachineFolder {
  public:
    MachineFolder() {
        folder_.file("l'été 2.grafcet", machine_chart);
        folder_.file("m.stim", "0ms : m=0 épais=1\n+1s : m=1\n+3s : end\n");
    }
    std::string path(const std::string& name) const { return folder_.path(name); }
    /// What a request writes that is made in the folder.
    std::string again(const std::string& request) const {
        const std::string program = std::string(GRAFWIRE_PROGRAM) + request.substr(8);
        return run_program({"sh", "-c", "cd \"$1\" && " + program, "sh", folder_.path(".")}).out;
    }

  private:
    ScratchFolder folder_;
};

/// The request in a text, from `grafwire COMMAND` to the end of the line or of its comment.
std::string request_in(const std::string& text, const std::string& command) {
    const std::size_t begin = text.find("grafwire " + command + " ");
    if (begin == std::string::npos) return {};
    const std::size_t end = std::min(text.find('\n', begin), text.find(" *)", begin));
    return text.substr(begin, end - begin);
}

}  // namespace

TEST_CASE("the request at the head of a netlist writes the same netlist again") {
    const MachineFolder folder;
    for (const std::string format : {"verilog", "spice", "blif", "dot", "text"}) {
        for (const std::string style : {"nand", "clocked"}) {
            CAPTURE(format);
            const std::string text = grafwire_with({"netlist", folder.path("l'été 2.grafcet"),
                                                    "--style", style, "--to", format})
                                         .out;
            const std::string first = text.substr(0, text.find('\n'));
            CHECK(contains(first, " machine \"Une machine, l'été\" (l'été 2.grafcet): "));
            CHECK(contains(text, "Style " + style + ", CDX by "));
            CHECK(contains(text, "Inner nets are called OWNER$ROLE"));
            CHECK(contains(text, "$clear ") == (style == "clocked"));
            CHECK(contains(text, "$q ") == (style == "nand"));
            CHECK_FALSE(contains(text, folder.path("")));
            CHECK(folder.again(request_in(text, "netlist")) == text);
        }
    }
}

TEST_CASE("with stimuli and a bench too") {
    const MachineFolder folder;
    const std::string name = folder.path("l'été 2.grafcet");
    const std::string deck = grafwire_with({"netlist", name, "--style", "clocked", "--to", "spice",
                                            "--stim", folder.path("m.stim"), "--scan", "20ms"})
                                 .out;
    CHECK(contains(request_in(deck, "netlist"), "--scan 20ms --stim m.stim"));
    CHECK(folder.again(request_in(deck, "netlist")) == deck);
    CHECK(grafwire_with({"netlist", name, "--style", "nand", "--to", "verilog", "--stim",
                         folder.path("m.stim"), "--bench", "-o", folder.path("m.v")})
              .status == 0);
    const std::string bench = text_of(folder.path("m_bench.v"));
    CHECK(contains(bench, "// machine \"Une machine, l'été\" (l'été 2.grafcet): test bench.\n"));
    folder.again(request_in(bench, "netlist"));
    CHECK(text_of(folder.path("m_bench.v")) == bench);
}

TEST_CASE("the request at the head of a program writes the same program again") {
    const MachineFolder folder;
    for (const std::string& format : choices_of("plc", "--to")) {
        for (const std::string language : {"en", "fr"}) {
            CAPTURE(format);
            const std::string text = grafwire_with({"plc", folder.path("l'été 2.grafcet"), "--to",
                                                    format, "--modes", "off", "--lang", language})
                                         .out;
            const std::string by =
                language == "fr" ? "Écrit par grafwire " : "Written by grafwire ";
            CHECK(contains(text, by));
            // Drawings break lines, and XML has its own spelling.
            if (format.starts_with("ladder") || format == "plcopen" || format == "sfc") continue;
            const std::string request = request_in(text, "plc");
            CHECK(contains(request, " --modes off"));
            CHECK(folder.again(request) == text);
        }
    }
    const std::string sketch =
        grafwire_with({"plc", folder.path("l'été 2.grafcet"), "--to", "arduino", "--pull-up"}).out;
    CHECK(folder.again(request_in(sketch, "plc")) == sketch);
}

TEST_CASE("a chart from standard input has no file") {
    const std::string text =
        grafwire_with({"netlist", "-", "--style", "nand", "--to", "blif"}, machine_chart).out;
    CHECK(text.starts_with("# machine \"Une machine, l'été\": "));
    CHECK(contains(text, "#   grafwire netlist - --style nand"));
}

}  // namespace grafwire::testing
