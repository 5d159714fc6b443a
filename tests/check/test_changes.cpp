// What changes in one instant: one input or delays that end, many inputs at once, and what the
// verdict for one says about many.

#include <doctest/doctest.h>

#include "check/check_equivalence.h"
#include "check/netlist_witness.h"
#include "check/path.h"
#include "grafcet/parse_grafcet.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

CheckResult check_changes(const Grafcet& grafcet, const Netlist& netlist, Changes changes) {
    CheckOptions options;
    options.changes = changes;
    return check_equivalence(grafcet, netlist, options);
}

CheckResult check_changes(const Grafcet& grafcet, Style style, Changes changes) {
    return check_changes(grafcet, netlist_of(grafcet, style, false), changes);
}

/// The most inputs that change at one instant after the first.
std::size_t most_changes(const Stimuli& stimuli) {
    std::size_t most = 0;
    for (const Stimuli::Change& change : stimuli.changes) {
        if (change.at != 0) most = std::max(most, change.assignments.size());
    }
    return most;
}

/// A netlist in which everything reads an input two gates later than it changes.
Netlist with_slow_input(Netlist netlist, std::string_view name) {
    NetId from = no_net;
    for (const Port& port : netlist.inputs) {
        if (port.name == name) from = port.net;
    }
    REQUIRE(from != no_net);
    const NetId half_way = netlist.names.add("half way");
    const NetId slow = netlist.names.add("slow");
    for (NetId& pin : netlist.pins) {
        if (pin == from) pin = slow;
    }
    for (const auto& [pin, output] : {std::pair{from, half_way}, std::pair{half_way, slow}}) {
        Cell buffer;
        buffer.first_pin = static_cast<std::uint32_t>(netlist.pins.size());
        buffer.pin_count = 1;
        buffer.output = output;
        buffer.origin = 0;
        netlist.pins.push_back(pin);
        netlist.cells.add(buffer);
    }
    netlist.modules.back().cell_count += 2;
    REQUIRE(fault_of(netlist) == "");
    return netlist;
}

}  // namespace

TEST_CASE("a race of two inputs is a difference only where both may change at once") {
    // b reaches the product later than a, so that it is 1 for 2 ns where a rises as b falls.
    const Grafcet grafcet = grafcet_of(R"(
input a, b
output lamp
var seen
graph G { initial 1 : set seen on ↑(a . b), lamp if seen }
)");
    const Netlist netlist = with_slow_input(netlist_of(grafcet, Style::nand, false), "b");
    const CheckResult one = check_changes(grafcet, netlist, Changes::one);
    CHECK(one.verdict == Verdict::equivalent);
    REQUIRE(one.together);
    CHECK(one.together->verdict == Verdict::different);
    REQUIRE(one.together->witness);
    CHECK(most_changes(one.together->witness->stimuli) == 2);
    CHECK(one.together->inputs == std::vector<std::uint32_t>{0, 1});
    CHECK_FALSE(one.together->with_delay);
    // Nothing in the chart needs a without b.
    CHECK(one.together->assumption == "/(a./b)");

    const CheckResult many = check_changes(grafcet, netlist, Changes::many);
    CHECK(many.verdict == Verdict::different);
    CHECK_FALSE(many.together);
    REQUIRE(many.witness);
    CHECK(write_stimuli(many.witness->stimuli, grafcet) ==
          write_stimuli(one.together->witness->stimuli, grafcet));
}

TEST_CASE("an assumption that would leave something unexercised is not told") {
    const Grafcet grafcet = grafcet_of(R"(
input a, b
output lamp, alone
var seen
graph G { initial 1 : set seen on ↑(a . b), lamp if seen, alone if a . /b }
)");
    const Netlist netlist = with_slow_input(netlist_of(grafcet, Style::nand, false), "b");
    const CheckResult one = check_changes(grafcet, netlist, Changes::one);
    CHECK(one.verdict == Verdict::equivalent);
    REQUIRE(one.together);
    CHECK(one.together->verdict == Verdict::different);
    CHECK(one.together->assumption.empty());
}

TEST_CASE("where one at a time holds, many at once may as well") {
    const Grafcet grafcet = grafcet_of(R"(
input m, a, b
graph G { initial 0 step 1 step 2
  0 -> 1 : m
  1 -> 2 : a
  2 -> 0 : b }
)");
    const CheckResult one = check_changes(grafcet, Style::nand, Changes::one);
    REQUIRE(one.together);
    CHECK(one.together->verdict == Verdict::equivalent);
    CHECK_FALSE(one.together->witness);
    // Scans sample their inputs: nothing to look at.
    CHECK_FALSE(check_changes(grafcet, Style::clocked, Changes::one).together);
}

TEST_CASE("a witness changes one input at an instant, and no more inputs than it needs") {
    const std::string head = "input a, b, c, d\noutput lamp\n";
    const Grafcet grafcet = grafcet_of(
        head + "graph G { initial 0 step 1 step 2 : lamp 0 -> 1 : a.b 1 -> 2 : c 2 -> 0 : d }");
    const Netlist wrong = netlist_of(
        grafcet_of(head + "graph G { initial 0 step 1 step 2 0 -> 1 : a.b 1 -> 2 : c 2 -> 0 : d }"),
        Style::nand);
    for (const Changes changes : {Changes::one, Changes::many}) {
        const CheckResult result = check_changes(grafcet, wrong, changes);
        REQUIRE(result.witness);
        const std::string stimuli = write_stimuli(result.witness->stimuli, grafcet);
        INFO(stimuli);
        CHECK(stimuli.find("d=1") == std::string::npos);
        CHECK(stimuli.find("Init") == std::string::npos);
        if (changes == Changes::one) CHECK(most_changes(result.witness->stimuli) <= 1);
    }
}

TEST_CASE("a delay and an input change in one instant under many alone") {
    // The netlist lets the delay win where the input falls as it ends.
    const std::string head = "input a\noutput lamp\n";
    const Grafcet grafcet = grafcet_of(
        head + "graph G { initial 1 step 2 : lamp step 3 1 -> 2 : 1s/X1 . a 1 -> 3 : /a . 1s/X1 }");
    const CheckResult one = check_changes(grafcet, Style::nand, Changes::one);
    CHECK(one.verdict == Verdict::equivalent);
    CHECK(one.coverage.cases < check_changes(grafcet, Style::nand, Changes::many).coverage.cases);
    // An operand that an input takes away as its delay ends: the same in both, and in scans.
    const Grafcet delayed =
        grafcet_of(head + "graph G { initial 1 step 2 : lamp 1 -> 2 : 30ms/a 2 -> 1 : 30ms/(/a) }");
    for (const StyleRow& row : style_table) {
        // A loop of two steps.
        if (row.style == Style::gates || row.style == Style::nor || row.style == Style::rs)
            continue;
        for (const Changes changes : {Changes::one, Changes::many}) {
            CHECK(check_changes(delayed, row.style, changes).verdict == Verdict::equivalent);
        }
    }
}

TEST_CASE("the changes of one input that the plant allows") {
    const Grafcet grafcet =
        grafcet_of("input a, b, c\nassume a ⊕ b\ngraph G { initial 1 1 -> 1 : a . b . c }");
    const Assumptions assumptions(grafcet);
    const PartialInput i = PartialInput::one;
    const PartialInput o = PartialInput::zero;
    const PartialInput x = PartialInput::unassigned;
    // Two complementary contacts change together, c by itself; nothing without modes.
    CHECK(single_changes(assumptions, {i, o, i, o, o, o}, false) ==
          std::vector<PartialInputs>{{i, o, o, o, o, o}, {o, i, i, o, o, o}});
    CHECK(single_changes(assumptions, {x, x, o, o, x, x}, true) ==
          std::vector<PartialInputs>{{x, x, i, o, x, x}, {x, x, o, i, x, x}});
    // b was unassigned and is read now: it has changed with a.
    CHECK(inputs_before(assumptions, {o, x, x, o, o, o}, {i, o, x, o, o, o}) ==
          PartialInputs{o, i, x, o, o, o});
    CHECK(inputs_before(assumptions, {o, x, x, o, o, o}, {o, i, i, o, o, o}) ==
          PartialInputs{o, i, i, o, o, o});
}

TEST_CASE(
    "what changes without an effect is put in one by one, in an order that the plant allows") {
    const Grafcet grafcet = grafcet_of(
        "input a, b, c\nassume /(a . b)\nassume c + /b\ngraph G { initial 1 1 -> 1 : a . b . c }");
    const Assumptions assumptions(grafcet);
    const PartialInput i = PartialInput::one;
    const PartialInput o = PartialInput::zero;
    const PartialInputs start{i, o, o, o, o, o};
    const PartialInputs before{o, i, i, o, o, o};
    const PartialInputs last{o, i, i, i, o, o};
    const auto path = one_by_one(assumptions, {{start, start, {}, {}}, {before, last, {}, {}}}, 6);
    REQUIRE(path);
    REQUIRE(path->size() == 5);
    for (std::size_t step = 1; step < path->size(); ++step) {
        CHECK((*path)[step].before == (*path)[step - 1].inputs);
        CHECK(assumptions.can_hold((*path)[step].inputs));
    }
    CHECK(path->back().inputs == last);
}

}  // namespace grafwire::testing
