// Wrong netlists that only one line of the check stands against.

#include "check/check_equivalence.h"
#include "check/netlist_witness.h"
#include "check/wrong_wiring.h"
#include "support/small_netlists.h"
#include "trace/stimuli.h"

namespace grafwire::testing {

namespace {

CheckResult check_whole(const Grafcet& grafcet, const Netlist& netlist) {
    REQUIRE(fault_of(netlist) == "");
    return check_equivalence(grafcet, netlist, {});
}

/// The stimuli of the witness, which replays; "" where there is none.
std::string witness_of(const Grafcet& grafcet, const Netlist& netlist) {
    const CheckResult result = check_whole(grafcet, netlist);
    CHECK(result.verdict == (result.witness ? Verdict::different : Verdict::equivalent));
    if (!result.witness) return {};
    CHECK(replay(grafcet, netlist, cell_delays(netlist, {}), result.witness->stimuli,
                 result.witness->scan_period));
    return write_stimuli(result.witness->stimuli, grafcet);
}

/// `hazard` sets it, nothing resets it.
void latch_that_darkens_the_lamp(Netlist& netlist) {
    add_cell(netlist, CellType::or_gate, "out", {"hazard", "kept"});
    add_cell(netlist, CellType::buffer, "kept", {"out"});
    add_cell(netlist, CellType::inverter, "not_out", {"out"});
    netlist.initial_values.push_back({net_named(netlist, "out"), false});
    netlist.initial_values.push_back({net_named(netlist, "kept"), false});
    put_gate_before(netlist, "lamp", CellType::and_gate, {"not_out"});
}

const std::string a_sets_step_1 = R"(
input a
output lamp
graph G { initial 0 step 1 : lamp
  0 -> 1 : a
  1 -> 0 : /a }
)";

}  // namespace

TEST_CASE("a timer is too short or too long by any length, whether or not one divides the other") {
    const auto chart = [](const std::string& condition) {
        return grafcet_of(
            "input a output lamp graph G { initial 0 step 1 : lamp 0 -> 1 : " + condition + " }");
    };
    const auto differs = [](const Grafcet& right, const Grafcet& wrong) {
        for (const Style style : {Style::nand, Style::clocked}) {
            CHECK(witness_of(right, netlist_of(wrong, style)) != "");
            CHECK(witness_of(right, netlist_of(right, style)) == "");
        }
    };
    for (const std::string length : {"1s", "2s", "4s", "6s", "2999ms", "3001ms"}) {
        INFO(length << " for 3s");
        differs(chart("3s/X0"), chart(length + "/X0"));
        differs(chart("3s/a"), chart(length + "/a"));
        differs(chart("2s/a/3s"), chart("2s/a/" + length));
        differs(chart("3s/a/2s"), chart(length + "/a/2s"));
    }
}

TEST_CASE("wiring that oscillates until the edge of the clock stops it") {
    // The ring runs while a is 1 and step 1 is not active yet.
    const Grafcet grafcet = grafcet_of(a_sets_step_1);
    Netlist netlist = netlist_of(grafcet, Style::clocked, false);
    add_cell(netlist, CellType::inverter, "early", {"X1"});
    add_cell(netlist, CellType::and_gate, "go", {"early", "a"});
    add_ring(netlist, "go");
    const CheckResult result = check_whole(grafcet, netlist);
    CHECK(result.verdict == Verdict::different);
    REQUIRE(result.witness);
    CHECK(result.witness->kind == DifferenceKind::oscillation);
}

TEST_CASE("wiring that oscillates from the edge of the clock on") {
    const Grafcet grafcet = grafcet_of(a_sets_step_1);
    Netlist netlist = netlist_of(grafcet, Style::clocked, false);
    SUBCASE("to the next") {
        add_cell(netlist, CellType::inverter, "late", {"a"});
        add_cell(netlist, CellType::and_gate, "go", {"X1", "late"});
        add_ring(netlist, "go");
    }
    SUBCASE("while the clock is 1") {
        add_cell(netlist, CellType::and_gate, "go", {"X1", "clk"});
        add_ring(netlist, "go");
    }
    const CheckResult result = check_whole(grafcet, netlist);
    CHECK(result.verdict == Verdict::different);
    REQUIRE(result.witness);
    CHECK(result.witness->kind == DifferenceKind::oscillation);
}

TEST_CASE("a flip-flop too many shows itself some scans into an evolution that never rests") {
    // The lamp stays dark from the fifth scan on; no input ever changes.
    const Grafcet grafcet = grafcet_of(R"(
output lamp
graph G { initial 0 step 1 : lamp
  0 -> 1 : =1
  1 -> 0 : =1 }
)");
    Netlist netlist = netlist_of(grafcet, Style::clocked, false);
    CHECK(witness_of(grafcet, netlist) == "");
    add_cell(netlist, CellType::high, "late0", {});
    for (int i = 1; i <= 5; ++i) {
        const std::string before = "late" + std::to_string(i - 1);
        add_cell(netlist, CellType::flip_flop, "late" + std::to_string(i), {before, "clk"},
                 Logic::zero);
    }
    add_cell(netlist, CellType::inverter, "early", {"late5"});
    put_gate_before(netlist, "lamp", CellType::and_gate, {"early"});
    CHECK(witness_of(grafcet, netlist) == "0s :\n40ms : end\n");
}

TEST_CASE("an edge that only the netlist looks at, whichever input it is of") {
    // The lamp goes out for good with a second rise of b in step 1, where the GRAFCET has no use
    // for b, but had one on the way there.
    const std::string chart = R"(
output lamp
graph G { initial 0 step 1 : lamp
  0 -> 1 : b . a
  1 -> 0 : /a }
)";
    for (const std::string inputs : {"input a, b", "input b, a"}) {
        const Grafcet grafcet = grafcet_of(inputs + chart);
        Netlist netlist = netlist_of(grafcet, Style::nand, false);
        add_cell(netlist, CellType::rise_pulse, "b_rises", {"b"});
        netlist.timings.push_back({0, 5 * nanosecond, 0});
        netlist.cells.items().back().timing =
            static_cast<std::uint32_t>(netlist.timings.size() - 1);
        add_cell(netlist, CellType::buffer, "X1_later", {"X1$later"});
        add_cell(netlist, CellType::buffer, "X1$later", {"X1"});
        add_cell(netlist, CellType::and_gate, "again", {"b_rises", "X1_later"});
        add_cell(netlist, CellType::or_gate, "out", {"again", "kept"});
        add_cell(netlist, CellType::and_gate, "kept", {"out", "X1"});
        add_cell(netlist, CellType::inverter, "not_out", {"out"});
        netlist.initial_values.push_back({net_named(netlist, "out"), false});
        netlist.initial_values.push_back({net_named(netlist, "kept"), false});
        put_gate_before(netlist, "lamp", CellType::and_gate, {"not_out"});
        for (const Changes changes : {Changes::one, Changes::many}) {
            CheckOptions options;
            options.changes = changes;
            const CheckResult result = check_changes(grafcet, netlist, options);
            CHECK(result.verdict == Verdict::different);
            REQUIRE(result.witness);
            CHECK(result.witness->kind == DifferenceKind::output);
        }
    }
}

TEST_CASE("a counter matters if another takes its value, and if that takes part in a sum") {
    // The netlist stores 1 where the GRAFCET stores what m has counted, which is 1 the first time.
    const auto chart = [](const std::string& stored) {
        return grafcet_of(R"(
input a, b
output lamp
counter m : 0..3
counter n : 0..6
graph G { initial 0 step 1 : m := m + 1 step 2 : n := )" +
                          stored + R"(, lamp if [n > 1]
  0 -> 1 : a
  1 -> 0 : /a
  1 -> 2 : b . a }
)");
    };
    for (const std::string right : {"m", "m + 0", "m + m - m"}) {
        INFO(right);
        const Grafcet grafcet = chart(right);
        CHECK(witness_of(grafcet, netlist_of(grafcet, Style::clocked, false)).empty());
        CHECK_FALSE(witness_of(grafcet, netlist_of(chart("1"), Style::clocked, false)).empty());
    }
}

TEST_CASE("a var matters that an output reads, by way of other vars as well") {
    // The netlist knows of no var, and is right until step 1 has been active once.
    const auto chart = [](const std::string& vars, const std::string& step,
                          const std::string& do_) {
        return grafcet_of("input a, b output lamp " + vars +
                          " graph G { initial 0 step 1 : set v step 2" + step +
                          " 0 -> 1 : a . /b 1 -> 0 : /a 0 -> 2 : b" + do_ + " 2 -> 0 : /b }");
    };
    std::string many = "var v0";
    for (int i = 1; i < 70; ++i) many += ", v" + std::to_string(i);
    const Grafcet without = chart("var v", "", "");
    const Netlist netlist = netlist_of(without, Style::clocked, false);
    CHECK(witness_of(without, netlist).empty());
    CHECK_FALSE(witness_of(chart("var v", " : lamp if v", ""), netlist).empty());
    CHECK_FALSE(witness_of(chart(many + ", v", " : lamp if v", ""), netlist).empty());
    CHECK_FALSE(witness_of(chart("var v, w", " : w := v, lamp if w", ""), netlist).empty());
    CHECK_FALSE(witness_of(chart("var v, w", " : lamp if w", " do w := v"), netlist).empty());
}

TEST_CASE("a hazard that needs an input back at 0 that nothing read in between") {
    // In step 1 nothing reads b. A rise of b together with c there, and nothing else, puts out the
    // lamp of step 3.
    const std::string chart = R"(
output lamp
graph G { initial 0 step 1 step 2 step 3 : lamp
  0 -> 1 : a . b
  1 -> 2 : c
  2 -> 3 : b }
)";
    for (const std::string inputs : {"input a, b, c", "input b, a, c"}) {
        const Grafcet grafcet = grafcet_of(inputs + chart);
        Netlist netlist = netlist_of(grafcet, Style::nand, false);
        add_cell(netlist, CellType::inverter, "not_b", {"b"});
        add_cell(netlist, CellType::buffer, "late", {"not_b"});
        add_cell(netlist, CellType::and_gate, "hazard", {"X1", "c", "b", "late"});
        latch_that_darkens_the_lamp(netlist);
        CheckOptions options;
        CHECK(check_changes(grafcet, netlist, options).verdict == Verdict::equivalent);
        options.changes = Changes::many;
        const CheckResult result = check_changes(grafcet, netlist, options);
        CHECK(result.verdict == Verdict::different);
        const std::string both = inputs == "input a, b, c" ? "a=1 b=1" : "b=1 a=1";
        REQUIRE(result.witness);
        CHECK(write_stimuli(result.witness->stimuli, grafcet) ==
              "0s : " + both + "\n100ms : b=0\n200ms : b=1 c=1\n200ms : end\n");
    }
}

TEST_CASE("a hazard that needs an input which the plant does not allow on the way there") {
    // As above with a fall of d, which can be 1 only once a is 0 again.
    const Grafcet grafcet = grafcet_of(R"(
input a, c, d
output lamp
assume /(a . d)
graph G { initial 0 step 1 step 2 step 3 : lamp
  0 -> 1 : a
  1 -> 2 : c
  2 -> 3 : /d }
)");
    Netlist netlist = netlist_of(grafcet, Style::nand, false);
    const auto delayed = [&](const std::string& net, int buffers) {
        std::string last = net;
        for (int i = 0; i < buffers; ++i) {
            add_cell(netlist, CellType::buffer, last + "'", {last});
            last += "'";
        }
        return last;
    };
    add_cell(netlist, CellType::inverter, "not_d", {"d"});
    add_cell(netlist, CellType::and_gate, "hazard",
             {delayed("X1", 2), "c", "not_d", delayed("d", 3)});
    latch_that_darkens_the_lamp(netlist);
    CheckOptions options;
    CHECK(check_changes(grafcet, netlist, options).verdict == Verdict::equivalent);
    options.changes = Changes::many;
    const CheckResult result = check_changes(grafcet, netlist, options);
    CHECK(result.verdict == Verdict::different);
    REQUIRE(result.witness);
    CHECK(write_stimuli(result.witness->stimuli, grafcet) ==
          "0s : a=1\n100ms : a=0 d=1\n200ms : c=1 d=0\n200ms : end\n");
}

TEST_CASE("an input that is read at last has had its value from the start") {
    const auto chart = [](const std::string& action) {
        return grafcet_of("input a, b output lamp graph G { initial 0 step 1 step 2 step 3" +
                          action + " 0 -> 1 : a 1 -> 2 : /a 2 -> 3 : a . b }");
    };
    const Grafcet grafcet = chart(" : lamp");
    CHECK(witness_of(grafcet, netlist_of(chart(""), Style::nand, false)) ==
          "0s : a=1 b=1\n100ms : a=0\n200ms : a=1\n200ms : end\n");
}

TEST_CASE("an output that should be 0 and follows a memory that nothing has set") {
    const Grafcet grafcet = grafcet_of(a_sets_step_1);
    for (const Style style : {Style::nand, Style::clocked}) {
        INFO(style_table[static_cast<std::size_t>(style)].name);
        // One memory, or more than can be gone through value by value.
        const auto with_lamp_lit_in = [&](const std::string& step, int memories) {
            Netlist netlist = netlist_of(grafcet, style, false);
            std::vector<std::string> pins{step};
            for (int i = 0; i < memories; ++i) {
                pins.push_back("memory" + std::to_string(i));
                add_cell(netlist, CellType::buffer, pins.back(), {pins.back()});
            }
            add_cell(netlist, CellType::and_gate, "lit", pins);
            put_gate_before(netlist, "lamp", CellType::or_gate, {"lit"});
            return check_whole(grafcet, netlist);
        };
        for (const int memories : {1, 12}) {
            const CheckResult result = with_lamp_lit_in("X0", memories);
            CHECK(result.verdict == Verdict::different);
            REQUIRE(result.witness);
            CHECK(result.witness->kind == DifferenceKind::power_up);
        }
        // In step 1 it is lit anyway.
        CHECK(with_lamp_lit_in("X1", 1).verdict == Verdict::equivalent);
    }
}

TEST_CASE("of the values that a memory may power up with any may be the one that shows a fault") {
    // In three values the lamp of step 1 is unknown, in two it is right; the horn of step 2, which
    // comes after it only, is wrong with one power-up of the four.
    const Grafcet grafcet = grafcet_of(R"(
input a
output lamp, horn
graph G { initial 0 step 1 : lamp step 2
  0 -> 1 : a
  1 -> 2 : /a }
)");
    Netlist memories = netlist_of(grafcet, Style::nand, false);
    for (const std::string memory : {"p", "q"}) {
        add_cell(memories, CellType::buffer, memory, {memory});
        add_cell(memories, CellType::inverter, "not_" + memory, {memory});
        add_cell(memories, CellType::or_gate, "some_" + memory, {memory, "not_" + memory});
    }
    put_gate_before(memories, "lamp", CellType::and_gate, {"some_p", "some_q"});
    const CheckResult right = check_whole(grafcet, memories);
    CHECK(right.verdict == Verdict::equivalent);
    // A bound is one on the cases of all power-ups together.
    for (std::uint64_t most = 1; most < right.coverage.cases; ++most) {
        CheckOptions options;
        options.max_cases = most;
        options.looks_at_many = false;
        const CheckResult bounded = check_equivalence(grafcet, memories, options);
        CHECK(bounded.verdict == Verdict::undecided);
    }
    for (const std::string p : {"p", "not_p"}) {
        for (const std::string q : {"q", "not_q"}) {
            INFO(p << " and " << q);
            Netlist netlist = memories;
            add_cell(netlist, CellType::and_gate, "wrong", {"X2", p, q});
            put_gate_before(netlist, "horn", CellType::or_gate, {"wrong"});
            const CheckResult result = check_whole(grafcet, netlist);
            CHECK(result.verdict == Verdict::different);
            REQUIRE(result.witness);
            const std::vector<Netlist::InitialValue>& power_up = result.witness->power_up;
            REQUIRE(power_up.size() == 2);
            for (const Netlist::InitialValue& value : power_up) {
                const std::string wrong = value.net == net_named(netlist, "p") ? p : q;
                CHECK(value.value == !wrong.starts_with("not_"));
            }
        }
    }
}

}  // namespace grafwire::testing
