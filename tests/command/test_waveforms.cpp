// Waveforms as GTKWave opens them, and what it is told to show, read by its own programs.

#include <doctest/doctest.h>

#include <filesystem>
#include <sstream>

#include "command/charts.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

/// Names of every kind that a chart may have and a VCD may not.
constexpr const char* chart_text = R"(grafcet "Manège n° 1" "À la fête"
input dcy, "bouton d'arrêt", "a[3]:b", "$end", "x.y", 温度
output "V+", épais
var occupé
counter n : -1..3
graph G {
  initial 0 : "V+"
  step "étape 1" : épais, set occupé, n := n + 1
  0 -> "étape 1" : dcy . /"bouton d'arrêt" . /"a[3]:b" . /"$end" . /"x.y" . /温度
  "étape 1" -> 0 : /dcy do reset occupé
}
)";
constexpr const char* stimuli_text = "0ms : dcy=0\n1ms : dcy=1\n2ms : dcy=0\n10ms : end\n";

std::vector<std::string> words_after(const std::string& text, const std::string& begin,
                                     std::size_t word) {
    std::vector<std::string> found;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind(begin, 0) != 0) continue;
        std::istringstream words(line);
        std::string item;
        for (std::size_t i = 0; i <= word; ++i) words >> item;
        found.push_back(item);
    }
    return found;
}

/// The signals that a save file of GTKWave shows, in their order.
std::vector<std::string> shown_in(const std::string& gtkw) {
    std::vector<std::string> names;
    std::istringstream lines(gtkw);
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line[0] != '@' && line[0] != '-' && line[0] != '[') {
            names.push_back(line);
        }
    }
    return names;
}

/// The part of a VCD text that holds the changes.
std::string changes_in(const std::string& vcd) {
    const std::size_t end = vcd.find("$enddefinitions");
    return end == std::string::npos ? "" : vcd.substr(end);
}

/// The signals that GTKWave finds in a waveform, on a screen that nobody sees.
std::string found_by_gtkwave(const ScratchFolder& folder, const std::string& vcd) {
    const std::string script = folder.file("facs.tcl", R"(
for {set i 0} {$i < [gtkwave::getNumFacs]} {incr i} { puts "fac [gtkwave::getFacName $i]" }
flush stdout
exit
)");
    const Ran ran =
        run_program({"xvfb-run", "-a", "gtkwave", "--nomenus", "-S", script, vcd}, {}, {});
    INFO(ran.out << ran.err);
    REQUIRE(ran.status == 0);
    return ran.out;
}

}  // namespace

TEST_CASE("waveforms with any names are read by GTKWave's programs") {
    const ScratchFolder folder;
    const std::string chart = folder.file("c.grafcet", chart_text);
    const std::string stim = folder.file("c.stim", stimuli_text);
    const std::vector<std::vector<std::string>> commands = {
        {"run", chart, stim},
        {"simulate", chart, stim, "--style", "clocked"},
    };
    for (std::vector<std::string> command : commands) {
        INFO("command: " << command[0]);
        const std::string vcd = folder.path(command[0] + ".vcd");
        command.insert(command.end(), {"-o", folder.path("out.csv"), "--vcd", vcd});
        REQUIRE(grafwire_with(command).status == 0);
        const std::string text = text_of(vcd);
        CHECK(contains(text, "$comment epais is épais $end\n"));
        const std::vector<std::string> signals = words_after(text, "$var", 4);
        // Its converter keeps them all.
        const std::string fst = folder.path("out.fst");
        REQUIRE(run_program({"vcd2fst", vcd, fst}).status == 0);
        const Ran back = run_program({"fst2vcd", fst});
        CHECK(back.status == 0);
        CHECK(words_after(back.out, "$var", 4) == signals);
        // The viewer finds what it is told to show.
        const std::string found = found_by_gtkwave(folder, vcd);
        const auto shown = shown_in(text_of(folder.path(command[0] + ".gtkw")));
        CHECK(shown.size() == (command[0] == "run" ? 15 : 14));  // counters are no nets
        CHECK(shown.front() == "Manege_n_deg_1.dcy");
        for (const std::string& name : shown) {
            CHECK_MESSAGE(contains(found, "fac " + name + "\n"), name << " in " << found);
        }
    }
}

TEST_CASE("what GTKWave is to show stays as the user has left it") {
    const ScratchFolder folder;
    const std::string chart = folder.file("c.grafcet", chart_text);
    const std::string stim = folder.file("c.stim", stimuli_text);
    const std::string view = folder.file("run.gtkw", "mine");
    const auto run_to = [&](const std::string& vcd) {
        return grafwire_with({"run", chart, stim, "-o", folder.path("out.csv"), "--vcd", vcd})
            .status;
    };
    CHECK(run_to(folder.path("run.vcd")) == 0);
    CHECK(text_of(view) == "mine");
    CHECK(run_to("/dev/null") == 0);
    CHECK(run_to(folder.path("run.dump")) == 0);
    CHECK_FALSE(std::filesystem::exists(folder.path("run.dump.gtkw")));
    CHECK(run_to(folder.path("new.vcd")) == 0);
    CHECK(contains(text_of(folder.path("new.gtkw")), "[dumpfile] \"new.vcd\"\n"));
}

TEST_CASE("a waveform in FST says what the one in VCD says, and has the same bytes each time") {
    const ScratchFolder folder;
    const std::string chart = folder.file("c.grafcet", chart_text);
    const std::string stim = folder.file("c.stim", stimuli_text);
    for (const std::vector<std::string>& request :
         {std::vector<std::string>{"run"}, {"simulate", "--style", "clocked"}}) {
        INFO("command: " << request[0]);
        const auto write_to = [&](const std::string& waveform) {
            std::vector<std::string> arguments = request;
            arguments.insert(arguments.end(), {chart, stim, "-o", folder.path("out.csv"), "--vcd",
                                               folder.path(waveform)});
            REQUIRE(grafwire_with(arguments).status == 0);
            return text_of(folder.path(waveform));
        };
        write_to("w.vcd");
        const std::string fst = write_to("w.fst");
        const std::string again = request[0] + "-again";
        CHECK(write_to(again + ".fst") == fst);
        const std::string view = text_of(folder.path(again + ".gtkw"));
        CHECK(contains(view, "[dumpfile] \"" + again + ".fst\"\n"));
        // GTKWave's own converters make the same of both.
        REQUIRE(run_program({"vcd2fst", folder.path("w.vcd"), folder.path("theirs.fst")}).status ==
                0);
        const Ran ours = run_program({"fst2vcd", folder.path("w.fst")});
        const Ran theirs = run_program({"fst2vcd", folder.path("theirs.fst")});
        CHECK(ours.status == 0);
        CHECK(changes_in(ours.out) == changes_in(theirs.out));
        CHECK(words_after(ours.out, "$var", 4) == words_after(theirs.out, "$var", 4));
        const std::string found = found_by_gtkwave(folder, folder.path("w.fst"));
        for (const std::string& name : shown_in(view)) {
            CHECK_MESSAGE(contains(found, "fac " + name + "\n"), name << " in " << found);
        }
    }
}

TEST_CASE("a waveform in FST that cannot be made leaves nothing behind") {
    const ScratchFolder folder;
    const Ran ran =
        grafwire_with({"run", sequence_chart, sequence_stimuli, "--vcd", folder.path("run.fst")},
                      {}, {"TMPDIR=" + folder.path("missing")});
    CHECK(ran.status == 2);
    CHECK(ran.out.empty());
    CHECK(contains(ran.err, "cannot write " + folder.path("run.fst")));
    CHECK(folder.names().empty());
}

}  // namespace grafwire::testing
