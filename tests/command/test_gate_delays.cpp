// Gates that take times of their own, from a file.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command/charts.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

/// At 300 ms m rises: X1$set0 falls, X1 rises, X0$reset0 falls, X0$q rises, X0 falls.
constexpr std::string_view slow_gates = R"(
X1$set0  2 3           # rise, fall
at 300ms + 5
X0$q     4
at 1s
X0       900
)";

/// `grafwire simulate` of the sequence, with a file of delays that holds this.
Ran simulate_with(const std::string& delays, const std::vector<std::string>& more) {
    const ScratchFolder folder;
    folder.file("gates.delays", delays);
    std::vector<std::string> request = {"simulate", sequence_chart, sequence_stimuli, "--delays",
                                        folder.path("gates.delays")};
    request.insert(request.end(), more.begin(), more.end());
    return grafwire_with(request);
}

}  // namespace

TEST_CASE("delays of single gates show in an instant") {
    const Ran ran = simulate_with(std::string(slow_gates),
                                  {"--style", "nand", "--zoom", "300ms", "--to", "wavedrom"});
    CHECK(ran.status == 0);
    const auto json = nlohmann::json::parse(ran.out);
    const std::vector<std::string> times = json["signal"][0]["data"];
    CHECK(times == std::vector<std::string>{"before", "0ns", "3ns", "4ns", "5ns", "9ns", "10ns",
                                            "11ns", "12ns"});
    // As many causes as under equal delays: each is found by the delay that was in force.
    CHECK(json["edge"].size() == 8);
}

TEST_CASE("delays of single gates are told in words") {
    const Ran ran = simulate_with(std::string(slow_gates), {"--style", "nand", "--explain"});
    CHECK(ran.status == 0);
    CHECK(contains(ran.out,
                   "  X1 becomes 1 after 4 ns: m=1, NAND gate X1$set0=0 (+3 ns)\n"
                   "  X0 becomes 0 after 10 ns: X1=1, NAND gate X0$reset0=0 (+5 ns), NAND gate\n"
                   "      X0$q=1 (+9 ns)\n"));
}

TEST_CASE("delays of single gates are in the waveform") {
    const ScratchFolder folder;
    folder.file("gates.delays", "X1 2500ps\n");
    const std::string vcd = folder.path("out.vcd");
    const Ran ran = grafwire_with({"simulate", sequence_chart, sequence_stimuli, "--delays",
                                   folder.path("gates.delays"), "--style", "nand", "--vcd", vcd});
    CHECK(ran.status == 0);
    const std::string text = text_of(vcd);
    CHECK(contains(text, "1 ps"));
    CHECK(contains(text, "\n#300000003500\n"));
}

TEST_CASE("a netlist from a file takes delays by the names of its nets") {
    const ScratchFolder folder;
    const std::string blif = folder.path("a.blif");
    CHECK(grafwire_with({"netlist", sequence_chart, "--style", "nand", "--to", "blif", "-o", blif})
              .status == 0);
    const Ran ran = simulate_with("X1 5\n", {"--against", blif, "--explain"});
    CHECK(ran.status == 0);
    CHECK(contains(ran.out, "X1 becomes 1 after 6 ns"));
}

TEST_CASE("a slow gate can break a wiring that is right with equal delays") {
    const std::vector<std::string> nand = {"--style", "nand"};
    const Ran right = simulate_with("", nand);
    CHECK(right.status == 0);
    CHECK(right.out ==
          grafwire_with({"simulate", sequence_chart, sequence_stimuli, "--style", "nand"}).out);
    // X0 is off before the latch of X1 holds: no step is left.
    const Ran wrong = simulate_with("X1$q 1 20\n", nand);
    CHECK(wrong.status == 0);
    CHECK(contains(right.out, "\n300,1,0,0,0,0,0,0,1,0\n"));
    CHECK(contains(wrong.out, "\n300,1,0,0,0,0,0,0,0,0\n"));
}

TEST_CASE("mistakes in a file of delays are shown at their place") {
    const Ran ran = simulate_with("X1$sat0 3\n", {"--style", "nand"});
    CHECK(ran.status == 2);
    CHECK(ran.out.empty());
    CHECK(contains(ran.err,
                   "gates.delays:1:1: error: the netlist has no net 'X1$sat0'; did you "
                   "mean 'X1$set0'?"));
    const Ran clocked = simulate_with("X1 3\n", {"--style", "clocked"});
    CHECK(clocked.status == 2);
    CHECK(contains(clocked.err, "--delays has no effect here: it is for netlists without a clock"));
    const Ran missing = grafwire_with({"simulate", sequence_chart, sequence_stimuli, "--style",
                                       "nand", "--delays", "no-such.delays"});
    CHECK(missing.status == 2);
}

TEST_CASE("delays come from standard input where nothing else does") {
    const std::vector<std::string> request = {
        "simulate", sequence_chart, sequence_stimuli, "--style",
        "nand",     "--explain",    "--delays",       "-"};
    CHECK(contains(grafwire_with(request, "X1 5\n").out, "X1 becomes 1 after 6 ns"));
    const Ran both =
        grafwire_with({"simulate", "-", sequence_stimuli, "--style", "nand", "--delays", "-"});
    CHECK(both.status == 2);
    CHECK(contains(both.err, "the delays cannot come from standard input"));
}

}  // namespace grafwire::testing
