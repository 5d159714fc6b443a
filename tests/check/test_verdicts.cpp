#include "check/check_equivalence.h"
#include "check/netlist_witness.h"
#include "support/small_netlists.h"
#include "trace/stimuli.h"

namespace grafwire::testing {

namespace {

CheckResult verdict_within(const Grafcet& grafcet, const Netlist& netlist,
                           std::uint64_t max_cases = 0) {
    CheckOptions options;
    options.max_cases = max_cases;
    return check_equivalence(grafcet, netlist, options);
}

CheckResult verdict_within(const Grafcet& grafcet, Style style) {
    return verdict_within(grafcet, netlist_of(grafcet, style));
}

const Witness::Value& value_of(const Witness& witness, const std::string& name) {
    for (const Witness::Value& value : witness.values) {
        if (value.name == name) return value;
    }
    FAIL("no value of " << name);
    return witness.values[0];
}

std::string stimuli_of(const CheckResult& result, const Grafcet& grafcet) {
    REQUIRE(result.witness);
    return write_stimuli(result.witness->stimuli, grafcet);
}

const std::string two_steps = R"(
input a, b
graph G { initial 0 step 1
  0 -> 1 : a
  1 -> 0 : b }
)";

const std::string rule_5 = R"(
input s, k
graph G { step 1 initial 2
  -> 1 : s
  1 -> 2 : 1
  2 -> : k }
)";

const std::string three_steps = R"(
input m, a, b
graph G { initial 0 step 1 step 2
  0 -> 1 : m
  1 -> 2 : a
  2 -> 0 : b }
)";

}  // namespace

TEST_CASE("a loop of two steps oscillates in gates and holds in NAND latches") {
    const Grafcet grafcet = grafcet_of(two_steps);
    const CheckResult gates = verdict_within(grafcet, Style::gates);
    CHECK(gates.verdict == Verdict::different);
    REQUIRE(gates.witness);
    CHECK(gates.witness->kind == DifferenceKind::oscillation);
    const Netlist netlist = netlist_of(grafcet, Style::gates);
    CHECK(replay(grafcet, netlist, cell_delays(netlist, {}), gates.witness->stimuli, 0));

    const CheckResult nand = verdict_within(grafcet, Style::nand);
    CHECK(nand.verdict == Verdict::equivalent);
    CHECK(nand.complete);
    CHECK_FALSE(nand.witness);
}

TEST_CASE("rule 5 is lost in NOR latches and kept in NAND latches and flip-flops") {
    const Grafcet grafcet = grafcet_of(rule_5);
    const CheckResult nor = verdict_within(grafcet, Style::nor);
    CHECK(nor.verdict == Verdict::different);
    REQUIRE(nor.witness);
    CHECK(nor.witness->kind == DifferenceKind::situation);
    CHECK(value_of(*nor.witness, "X1").expected == Logic::one);
    CHECK(value_of(*nor.witness, "X1").got == Logic::zero);
    CHECK(verdict_within(grafcet, Style::nand).verdict == Verdict::equivalent);
    CHECK(verdict_within(grafcet, Style::clocked).verdict == Verdict::equivalent);
}

TEST_CASE("a plain sequence is equivalent in every style, and its circling is counted") {
    const Grafcet grafcet = grafcet_of(three_steps);
    for (const StyleRow& row : style_table) {
        const CheckResult result = verdict_within(grafcet, row.style);
        CHECK(result.verdict == Verdict::equivalent);
        CHECK(result.complete);
        // Each of the three steps, and none while AUdur is 1.
        CHECK(result.coverage.situations == 4);
        CHECK(result.coverage.waiting == 0);
        if (row.style == Style::clocked) {
            // Scan by scan there is always something to compare.
            CHECK(result.coverage.unstable == 0);
            continue;
        }
        // With m, a and b at 1 the token goes round for ever.
        CHECK(result.coverage.unstable > 0);
        CHECK(result.coverage.unstable < result.coverage.cases);
        REQUIRE(result.first_unstable);
        const std::vector<std::string> all{"X0", "X1", "X2"};
        CHECK(result.first_unstable->changing == all);
        CHECK(write_stimuli(result.first_unstable->stimuli, grafcet).find("m=1 a=1 b=1") !=
              std::string::npos);
    }
}

TEST_CASE("a bound on the cases leaves the check undecided") {
    const Grafcet grafcet = grafcet_of(three_steps);
    const Netlist netlist = netlist_of(grafcet, Style::nand);
    const CheckResult result = verdict_within(grafcet, netlist, 10);
    CHECK(result.verdict == Verdict::undecided);
    CHECK_FALSE(result.complete);
    CHECK(result.coverage.cases == 10);
    CHECK(result.coverage.waiting > 0);

    // The caller is asked every now and then.
    const Grafcet large = grafcet_of(R"(
input a, b, c, d, e, f
graph G { initial 0 step 1
  0 -> 1 : ↑a . ↑b
  1 -> 0 : ↑c . ↑d . ↑e . ↑f }
)");
    const Netlist of_large = netlist_of(large, Style::clocked);
    CheckOptions options;
    std::size_t asked = 0;
    std::uint64_t cases = 0;
    options.progress = [&](const Coverage& coverage) { cases = coverage.cases; };
    options.keep_going = [&] {
        ++asked;
        return cases < 64;
    };
    const CheckResult stopped = check_equivalence(large, of_large, options);
    CHECK(stopped.verdict == Verdict::undecided);
    CHECK(asked == 4);
    CHECK(stopped.coverage.cases == 64);
}

TEST_CASE("the shortest way to a difference, as stimuli") {
    // The netlist takes b for a in the second transition.
    const Grafcet grafcet = grafcet_of(three_steps);
    const Grafcet other = grafcet_of(R"(
input m, a, b
graph G { initial 0 step 1 step 2
  0 -> 1 : m
  1 -> 2 : b
  2 -> 0 : b }
)");
    const Netlist netlist = netlist_of(other, Style::nand, false);
    const CheckResult result = verdict_within(grafcet, netlist);
    CHECK(result.verdict == Verdict::different);
    CHECK(result.witness->kind == DifferenceKind::situation);
    const auto stimuli = read_stimuli(stimuli_of(result, grafcet), grafcet);
    REQUIRE(stimuli);
    // From the start one instant is enough: m, and a or b with it.
    CHECK(stimuli->changes.size() <= 2);
    CHECK(stimuli->end <= 100 * millisecond);
    CHECK(value_of(*result.witness, "X2").expected != value_of(*result.witness, "X2").got);
}

TEST_CASE("a difference that the plant rules out is none") {
    const std::string chart = R"(
graph G { initial 0 : lamp if a . b }
)";
    const std::string wrong_chart = R"(
graph G { initial 0 : lamp if a . /a }
)";
    const std::string head = "input a, b output lamp ";
    const Grafcet free = grafcet_of(head + chart);
    const Grafcet bound = grafcet_of(head + "assume /(a . b)" + chart);
    const Netlist wrong = netlist_of(grafcet_of(head + wrong_chart), Style::gates);
    const CheckResult result = verdict_within(free, wrong);
    CHECK(result.verdict == Verdict::different);
    REQUIRE(result.witness);
    CHECK(result.witness->kind == DifferenceKind::output);
    CHECK(stimuli_of(result, free).find("a=1 b=1") != std::string::npos);
    const CheckResult within = verdict_within(bound, wrong);
    CHECK(within.verdict == Verdict::equivalent);
    CHECK(within.complete);
}

TEST_CASE("a netlist that reads an input where the GRAFCET does not is found out") {
    const std::string head = "input a, b output lamp ";
    const Grafcet grafcet = grafcet_of(head + "graph G { initial 0 : lamp step 1 0 -> 1 : a }");
    SUBCASE("at once") {
        const Grafcet other =
            grafcet_of(head + "graph G { initial 0 : lamp if /b step 1 0 -> 1 : a }");
        for (const StyleRow& row : style_table) {
            const CheckResult result = verdict_within(grafcet, netlist_of(other, row.style));
            CHECK(result.verdict == Verdict::different);
            CHECK(result.witness->kind == DifferenceKind::output);
            CHECK(stimuli_of(result, grafcet).find("b=1") != std::string::npos);
        }
    }
    SUBCASE("after it has remembered it") {
        // The lamp goes out for good once b has been 1 while a was 0.
        const Grafcet other = grafcet_of(
            head + "var v graph G { initial 0 : lamp if /v, set v on ↑b step 1 0 -> 1 : a }");
        for (const Style style : {Style::gates, Style::nand}) {
            const CheckResult result = verdict_within(grafcet, netlist_of(other, style));
            CHECK(result.verdict == Verdict::different);
            CHECK(result.witness->kind == DifferenceKind::output);
            CHECK(stimuli_of(result, grafcet).find("b=1") != std::string::npos);
        }
    }
}

TEST_CASE("a difference counts if the lengths of the delays allow it") {
    const std::string head = "input a output lamp graph G { initial 0 step 1 : lamp if ";
    const std::string tail = " 0 -> 1 : a 1 -> 0 : /a }";
    const auto with_dark_lamp = [&](const Grafcet& grafcet, Style style = Style::nand) {
        Netlist netlist = netlist_of(grafcet, style);
        for (Cell& cell : netlist.cells) {
            if (netlist.names[cell.output] != "lamp") continue;
            cell.type = CellType::low;
            cell.pin_count = 0;
        }
        REQUIRE(fault_of(netlist) == "");
        return netlist;
    };
    SUBCASE("2 s over before 1 s: never") {
        const Grafcet grafcet = grafcet_of(head + "2s/X1 . /(1s/X1)" + tail);
        const CheckResult result = verdict_within(grafcet, with_dark_lamp(grafcet));
        CHECK(result.verdict == Verdict::equivalent);
        CHECK(result.complete);
        CHECK_FALSE(result.witness);
    }
    SUBCASE("1 s over before 2 s: always") {
        const Grafcet grafcet = grafcet_of(head + "1s/X1 . /(2s/X1)" + tail);
        const CheckResult result = verdict_within(grafcet, with_dark_lamp(grafcet));
        CHECK(result.verdict == Verdict::different);
        REQUIRE(result.witness);
        CHECK(result.witness->kind == DifferenceKind::output);
        // Step 1 from the start on, and nothing more until the second is over.
        CHECK(stimuli_of(result, grafcet) == "0s : a=1\n1s : end\n");
    }
    SUBCASE("a second time before 2 s: in the one second that leaves") {
        // Step 2 comes 1.5 s after step 1, so its second is over 0.5 s after the 2 s of step 1.
        const std::string chart = R"(
output lamp
graph G { initial 0 step 1 step 2 : lamp if )";
        const std::string loop = " 0 -> 1 : 100ms/X0 1 -> 2 : 1500ms/X1 2 -> 0 : 5s/X2 }";
        const Grafcet early = grafcet_of(chart + "1s/X2 . /(2s/(X1 + X2))" + loop);
        CHECK(verdict_within(early, with_dark_lamp(early)).verdict == Verdict::equivalent);
        const Grafcet late = grafcet_of(chart + "1s/X2 . /(2501ms/(X1 + X2))" + loop);
        CHECK(verdict_within(late, with_dark_lamp(late)).verdict == Verdict::different);
        const Grafcet together = grafcet_of(chart + "1s/X2 . /(2500ms/(X1 + X2))" + loop);
        CHECK(verdict_within(together, with_dark_lamp(together)).verdict == Verdict::equivalent);
        // Scan by scan the second is over some scans later, which only a short period makes up for.
        const CheckResult scanned = verdict_within(late, with_dark_lamp(late, Style::clocked));
        CHECK(scanned.verdict == Verdict::different);
        REQUIRE(scanned.witness);
        CHECK(scanned.witness->scan_period < millisecond);
    }
}

TEST_CASE("an impossible way to a state does not hide a possible one") {
    // 5 is reached at once if the 3 s are over before the second, which cannot be, and by e. The
    // lamp is wrong in 6, one step further.
    const std::string head = R"(
input a, e
output lamp
graph G {
  initial 0 step 1 step 2 step 4 step 5 step 6)";
    const std::string tail = R"(
  0 -> 1 : a
  1 -> 5 : 3s/X1 . /(1s/X1)
  1 -> 2 : 1s/X1
  2 -> 4 : e
  4 -> 5 : /e
  5 -> 6 : a . e
})";
    const Grafcet grafcet = grafcet_of(head + " : lamp" + tail);
    const Netlist wrong = netlist_of(grafcet_of(head + " : lamp if /X6" + tail), Style::clocked);
    const CheckResult result = verdict_within(grafcet, wrong);
    CHECK(result.verdict == Verdict::different);
    REQUIRE(result.witness);
    CHECK(value_of(*result.witness, "lamp").expected == Logic::one);
    CHECK(replay(grafcet, wrong, cell_delays(wrong, {}), result.witness->stimuli,
                 result.witness->scan_period));
    // Without the possible way the lamp does not matter.
    const std::string only = R"(
  0 -> 1 : a
  1 -> 5 : 3s/X1 . /(1s/X1)
  1 -> 2 : 1s/X1
  5 -> 6 : a . e
})";
    const Grafcet bound = grafcet_of(head + " : lamp" + only);
    const CheckResult none = verdict_within(
        bound, netlist_of(grafcet_of(head + " : lamp if /X6" + only), Style::clocked));
    CHECK(none.verdict == Verdict::equivalent);
    CHECK(none.complete);
}

TEST_CASE("timers of the netlist that run while the GRAFCET's do not are followed as well") {
    const std::string head = "input a output lamp graph G { initial 0 step 1 : lamp if 2s/";
    const std::string tail = " 0 -> 1 : a 1 -> 0 : /a }";
    const Grafcet grafcet = grafcet_of(head + "X1" + tail);
    for (const Style style : {Style::nand, Style::clocked}) {
        // Another length.
        Netlist hasty = netlist_of(grafcet, style);
        for (Timing& timing : hasty.timings) timing.rise /= 2;
        const CheckResult early = verdict_within(grafcet, hasty);
        CHECK(early.verdict == Verdict::different);
        CHECK(stimuli_of(early, grafcet) == "0s : a=1\n1s : end\n");
        // Another operand: it counts from a on, even while Init keeps step 1 away.
        const Netlist other = netlist_of(grafcet_of(head + "(X1 + a)" + tail), style);
        const CheckResult result = verdict_within(grafcet, other);
        CHECK(result.verdict == Verdict::different);
        REQUIRE(result.witness);
        CHECK(stimuli_of(result, grafcet).find("Init=1") != std::string::npos);
        CHECK(replay(grafcet, other, cell_delays(other, {}), result.witness->stimuli,
                     result.witness->scan_period));
    }
}

TEST_CASE("without modes only the declared inputs are varied") {
    const Grafcet grafcet = grafcet_of(three_steps);
    const CheckResult result = verdict_within(grafcet, netlist_of(grafcet, Style::gates, false));
    CHECK(result.verdict == Verdict::equivalent);
    CHECK(result.coverage.situations == 3);
    // Nor does any that is forgotten on the way come back: AUdoux would put out the lamp.
    const Grafcet lit = grafcet_of(R"(
input a
output lamp
graph G { initial 0 step 1 : lamp step 2
  0 -> 1 : ↑a
  1 -> 2 : ↓a
  2 -> 0 : ↑a })");
    for (const StyleRow& row : style_table) {
        for (const Changes changes : {Changes::one, Changes::many}) {
            CheckOptions options;
            options.changes = changes;
            const Netlist netlist = netlist_of(lit, row.style, false);
            const CheckResult of_lit = check_equivalence(lit, netlist, options);
            CHECK(of_lit.verdict == Verdict::equivalent);
            CHECK(of_lit.coverage.situations == 3);
        }
    }
}

}  // namespace grafwire::testing
