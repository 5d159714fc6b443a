// Clocked netlists, judged scan by scan: inputs that change within an evolution, every scan period
// or one, and netlists that find their initial situation or not.

#include <doctest/doctest.h>

#include "check/check_equivalence.h"
#include "check/netlist_witness.h"
#include "check/path.h"
#include "netlist_from_blif.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

CheckResult check_at(const Grafcet& grafcet, const Netlist& netlist, Time period = 0) {
    CheckOptions options;
    if (period != 0) options.scan_period = period;
    return check_equivalence(grafcet, netlist, options);
}

}  // namespace

TEST_CASE("an input that changes between two scans of one evolution") {
    // With s held the token circles between 1 and 2 and there is no stable situation; 3 is reached
    // only if s falls in time. The netlist has no step 3.
    const Grafcet grafcet = grafcet_of(R"(
input s
output far
graph G { initial 1 step 2 step 3 : far
  1 -> 2 : s
  2 -> 1 : s
  2 -> 3 : /s }
)");
    Netlist blind = netlist_of(grafcet, Style::clocked);
    for (Cell& cell : blind.cells) {
        const std::string_view name = blind.names[cell.output];
        if (name != "far" && name != "X3") continue;
        cell.type = CellType::low;
        cell.pin_count = 0;
    }
    REQUIRE(fault_of(blind) == "");
    const CheckResult result = check_at(grafcet, blind);
    CHECK(result.verdict == Verdict::different);
    REQUIRE(result.witness);
    CHECK(result.witness->scan_period == 10 * millisecond);
    CHECK(write_stimuli(result.witness->stimuli, grafcet) == "0s : s=1\n10ms : s=0\n10ms : end\n");
    CHECK(result.coverage.unstable == 0);
    CHECK(check_at(grafcet, netlist_of(grafcet, Style::clocked)).verdict == Verdict::equivalent);
}

TEST_CASE("delays that end in one scan, since the period is longer than what separates them") {
    const std::string head = "output lamp graph G { initial 0 : lamp if ";
    const Grafcet grafcet = grafcet_of(head + "10ms/X0 . /(20ms/X0) }");
    const Netlist right = netlist_of(grafcet, Style::clocked);
    CHECK(check_at(grafcet, right).verdict == Verdict::equivalent);
    // Wrong for every period but those that let both end in one scan.
    const Netlist dark = netlist_of(grafcet_of(head + "10ms/X0 . /(10ms/X0) }"), Style::clocked);
    CHECK(check_at(grafcet, dark, 20 * millisecond).verdict == Verdict::equivalent);
    CHECK(check_at(grafcet, dark, 50 * millisecond).verdict == Verdict::equivalent);
    for (const Time period : {Time{0}, 10 * millisecond, 19 * millisecond}) {
        const CheckResult result = check_at(grafcet, dark, period);
        CHECK(result.verdict == Verdict::different);
        REQUIRE(result.witness);
        CHECK(result.witness->scan_period < 20 * millisecond);
        if (period != 0) CHECK(result.witness->scan_period == period);
    }
}

TEST_CASE("a netlist that counts its scans is right for one period") {
    // The lamp comes with the third scan, counted in two flip-flops: a delay of two periods.
    const Grafcet grafcet = grafcet_of("output lamp graph G { initial 0 : lamp if 20ms/X0 }");
    const Netlist counting = blif(grafcet, R"(
.model m
.inputs clk
.outputs X0 lamp
.names X0
1
.names first
1
.latch first one re clk 0
.latch one two re clk 0
.latch two lamp re clk 0
.end
)");
    CHECK(check_at(grafcet, counting, 10 * millisecond).verdict == Verdict::equivalent);
    const CheckResult slower = check_at(grafcet, counting, 20 * millisecond);
    CHECK(slower.verdict == Verdict::different);
    CHECK(slower.witness->scan_period == 20 * millisecond);
    const CheckResult any = check_at(grafcet, counting);
    CHECK(any.verdict == Verdict::different);
    CHECK(any.witness->scan_period != 10 * millisecond);
}

TEST_CASE("the period of a path of scans") {
    const Grafcet grafcet = grafcet_of("input a graph G { initial 1 1 -> 1 : a }");
    const Assumptions assumptions(grafcet);
    const PartialInputs open(4, PartialInput::zero);
    // Begun at scan 0: 30 ms are over by scan 2 and not by scan 1; 100 ms are not over by scan 2.
    const std::vector<PathStep> path{
        {open, open, {}, {}},
        {open, open, {}, {{0, 30 * millisecond, false}, {0, 100 * millisecond, false}}},
        {open, open, {}, {{0, 30 * millisecond, true}, {0, 100 * millisecond, false}}}};
    const auto scans = scans_for(grafcet, assumptions, path, 0);
    REQUIRE(scans);
    CHECK(scans->period == 20 * millisecond);
    CHECK(scans->stimuli.end == 40 * millisecond);
    CHECK(scans_for(grafcet, assumptions, path, 15 * millisecond));
    CHECK_FALSE(scans_for(grafcet, assumptions, path, 14 * millisecond));
    CHECK_FALSE(scans_for(grafcet, assumptions, path, 30 * millisecond));
    // A delay that ends in the scan after, beside a shorter one that does not.
    const std::vector<PathStep> never{
        {open, open, {}, {}},
        {open, open, {}, {{0, 30 * millisecond, false}, {0, 40 * millisecond, true}}}};
    CHECK_FALSE(scans_for(grafcet, assumptions, never, 0));
}

TEST_CASE("a netlist without Init has to find its initial situation") {
    const Grafcet grafcet = grafcet_of(R"(
input s, r
output lamp
graph G { initial 1 step 2 : lamp
  1 -> 2 : s . /r
  2 -> 1 : r . /s }
)");
    // X2 = s./r + X2.s + X2./r: without a glitch as long as one input changes at a time.
    const std::string memory = R"(
.model m
.inputs s r
.outputs X1 X2 lamp
.names s r X2 next
10- 1
1-1 1
-01 1
.names next X2
1 1
.names X2 X1
0 1
.names X2 lamp
1 1
.end
)";
    CHECK(check_at(grafcet, blif(grafcet, memory)).verdict == Verdict::equivalent);
    const CheckResult powered = check_at(grafcet, blif(grafcet, memory, false));
    CHECK(powered.verdict == Verdict::different);
    REQUIRE(powered.witness);
    CHECK(powered.witness->kind == DifferenceKind::power_up);
    CHECK(powered.witness->stimuli.end == 0);
}

TEST_CASE("a memory that powers up either way and makes no difference is none") {
    // lamp = a.q + a./q: unknown in three values, a in two.
    const Grafcet grafcet = grafcet_of("input a output lamp graph G { initial 1 : lamp if a }");
    const std::string head =
        ".model m\n.inputs a\n.outputs X1 lamp\n.names X1\n1\n.names q q\n1 1\n";
    const Netlist either = blif(grafcet, head + ".names a q lamp\n11 1\n10 1\n.end\n", false);
    CHECK(check_at(grafcet, either).verdict == Verdict::equivalent);
    const Netlist one_way = blif(grafcet, head + ".names a q lamp\n11 1\n.end\n", false);
    const CheckResult result = check_at(grafcet, one_way);
    CHECK(result.verdict == Verdict::different);
    CHECK(result.witness->kind == DifferenceKind::power_up);
}

TEST_CASE("a ring that runs before the edge of the clock, and rests after it") {
    // Step 0 is left at every scan and entered while a is 0: a rises while it is active, and the
    // edge stops what that sets going.
    const Grafcet grafcet = grafcet_of(R"(
input a
output lamp
graph G { initial 0 : lamp if a step 1
  0 -> 1 : 1
  1 -> 0 : /a }
)");
    const std::string head = R"(
.model m
.inputs a clk
.outputs X0 X1 lamp
.names X1 a d0
10 1
.names d0 d1
0 1
.latch d0 X0 re clk 1
.latch d1 X1 re clk 0
)";
    const std::string rest = ".names X0 a lamp\n11 1\n.end\n";
    CHECK(check_at(grafcet, blif(grafcet, head + rest)).verdict == Verdict::equivalent);
    const std::string ring = ".names X0 a lamp ring\n111 0\n.names X0 a ring lamp\n111 1\n.end\n";
    const CheckResult result = check_at(grafcet, blif(grafcet, head + ring));
    CHECK(result.verdict == Verdict::different);
    REQUIRE(result.witness);
    CHECK(result.witness->kind == DifferenceKind::oscillation);
}

TEST_CASE("what no case exercises is listed") {
    const Grafcet grafcet = grafcet_of(R"(
input a, b
output lamp, dark
assume /b
graph G { initial 0 : lamp step 1 step 2 : dark
  (go) 0 -> 1 : a
  (back) 1 -> 0 : /a
  (off) 1 -> 2 : b }
)");
    for (const Style style : {Style::nand, Style::clocked}) {
        const CheckResult result = check_at(grafcet, netlist_of(grafcet, style));
        CHECK(result.never.steps == std::vector<StepId>{StepId{2}});
        CHECK(result.never.transitions == std::vector<TransitionId>{TransitionId{2}});
        CHECK(result.never.inputs == std::vector<std::uint32_t>{1});
        CHECK(result.never.outputs == std::vector<OutputId>{OutputId{1}});
    }
}

TEST_CASE("what neither an X nor an output depends on does not multiply the states") {
    const std::string chart = R"(
input a, b
output lamp
counter n : 0..60000
var v
graph G { initial 0 step 1 : lamp, n := n + 1, set v
  0 -> 1 : a . b
  1 -> 0 : /a }
)";
    const Grafcet grafcet = grafcet_of(chart);
    const CheckResult result = check_at(grafcet, netlist_of(grafcet, Style::clocked));
    CHECK(result.verdict == Verdict::equivalent);
    CHECK(result.coverage.cases < 100);
    // Once the counter is read it counts.
    std::string read = chart;
    read.replace(read.find(": lamp,"), 7, ": lamp if [n < 3],");
    const Grafcet reading = grafcet_of(read);
    CheckOptions options;
    options.max_cases = 1000;
    const Netlist netlist = netlist_of(reading, Style::clocked);
    CHECK(check_equivalence(reading, netlist, options).verdict == Verdict::undecided);
}

TEST_CASE("an oscillation in a part that nothing reads") {
    const Grafcet grafcet = grafcet_of("input a output lamp graph G { initial 1 : lamp if a }");
    const std::string head = R"(
.model m
.inputs a
.outputs X1 lamp
.names X1
1
.names a lamp
1 1
)";
    const CheckResult ring =
        check_at(grafcet, blif(grafcet, head + ".names ring ring\n0 1\n.end\n"));
    CHECK(ring.verdict == Verdict::different);
    REQUIRE(ring.witness);
    CHECK(ring.witness->kind == DifferenceKind::oscillation);
    // Only while a is 1, which nothing else reads; and one that rests.
    const CheckResult gated =
        check_at(grafcet, blif(grafcet, head + ".names a ring ring\n11 0\n.end\n"));
    CHECK(gated.verdict == Verdict::different);
    CHECK(check_at(grafcet, blif(grafcet, head + ".names a rest rest\n11 1\n.end\n")).verdict ==
          Verdict::equivalent);
}

}  // namespace grafwire::testing
