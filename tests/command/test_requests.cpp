// Requests that cannot be carried out: exit status 2, a message that helps, nothing on standard
// output.

#include <doctest/doctest.h>

#include "support/run_program.h"

namespace grafwire::testing {

namespace {

const std::vector<std::string> commands{"info", "equations", "run", "netlist", "simulate", "check"};

/// The message of a request that is refused.
std::string refusal(const std::vector<std::string>& arguments, const std::string& input = {}) {
    const Ran ran = grafwire_with(arguments, input);
    INFO("standard error: " << ran.err);
    CHECK(ran.status == 2);
    CHECK(ran.out.empty());
    CHECK(!ran.err.empty());
    return ran.err;
}

}  // namespace

TEST_CASE("help tells what there is, and shows an example of every command") {
    const Ran help = grafwire_with({"--help"});
    CHECK(help.status == 0);
    CHECK(help.err.empty());
    for (const std::string& command : commands) {
        INFO("command: " << command);
        CHECK(contains(help.out, "\n  " + command + " "));
        const Ran ran = grafwire_with({command, "--help"});
        CHECK(ran.status == 0);
        CHECK(contains(ran.out, "Example: grafwire " + command + " examples/"));
    }
    CHECK(contains(help.out, "Exit status: 0 "));
}

TEST_CASE("help describes styles, formats and languages, in English and in French") {
    const std::string netlist = grafwire_with({"netlist", "--help"}).out;
    CHECK(contains(netlist, " nand: set-priority latches of NAND gates\n"));
    CHECK(contains(netlist, " output format\n"));
    CHECK(contains(netlist, " verilog: structural Verilog (IEEE 1364-2005)\n"));
    CHECK(contains(grafwire_with({"plc", "--help"}).out, " c: C99, and C++\n"));
    const std::string french = grafwire_with({"netlist", "--help", "--lang", "fr"}).out;
    CHECK(contains(french, " verilog\u00a0: Verilog structurel (IEEE 1364-2005)\n"));
    CHECK(contains(french, " nand\u00a0: bascules de portes NON-ET, priorité à\n"));
}

TEST_CASE("the example that help shows can be run as it stands") {
    for (const std::string& command : commands) {
        const std::string help = grafwire_with({command, "--help"}).out;
        const std::string mark = "Example: grafwire ";
        const std::size_t begin = help.find(mark) + mark.size();
        const std::string line = help.substr(begin);
        INFO("example: " << line);
        const ScratchFolder folder;
        const Ran ran = run_program({"sh", "-c",
                                     "cd '" + folder.path("") + "' && ln -s '" + example("") +
                                         "' examples && '" + GRAFWIRE_PROGRAM + "' " + line});
        CHECK(ran.status == 0);
        CHECK(ran.err.empty());
    }
}

TEST_CASE("the version") {
    const Ran ran = grafwire_with({"--version"});
    CHECK(ran.status == 0);
    CHECK(ran.out.rfind("grafwire ", 0) == 0);
}

TEST_CASE("an unknown command is refused with the nearest one and all of them") {
    CHECK(refusal({"chek", example("rule-5.grafcet")}) ==
          "grafwire: error: there is no command 'chek'; did you mean 'check'? "
          "(commands: info, equations, run, netlist, simulate, check, plc, s7, draw, report, fmt)\n"
          "'grafwire --help' shows what there is.\n");
    CHECK(contains(refusal({"sketch", example("rule-5.grafcet")}), "'sketch'"));
    CHECK(contains(refusal({}), "--help"));
}

TEST_CASE("no input makes messages without end") {
    constexpr std::size_t most = 100'000;
    const ScratchFolder folder;
    std::string inputs = "input i";
    std::string table;
    std::string ring = "input a\ngraph G { initial s0\n";
    for (int i = 0; i < 3'000; ++i) {
        const std::string number = std::to_string(i);
        inputs += ", some_name_of_an_input_" + number;
        table += "E" + number + ".9 = x\n";
        ring += "step s" + std::to_string(i + 1) + " s" + number + " -> s" + std::to_string(i + 1) +
                " : 1\n";
    }
    inputs += "\ngraph G { initial 0 step 1 0 -> 1 : i 1 -> 0 : /i }\n";
    ring += "s3000 -> s0 : 1 }\n";
    const std::string word(1'000'000, 'n');
    const std::string chart = example("rule-5.grafcet");
    const std::string stim = folder.file("a.stim", "0ms: a=1\n");
    for (const std::vector<std::string>& request : std::vector<std::vector<std::string>>{
             {"info", folder.file("inputs.grafcet", inputs)},
             {"plc", folder.path("inputs.grafcet"), "--to", "s7-200"},
             {"plc", chart, "--to", "s7-200", "--io", folder.file("a.io", table)},
             {"run", folder.file("ring.grafcet", ring), stim},
             {"check", chart, "--assume", std::string(100'000, '%')},
             {"check", chart, "--against", folder.file("a.blif", ".model m\n.names " + word)},
             {"check", chart, "--against", folder.file("b.blif", ".model m\n" + word)}}) {
        INFO("command: " << request[0] << ' ' << request[1]);
        const Ran ran = grafwire_with(request);
        CHECK(!ran.err.empty());
        CHECK(ran.err.size() < most);
    }
}

TEST_CASE("a bound is a whole number that can be one") {
    for (const std::string bound : {"-1", "18446744073709551616", "1.5", "+1", "1e3", "many", ""}) {
        INFO("bound: " << bound);
        CHECK(contains(
            refusal({"check", example("rule-5.grafcet"), "--style", "nand", "--max-cases", bound}),
            "is no whole number from 0"));
    }
    for (const std::string bound : {"0", "18446744073709551615"}) {
        const Ran ran = grafwire_with(
            {"check", example("rule-5.grafcet"), "--style", "nand", "--max-cases", bound});
        CHECK(ran.status == 0);
    }
    CHECK(contains(grafwire_with({"check", "--help"}).out, "(0: never)"));
}

TEST_CASE("an unknown option is refused with the nearest one") {
    CHECK(refusal({"check", example("rule-5.grafcet"), "--stile", "nand"}) ==
          "grafwire: error: there is no option '--stile'; did you mean '--style'?\n"
          "'grafwire check --help' shows what there is.\n");
    CHECK(contains(refusal({"info", example("rule-5.grafcet"), "--langue=fr"}),
                   "there is no option '--langue'; did you mean '--lang'?"));
    CHECK(contains(refusal({"draw", example("rule-5.grafcet"), "x.stim", "more"}), "'more'"));
}

TEST_CASE("unknown values are refused with those there are") {
    const std::string file = example("rule-5.grafcet");
    const std::string stim = example("rule-5.stim");
    std::string styles;
    for (const std::string& style : choices_of("netlist", "--style")) {
        styles += (styles.empty() ? "" : ",") + style;
    }
    CHECK(contains(refusal({"netlist", file, "--style", "nad", "--to", "blif"}),
                   "--style: nad not in {" + styles + "}"));
    CHECK(contains(refusal({"netlist", file, "--style", "nand", "--to", "bilf"}),
                   "there is no format 'bilf'; did you mean 'blif'?"));
    CHECK(contains(refusal({"netlist", file, "--style", "nand", "--to", "digital"}),
                   "there is no format 'digital'; there are: verilog, "));
    CHECK(contains(refusal({"check", file, "--against", "x.grafcet"}),
                   "a program an .awl (S7-200) or an .xml (PLCopen) file"));
    CHECK(contains(refusal({"equations", file, "--to", "cvs"}), "text,markdown,latex,csv,json"));
    CHECK(contains(refusal({"equations", file, "--cdx", "follower"}), "successor,transition"));
    CHECK(contains(refusal({"equations", file, "--modes", "maybe"}), "on,off"));
    CHECK(contains(refusal({"check", file, "--to", "xml"}), "text,json,junit"));
    CHECK(contains(refusal({"info", file, "--lang", "de"}), "en,fr"));
    CHECK(contains(refusal({"run", file, stim, "--scan", "soon"}), "'soon' is no period"));
    CHECK(contains(refusal({"run", file, stim, "--scan", "0ms"}), "'0ms' is no period"));
    CHECK(contains(refusal({"simulate", file, stim, "--style", "nand", "--scan", "10ms"}),
                   "clocked"));
    CHECK(contains(
        refusal({"netlist", file, "--style", "clocked", "--cdx", "successor", "--to", "blif"}),
        "transition form"));
}

TEST_CASE("what is missing is named") {
    CHECK(contains(refusal({"info"}), "FILE"));
    CHECK(contains(refusal({"simulate", example("rule-5.grafcet"), "--style", "nand"}), "STIM"));
    CHECK(contains(refusal({"netlist", example("rule-5.grafcet"), "--to", "blif"}), "--style"));
    CHECK(contains(refusal({"netlist", example("rule-5.grafcet"), "--style", "nand"}), "--to"));
}

TEST_CASE("files that cannot be read") {
    const ScratchFolder folder;
    for (const std::string command : {"info", "equations", "check"}) {
        CHECK(refusal({command, folder.path("none.grafcet")}) ==
              folder.path("none.grafcet") +
                  ": error: cannot read the file: No such file or directory\n");
    }
    CHECK(contains(refusal({"run", folder.path("")}), "directory"));
    CHECK(contains(refusal({"run", example("rule-5.grafcet"), folder.path("none.stim")}),
                   "none.stim"));
}

TEST_CASE("errors in the GRAFCET and in the stimuli, all of them, with their places") {
    const ScratchFolder folder;
    const std::string chart = folder.file("bad.grafcet",
                                          "input a\ngraph G {\n  initial 0\n  step 1\n"
                                          "  0 -> 1 : aa\n  1 -> 2 : a\n}\n");
    for (const std::string command : {"info", "equations", "check"}) {
        const std::string message = refusal({command, chart});
        CHECK(contains(message, chart + ":5:12: error: "));
        CHECK(contains(message, "did you mean 'a'?"));
        CHECK(contains(message, "  0 -> 1 : aa\n           ^\n"));
        CHECK(contains(message, chart + ":6:8: error: "));
    }
    const std::string stim = folder.file("bad.stim", "0ms : s=1\n+1ms : z=1\n0ms : end\n");
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"run"}, {"simulate", "--style", "nand"}}) {
        std::vector<std::string> arguments = command;
        arguments.insert(arguments.begin() + 1, {example("rule-5.grafcet"), stim});
        const std::string message = refusal(arguments);
        CHECK(contains(message, stim + ":2:8: error: "));
        CHECK(contains(message, stim + ":3:1: error: "));
    }
}

TEST_CASE("counters are too much for a style without registers") {
    for (const std::string& style : choices_of("netlist", "--style")) {
        if (style == "clocked") continue;
        const std::string message =
            refusal({"check", example("batch-counter.grafcet"), "--style", style});
        CHECK(contains(message, "counter 'n'"));
        CHECK(contains(message, "use --style clocked"));
    }
}

TEST_CASE("- is standard input, but only once") {
    const std::string chart = text_of(example("rule-5.grafcet"));
    const std::string stim = text_of(example("rule-5.stim"));
    const Ran expected = grafwire_with({"run", example("rule-5.grafcet"), example("rule-5.stim")});
    CHECK(grafwire_with({"run", "-", example("rule-5.stim")}, chart).out == expected.out);
    CHECK(grafwire_with({"run", example("rule-5.grafcet"), "-"}, stim).out == expected.out);
    CHECK(grafwire_with({"info", "-"}, chart).out ==
          grafwire_with({"info", example("rule-5.grafcet")}).out);
    CHECK(contains(refusal({"info", "-"}, "graph {"), "<stdin>:1:7: error: "));
    CHECK(contains(refusal({"run", "-", "-"}, chart), "both"));
    CHECK(contains(refusal({"simulate", "-", "-", "--style", "nand"}, chart), "both"));
}

}  // namespace grafwire::testing
