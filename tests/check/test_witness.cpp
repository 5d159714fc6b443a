#include "check/netlist_witness.h"
#include "check/partial_inputs.h"
#include "check/path.h"
#include "check/witness.h"
#include "evolution/run.h"
#include "support/small_netlists.h"
#include "trace/input_values.h"
#include "trace/stimuli.h"

namespace grafwire::testing {

namespace {

constexpr PartialInput o = PartialInput::zero;
constexpr PartialInput i = PartialInput::one;
constexpr PartialInput x = PartialInput::unassigned;

const Grafcet one_input = grafcet_of("input a graph G { initial 0 }");
const PartialInputs low{o, o, o, o};
const PartialInputs high{i, o, o, o};

/// An instant at which nothing but delays ends.
PathStep ends(const std::vector<RunningDelay>& running) {
    PathStep step{low, low, {}, running};
    for (std::uint32_t k = 0; k < running.size(); ++k) {
        if (running[k].ends) step.ended.conditions.push_back(k);
    }
    return step;
}

std::string timed(const std::vector<PathStep>& path, Time gap = 100 * millisecond) {
    const auto stimuli = stimuli_for(one_input, Assumptions(one_input), path, gap);
    if (!stimuli) return "impossible";
    return write_stimuli(*stimuli, one_input);
}

}  // namespace

TEST_CASE("a path becomes stimuli with the lengths of the delays") {
    // Start; a; 3 s are over; 1 s is over; a back to 0.
    CHECK(timed({{low, low, {}, {}},
                 {low, high, {}, {}},
                 {high, high, {{0}, {}}, {{1, 3 * second, true}}},
                 {high, high, {{1}, {}}, {{2, second, true}}},
                 {high, low, {}, {}}}) == "0s :\n100ms : a=1\n4.2s : a=0\n4.2s : end\n");
}

TEST_CASE("a delay that is not to end yet leaves no more time than it takes") {
    // a goes down while the 3 s are still running: 100 ms later.
    CHECK(timed({{high, high, {}, {}}, {high, low, {}, {{0, 3 * second, false}}}}) ==
          "0s : a=1\n100ms : a=0\n100ms : end\n");
}

TEST_CASE("delays in an order that their lengths do not allow have no stimuli") {
    const PathStep start{low, low, {}, {}};
    const auto both = [](bool first, bool second_one) {
        return ends({{0, second, first}, {0, 5 * second, second_one}});
    };
    CHECK(timed({start, both(true, false)}) == "0s :\n1s : end\n");
    CHECK(timed({start, both(false, true)}) == "impossible");
    CHECK(timed({start, both(true, true)}) == "impossible");
    CHECK(timed({start, both(false, false)}) == "0s :\n100ms :\n100ms : end\n");
}

TEST_CASE("the last gap that is tried is small enough for any path that is possible") {
    // Ten changes within a delay of 5 us: with gaps of less than half a microsecond only.
    std::vector<PathStep> path{{low, low, {}, {}}};
    for (std::size_t k = 0; k < 10; ++k) {
        const bool up = k % 2 == 0;
        path.push_back({up ? low : high, up ? high : low, {}, {{0, 5 * microsecond, false}}});
    }
    path.push_back(ends({{0, 5 * microsecond, true}}));
    const std::vector<Time> gaps = gaps_for(path);
    CHECK(timed(path, gaps.front()) == "impossible");
    CHECK(timed(path, microsecond) == "impossible");
    CHECK(timed(path, gaps.back()) != "impossible");
    CHECK(gaps.back() == 100 * nanosecond);
}

TEST_CASE("open inputs are given values that the plant allows") {
    const Grafcet grafcet = grafcet_of(R"(
input a, b, c
assume /(a . b)
assume a + c
graph G { initial 0 0 -> 0 : a . b . c }
)");
    const Assumptions assumptions(grafcet);
    CHECK(assumptions.can_hold({x, x, x, x, x, x}));
    CHECK(assumptions.can_hold({i, x, x, o, o, o}));
    CHECK_FALSE(assumptions.can_hold({i, i, x, o, o, o}));
    CHECK_FALSE(assumptions.can_hold({o, x, o, o, o, o}));
    CHECK_FALSE(assumptions.can_hold({x, i, o, o, o, o}));

    const InputValues preferred{1, 1, 0, 1, 0, 1};
    const InputValues completed{1, 0, 0, 1, 0, 1};
    CHECK(assumptions.complete({x, x, x, x, x, x}, preferred) == completed);
    const InputValues with_b{0, 1, 1, 1, 0, 1};
    CHECK(assumptions.complete({x, i, x, x, x, x}, preferred) == with_b);
    CHECK_FALSE(assumptions.complete({i, i, x, x, x, x}, preferred));
}

TEST_CASE("a replay shows a difference where there is one, and only there") {
    const std::string head = "input a output lamp graph G { initial 0 : lamp if ";
    const Grafcet grafcet = grafcet_of(head + "a }");
    const Netlist right = netlist_of(grafcet, Style::gates);
    const Netlist wrong = netlist_of(grafcet_of(head + "/a }"), Style::gates);
    const auto stimuli = read_stimuli("0s : a=1\n1s : a=0\n5s : end\n", grafcet);
    REQUIRE(stimuli);
    CHECK_FALSE(replay(grafcet, right, cell_delays(right, {}), *stimuli, 0));
    const auto witness = replay(grafcet, wrong, cell_delays(wrong, {}), *stimuli, 0);
    REQUIRE(witness);
    CHECK(witness->kind == DifferenceKind::output);
    CHECK(witness->scan_period == 0);
    // Cut at the first difference.
    CHECK(write_stimuli(witness->stimuli, grafcet) == "0s : a=1\n0s : end\n");
    REQUIRE(witness->values.size() == 2);
    CHECK(witness->values[0].name == "X0");
    CHECK(witness->values[0].got == Logic::one);
    CHECK(witness->values[1].name == "lamp");
    CHECK(witness->values[1].expected == Logic::one);
    CHECK(witness->values[1].got == Logic::zero);
}

TEST_CASE("rows are compared by their moments, where a side has instants of its own") {
    // The netlist's delay is shorter; the reference has no instant at its end.
    const std::string tail = "/X0 } ";
    const std::string head = "input a output lamp graph G { initial 0 : lamp if ";
    const Grafcet grafcet = grafcet_of(head + "3s" + tail);
    const Netlist hasty = netlist_of(grafcet_of(head + "1s" + tail), Style::gates);
    const auto stimuli = read_stimuli("0s :\n10s : end\n", grafcet);
    REQUIRE(stimuli);
    const auto witness = replay(grafcet, hasty, cell_delays(hasty, {}), *stimuli, 0);
    REQUIRE(witness);
    CHECK(write_stimuli(witness->stimuli, grafcet) == "0s :\n1s : end\n");
    CHECK(witness->values[1].expected == Logic::zero);
    CHECK(witness->values[1].got == Logic::one);
    // With another delay that makes no difference, only the instants differ.
    const Netlist busy = netlist_of(grafcet_of(head + "3s/X0 . (1s/X0 + X0)" + "}"), Style::gates);
    CHECK_FALSE(replay(grafcet, busy, cell_delays(busy, {}), *stimuli, 0));
}

TEST_CASE("where the netlist does not settle, the reference's values are those of that instant") {
    const Grafcet grafcet = grafcet_of("input a output lamp graph G { initial 0 : lamp if a }");
    const auto stimuli = read_stimuli("0s : a=1\n1s : a=0\n5s : end\n", grafcet);
    REQUIRE(stimuli);
    const RunResult expected = run_until_stable(grafcet, *stimuli);
    const auto lamp_at = [&](Time unsettled) {
        const auto witness =
            first_difference(grafcet, *stimuli, expected, expected.trace, unsettled);
        REQUIRE(witness);
        CHECK(witness->kind == DifferenceKind::oscillation);
        CHECK(witness->stimuli.end == unsettled);
        return witness->values[1].expected;
    };
    CHECK(lamp_at(0) == Logic::one);
    CHECK(lamp_at(1000 * millisecond) == Logic::zero);
    CHECK(lamp_at(5000 * millisecond) == Logic::zero);
}

TEST_CASE("of a witness all is left out that can be") {
    // The lamp of step 1 stays dark.
    const Grafcet grafcet = grafcet_of(R"(
input a, b, c
output lamp
assume /(a . c)
graph G { initial 0 step 1 : lamp
  0 -> 1 : a . b }
)");
    Netlist netlist = netlist_of(grafcet, Style::nand, false);
    for (Cell& cell : netlist.cells) {
        if (netlist.names[cell.output] != "lamp") continue;
        cell.type = CellType::low;
        cell.pin_count = 0;
    }
    const CellDelays delays = cell_delays(netlist, {});
    const auto smallest = [&](const std::string& text) {
        const auto stimuli = read_stimuli(text, grafcet);
        REQUIRE(stimuli);
        const auto witness = replay(grafcet, netlist, delays, *stimuli, 0);
        REQUIRE(witness);
        const Witness small = smallest_witness(grafcet, netlist, *witness, {});
        CHECK(small.kind == DifferenceKind::output);
        return write_stimuli(small.stimuli, grafcet);
    };
    // c goes, and b need not fall and rise again; no line is left without a change.
    CHECK(smallest("0s : c=1\n1s : b=1\n2s : b=0\n3s : c=0\n4s : a=1\n5s : b=1\n9s : end\n") ==
          "0s :\n1s : b=1\n4s : a=1\n4s : end\n");
    CHECK(smallest("0s : a=1 b=1\n1s : end\n") == "0s : a=1 b=1\n0s : end\n");
}

}  // namespace grafwire::testing
