// Traces and waveforms of the reference evolution and of the gates.

#include <doctest/doctest.h>

#include <sstream>

#include "support/csv.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

const std::string axis = example("positioning-axis.grafcet");
const std::string scan_stim = example("positioning-axis-scan.stim");

/// A value change dump as far as anybody must be able to read it: declarations, then moments that
/// only grow, with values of signals that were declared.
void check_vcd(const std::string& text) {
    CHECK(contains(text, "$timescale "));
    CHECK(contains(text, "$scope module "));
    const std::size_t body = text.find("$enddefinitions $end\n");
    REQUIRE(body != std::string::npos);
    long long last = -1;
    std::size_t at = body + 21;
    std::size_t changes = 0;
    while (at < text.size()) {
        const std::string line = text.substr(at, text.find('\n', at) - at);
        at += line.size() + 1;
        if (line.empty() || line[0] == '$') continue;
        if (line[0] == '#') {
            CHECK(std::stoll(line.substr(1)) > last);
            last = std::stoll(line.substr(1));
            continue;
        }
        const std::size_t blank = line.find(' ');
        const std::string signal = line.substr(blank == std::string::npos ? 1 : blank + 1);
        CHECK(text.find(" " + signal + " ") < body);
        ++changes;
    }
    CHECK(last > 0);
    CHECK(changes > 0);
}

}  // namespace

TEST_CASE("the columns and rows of a trace") {
    const ScratchFolder folder;
    const std::string chart = folder.file("c.grafcet", R"(grafcet c
input a, "b c"
output "V+"
var v
counter n : -1..3
graph G {
  initial 0 : "V+" if "b c"
  step 1 : set v, n := n + 1
  0 -> 1 : ↑a
  1 -> 0 : 1.5ms/X1
}
)");
    const std::string stim = folder.file("c.stim", R"(0ms : "b c"=1
1ms : a=1
+2.25ms : a=0
10ms : end
)");
    const Ran ran = grafwire_with({"run", chart, stim});
    CHECK(ran.status == 0);
    CHECK(ran.err.empty());
    CHECK(ran.out ==
          "time_ms,a,b c,Init,AUdur,AUdoux,X0,X1,V+,v,n\n"
          "0,0,1,0,0,0,1,0,1,0,-1\n"
          "1,1,1,0,0,0,0,1,0,1,0\n"
          "2.5,1,1,0,0,0,1,0,1,1,0\n"
          "3.25,0,1,0,0,0,1,0,1,1,0\n"
          "10,0,1,0,0,0,1,0,1,1,0\n");
    CHECK(grafwire_with({"simulate", chart, stim, "--style", "clocked"}).out == ran.out);
    CHECK(grafwire_with({"run", chart, stim, "--scan", "2.5ms"}).out ==
          "time_ms,a,b c,Init,AUdur,AUdoux,X0,X1,V+,v,n\n"
          "0,0,1,0,0,0,1,0,1,0,-1\n"
          "2.5,1,1,0,0,0,0,1,0,1,0\n"
          "5,0,1,0,0,0,0,1,0,1,0\n"
          "7.5,0,1,0,0,0,1,0,1,1,0\n"
          "10,0,1,0,0,0,1,0,1,1,0\n");
}

TEST_CASE("run and simulate agree, byte for byte, where the wiring is sound") {
    for (const std::string name :
         {"single-sequence", "selection-divergence", "selection-convergence", "parallel-divergence",
          "parallel-convergence", "nine-steps", "rule-5", "manipulator"}) {
        INFO("example: " << name);
        const std::string chart = example(name + ".grafcet");
        const std::string stim = example(name + ".stim");
        const std::string expected = grafwire_with({"run", chart, stim}).out;
        CHECK(read_csv(expected).size() > 20);
        const Ran ran = grafwire_with({"simulate", chart, stim, "--style", "nand"});
        CHECK(ran.status == 0);
        CHECK(ran.out == expected);
    }
}

TEST_CASE("scan by scan, reference and clocked netlist agree") {
    const Ran run = grafwire_with({"run", axis, scan_stim, "--scan", "10ms"});
    CHECK(run.status == 0);
    CHECK(read_csv(run.out).size() == 152);
    const Ran gates =
        grafwire_with({"simulate", axis, scan_stim, "--style", "clocked", "--scan", "10ms"});
    CHECK(gates.status == 0);
    CHECK(gates.out == run.out);
}

TEST_CASE("no stable situation: status 1, and the trace up to there") {
    const ScratchFolder folder;
    const std::string csv = folder.path("out.csv");
    const std::string vcd = folder.path("out.vcd");
    const Ran ran = grafwire_with({"run", axis, scan_stim, "-o", csv, "--vcd", vcd});
    CHECK(ran.status == 1);
    CHECK(ran.err ==
          "grafwire: error: no stable situation at 100 ms; these keep changing: X0, X1, X2\n");
    const auto rows = read_csv(text_of(csv));
    REQUIRE(rows.size() == 2);
    CHECK(rows[1][0] == "0");
    CHECK(contains(text_of(vcd), "$enddefinitions"));
}

TEST_CASE("run --explain: words in place of the trace, which goes where -o says") {
    const ScratchFolder folder;
    const std::string csv = folder.path("out.csv");
    const std::string chart = example("rule-5.grafcet");
    const std::string stim = example("rule-5.stim");
    const Ran ran = grafwire_with({"run", chart, stim, "--explain"});
    CHECK(ran.status == 0);
    CHECK(ran.out.rfind("At 0 ms: all inputs are 0\n", 0) == 0);
    CHECK(
        contains(ran.out, "    deactivated and activated at once, so still active: X1 (rule 5)\n"));
    CHECK(grafwire_with({"run", chart, stim, "--explain", "-o", csv}).out == ran.out);
    CHECK(text_of(csv) == grafwire_with({"run", chart, stim}).out);
    const Ran french = grafwire_with({"run", chart, stim, "--explain", "--lang", "fr"});
    CHECK(french.out.rfind("À 0 ms : toutes les entrées sont à 0\n", 0) == 0);
    // Without a stable situation the status is 1, in words as in a trace.
    const Ran unstable = grafwire_with({"run", axis, scan_stim, "--explain"});
    CHECK(unstable.status == 1);
    CHECK(contains(unstable.out, "  no stable situation: X0, X1, X2 keep changing\n"));
    const Ran both = grafwire_with({"run", chart, stim, "--explain", "-o", "-"});
    CHECK(both.status == 2);
    CHECK(both.out.empty());
}

TEST_CASE("a trace is a table at a terminal, and CSV anywhere else") {
    const std::string chart = example("single-sequence.grafcet");
    const std::string stim = example("single-sequence.stim");
    // A terminal whose width is not known.
    const auto at_terminal = [&](const std::string& command, const std::string& setting) {
        return run_program(
            {"python3", "-c", "import pty, sys; sys.exit(pty.spawn(sys.argv[1:]) >> 8)",
             GRAFWIRE_PROGRAM, command, chart, stim},
            {}, {"TERM=xterm", setting});
    };
    for (const std::string command : {"run", "simulate"}) {
        const Ran plain = at_terminal(command, "NO_COLOR=1");
        CHECK(plain.status == 0);
        CHECK(plain.out.rfind("time_ms  m  a  b  Init  AUdur  AUdoux  X0  X1  X2\r\n", 0) == 0);
        CHECK(!contains(plain.out, "\033"));
        CHECK(contains(at_terminal(command, "LANG=C").out, "\033[1mtime_ms  m "));
        CHECK(grafwire_with({command, chart, stim}).out.rfind("time_ms,m,a,b,", 0) == 0);
    }
}

TEST_CASE("run without stimuli: lines from standard input, without a prompt") {
    const ScratchFolder folder;
    const std::string chart = example("single-sequence.grafcet");
    const std::string stim = folder.path("typed.stim");
    const Ran ran = grafwire_with({"run", chart}, "m=1\n+100ms m=0\na=1\nsave " + stim + "\n");
    CHECK(ran.status == 0);
    CHECK(ran.err.empty());
    CHECK(ran.out.rfind("At 0 ms: m=1\n  initial situation: X0 (rule 1)\n", 0) == 0);
    CHECK(contains(ran.out, "\nAt 101 ms: a=1\n"));
    CHECK(contains(ran.out, "\nsaved: " + stim + "\n"));
    CHECK(text_of(stim) == "0s : m=1\n100ms : m=0\n101ms : a=1\n101ms : end\n");
    const Ran again = grafwire_with({"run", chart, stim, "--explain"});
    CHECK(again.out.rfind("At 0 ms: m=1\n  initial situation: X0 (rule 1)\n", 0) == 0);
    // What is refused is said and makes the request a bad one; the rest is done.
    const Ran refused = grafwire_with({"run", chart}, "m=2\nm=1\nsave " + chart + "\nquit\nm=0\n");
    CHECK(refused.status == 2);
    CHECK(refused.out.rfind("At 0 ms: m=1\n", 0) == 0);
    CHECK(!contains(refused.out, "saved"));
    CHECK(contains(refused.err, "grafwire: error: "));
    CHECK(grafwire_with({"run", chart}).status == 0);
    CHECK(grafwire_with({"run", chart, "--scan", "10ms"}, "scan\nscan").status == 0);
    CHECK(grafwire_with({"run", "-"}, text_of(chart)).status == 2);
}

TEST_CASE("a netlist that does not settle: status 1, and the trace up to there") {
    const ScratchFolder folder;
    // Two steps that are each other's follower, both receptivities at 1 from 5 ms on.
    const std::string chart =
        folder.file("loop.grafcet",
                    "input a\ngraph G {\n  initial 0\n  step 1\n  0 -> 1 : a\n  1 -> 0 : a\n}\n");
    const std::string stim = folder.file("loop.stim", "5ms : a=1\n9ms : end\n");
    const std::string csv = folder.path("out.csv");
    const Ran run = grafwire_with({"run", chart, stim});
    CHECK(run.status == 1);
    CHECK(read_csv(run.out).size() == 2);
    const Ran ran = grafwire_with({"simulate", chart, stim, "--style", "clocked", "-o", csv});
    CHECK(ran.status == 1);
    CHECK(contains(ran.err, "the netlist does not settle at 5 ms; these keep changing: "));
    CHECK(text_of(csv) == run.out);
}

TEST_CASE("waveforms") {
    const ScratchFolder folder;
    const std::string chart = example("manipulator.grafcet");
    const std::string stim = example("manipulator.stim");
    const Ran run = grafwire_with({"run", chart, stim, "--vcd", folder.path("run.vcd")});
    CHECK(run.status == 0);
    CHECK(run.out == grafwire_with({"run", chart, stim}).out);
    check_vcd(text_of(folder.path("run.vcd")));
    for (const std::string style : {"gates", "nand", "clocked"}) {
        INFO("style: " << style);
        const std::string vcd = folder.path(style + ".vcd");
        CHECK(grafwire_with({"simulate", chart, stim, "--style", style, "--vcd", vcd}).status == 0);
        check_vcd(text_of(vcd));
        const std::string again = folder.path("again.vcd");
        grafwire_with({"simulate", chart, stim, "--style", style, "--vcd", again});
        CHECK(text_of(again) == text_of(vcd));
    }
}

TEST_CASE("stimuli that break an assumption are worth a warning") {
    const ScratchFolder folder;
    const std::string chart = example("nine-steps.grafcet");
    const std::string stim = folder.file("s.stim", "0ms : m=1\n7ms : d1=1 d2=1\n9ms : end\n");
    for (const std::vector<std::string>& request : std::vector<std::vector<std::string>>{
             {"run", chart, stim}, {"simulate", chart, stim, "--style", "nand"}}) {
        const Ran ran = grafwire_with(request);
        CHECK(ran.status == 0);
        CHECK(read_csv(ran.out).size() == 4);
        CHECK(ran.err ==
              "grafwire: warning: at 7 ms the stimuli break what the GRAFCET assumes: "
              "/(d1.d2)\n");
    }
}

TEST_CASE("--modes off: the netlist starts in the initial situation and has no Init") {
    const std::string chart = example("manipulator.grafcet");
    const std::string blif =
        grafwire_with({"netlist", chart, "--style", "nand", "--modes", "off", "--to", "blif"}).out;
    CHECK(!contains(blif, " Init"));
    CHECK(!contains(blif, "AUd"));
    const ScratchFolder folder;
    const std::string stim = folder.file("s.stim", "0ms : v0=1 h0=1\n10ms : dcy=1\n20ms : end\n");
    for (const std::string style : {"gates", "nand", "clocked"}) {
        INFO("style: " << style);
        const Ran ran =
            grafwire_with({"simulate", chart, stim, "--style", style, "--modes", "off"});
        CHECK(ran.status == 0);
        CHECK(ran.out == grafwire_with({"run", chart, stim}).out);
    }
}

TEST_CASE("netlist --stim: a deck looks at the instants of the reference, or at the scans") {
    const std::string chart = example("rule-5.grafcet");
    const std::string stim = example("rule-5.stim");
    const auto samples = [&](const std::string& style, const std::string& period) {
        const ScratchFolder folder;
        std::vector<std::string> arguments{
            "netlist", chart,    "--style", style, "--to",
            "spice",   "--stim", stim,      "-o",  folder.path("deck.cir")};
        if (!period.empty()) arguments.insert(arguments.end(), {"--scan", period});
        const Ran made = grafwire_with(arguments);
        CHECK(made.status == 0);
        const std::string out = run_program({"ngspice", "-b", folder.path("deck.cir")}).out;
        // Rows in which the sampling node, the first, has come back to 0; there is one at the
        // start.
        std::size_t count = 0;
        std::istringstream lines(out.substr(out.find("Time or Step")));
        for (std::string line, moment, sample; std::getline(lines, line);) {
            std::istringstream words(line);
            if (words >> moment >> sample && sample == "0s") ++count;
        }
        return count - 1;
    };
    const std::string trace = grafwire_with({"run", chart, stim}).out;
    CHECK(samples("nand", "") == read_csv(trace).size() - 1);
    const std::string scans = grafwire_with({"run", chart, stim, "--scan", "40ms"}).out;
    CHECK(samples("clocked", "40ms") == read_csv(scans).size() - 1);
}

TEST_CASE("netlist --bench: a test bench beside the netlist that says PASS, or what is wrong") {
    const std::string chart = example("rule-5.grafcet");
    const std::string stim = example("rule-5.stim");
    const ScratchFolder folder;
    for (const std::string& style : choices_of("netlist", "--style")) {
        if (style == "handshake") continue;  // refuses a source on a level
        INFO("style: " << style);
        const Ran made = grafwire_with({"netlist", chart, "--style", style, "--to", "verilog",
                                        "--stim", stim, "--bench", "-o", folder.path("n.v")});
        CHECK(made.status == 0);
        CHECK(made.out.empty());
        CHECK(text_of(folder.path("n.v")) ==
              grafwire_with({"netlist", chart, "--style", style, "--to", "verilog"}).out);
        CHECK(run_program({"iverilog", "-o", folder.path("run"), folder.path("n_bench.v"),
                           folder.path("n.v")})
                  .status == 0);
        const Ran ran = run_program({"vvp", "-n", folder.path("run")});
        const std::string last = ran.out.substr(ran.out.rfind('\n', ran.out.size() - 2) + 1);
        INFO("its end: " << last);
        // Where deactivation wins, step 1 is lost.
        const bool is_lost = style == "nor";
        CHECK(ran.status == (is_lost ? 1 : 0));
        CHECK(last == (is_lost ? "X1 is 0, the reference gives 1\n" : "PASS\n"));
    }
}

TEST_CASE("netlist --bench: with gates of one's own the bench waits longer") {
    const ScratchFolder folder;
    CHECK(grafwire_with({"netlist", example("manipulator.grafcet"), "--style", "nand", "--to",
                         "verilog", "--stim", example("manipulator.stim"), "--bench", "-o",
                         folder.path("n.v")})
              .status == 0);
    for (const std::string gate : {"3", "4.5", "2000"}) {
        CAPTURE(gate);
        CHECK(run_program({"iverilog", "-Pgrafwire_bench.GATE_NS=" + gate, "-o", folder.path("run"),
                           folder.path("n_bench.v"), folder.path("n.v")})
                  .status == 0);
        const Ran ran = run_program({"vvp", "-n", folder.path("run")});
        CHECK(ran.status == 0);
        CHECK(ran.out.ends_with("\nPASS\n"));
    }
}

}  // namespace grafwire::testing
