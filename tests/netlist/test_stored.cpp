// Stored variables that are read by what is written to them.

#include <algorithm>

#include "evolution/run.h"
#include "simulate/simulate.h"
#include "support/small_netlists.h"
#include "support/styles.h"

namespace grafwire::testing {

namespace {

std::size_t count(const Netlist& netlist, CellType type) {
    return static_cast<std::size_t>(std::count_if(netlist.cells.begin(), netlist.cells.end(),
                                                  [&](const Cell& c) { return c.type == type; }));
}

/// The last columns of reference and netlist, which must be the same, as text.
std::string last_column(const Grafcet& grafcet, Style style, const std::string& stimuli_text) {
    const auto stimuli = read_stimuli(stimuli_text, grafcet);
    REQUIRE(stimuli);
    const Netlist netlist = netlist_of(grafcet, style);
    const Trace expected = run_until_stable(grafcet, *stimuli).trace;
    const Trace got = simulate(grafcet, netlist, cell_delays(netlist, {}), *stimuli, {}).trace;
    CHECK(write_csv(got) == write_csv(expected));
    std::string text;
    for (std::size_t row = 1; row <= got.row_count(); ++row) {
        text += std::to_string(got.values[row * got.columns.size() - 1]);
    }
    return text;
}

}  // namespace

TEST_CASE("v := /v goes through a hold latch and turns over once") {
    const Grafcet grafcet = grafcet_of(R"(
input a
var v
graph G { initial 0 step 1 : v := /v  step 2
  0 -> 1 : a
  1 -> 2 : /a
  2 -> 0 : 1 }
)");
    for (const Style style : asynchronous_styles()) {
        if (!takes_stored_actions(style)) continue;
        const Netlist netlist = netlist_of(grafcet, style);
        CHECK(count(netlist, CellType::hold_latch) == 1);
        CHECK(count(netlist, CellType::latch) == 1);
        CHECK(last_column(grafcet, style,
                          "0ms : a=0\n+1s : a=1\n+1s : a=0\n+1s : a=1\n+1s : end\n") == "01100");
    }
    CHECK(count(netlist_of(grafcet, Style::clocked), CellType::hold_latch) == 0);
}

TEST_CASE("stored variables that read each other keep their nets apart") {
    const Grafcet grafcet = grafcet_of(R"(
input a, b
output m
var v
graph G { step 1 : set v on a . b
  -> 1 : a do m := b + m }
)");
    for (const StyleRow& row : style_table) {
        if (!takes_stored_actions(row.style)) continue;
        CHECK(fault_of(netlist_of(grafcet, row.style)) == "");
    }
}

TEST_CASE("what only constants are written to needs no hold latch") {
    const Grafcet grafcet = grafcet_of(R"(
input a
output s
graph G { initial 0 : reset s  step 1 : set s  step 2
  0 -> 1 : a
  1 -> 2 : /a
  2 -> 0 : a }
)");
    for (const Style style : asynchronous_styles()) {
        if (!takes_stored_actions(style)) continue;
        const Netlist netlist = netlist_of(grafcet, style);
        CHECK(count(netlist, CellType::hold_latch) == 0);
        CHECK(count(netlist, CellType::latch) == 1);
    }
}

TEST_CASE("a var that nothing writes is 0") {
    const Grafcet grafcet = grafcet_of(R"(
input a
var v
graph G { initial 0 step 1
  0 -> 1 : a . /v }
)");
    for (const StyleRow& row : style_table) {
        CHECK(last_column(grafcet, row.style, "0ms : a=0\n+1s : a=1\n") == "00");
    }
}

TEST_CASE("a counter keeps its offset and its width") {
    const Grafcet grafcet = grafcet_of(R"(
input a
counter c : -2..5
graph G { initial 0 step 1 : c := c + 3
  0 -> 1 : ↑a
  1 -> 0 : ↓a }
)");
    const Netlist netlist = netlist_of(grafcet, Style::clocked);
    REQUIRE(netlist.counters.size() == 1);
    CHECK(netlist.counters[0].name == "c");
    CHECK(netlist.counters[0].offset == -2);
    CHECK(netlist.counters[0].bits.size() == 3);
    CHECK(last_column(grafcet, Style::clocked,
                      "0ms : a=0\n+1s : a=1\n+1s : a=0\n+1s : a=1\n+1s : a=0\n+1s : a=1\n") ==
          "-211445");
}

}  // namespace grafwire::testing
