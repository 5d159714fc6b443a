// The referee's own simulator on netlists small enough to say what must come.

#include <doctest/doctest.h>

#include "netlist/styles/styles.h"
#include "random/read_text.h"
#include "referee/foreign_cells.h"
#include "referee/gate_simulator.h"
#include "support/styles.h"

namespace grafwire::testing {

namespace {

/// A chart of two steps, 1 -> 2 by a condition over a and b, in a style; both steps are shown.
struct TwoSteps {
    TwoSteps(const std::string& condition, Style style)
        : grafcet(*read_grafcet(
              "input a, b\ngraph G {\n  initial 1\n  step 2\n  1 -> 2 : " + condition + "\n}\n")) {
        const CdxForm cdx = style_table[static_cast<std::size_t>(style)].default_cdx;
        const Equations equations = equations_from(grafcet, {cdx, true});
        Diagnostics diagnostics;
        netlist = *netlist_from(grafcet, equations, style, diagnostics);
    }

    /// Inputs a and b, the control inputs at 0.
    static InputValues inputs(bool a, bool b = false) {
        return {std::uint8_t{a}, std::uint8_t{b}, 0, 0, 0};
    }
    std::vector<bool> zeros() const { return std::vector<bool>(netlist.net_count()); }

    Grafcet grafcet;
    Netlist netlist;
};

const std::vector<bool> step_1{true, false};
const std::vector<bool> step_2{false, true};

}  // namespace

TEST_CASE("gate simulator: inputs have been what they are since always") {
    for (const Style style : asynchronous_styles()) {
        const TwoSteps chart("↑a", style);
        GateSimulator gates(chart.grafcet, chart.netlist);
        REQUIRE(gates.start(chart.inputs(true), chart.zeros()));
        REQUIRE(gates.instant(0, chart.inputs(true)));
        CHECK(gates.shown() == step_1);
        REQUIRE(gates.instant(millisecond, chart.inputs(false)));
        CHECK(gates.shown() == step_1);
        REQUIRE(gates.instant(2 * millisecond, chart.inputs(true)));
        CHECK(gates.shown() == step_2);
    }
}

TEST_CASE("gate simulator: a delay counts from the instant, and ends if its operand still asks") {
    for (const Style style : asynchronous_styles()) {
        const TwoSteps chart("30ms/(a . /b)", style);
        for (const bool b : {false, true}) {
            GateSimulator gates(chart.grafcet, chart.netlist);
            REQUIRE(gates.start(chart.inputs(false), chart.zeros()));
            REQUIRE(gates.instant(0, chart.inputs(false)));
            CHECK(gates.next_end() == never);
            REQUIRE(gates.instant(10 * millisecond, chart.inputs(true)));
            CHECK(gates.next_end() == 40 * millisecond);
            REQUIRE(gates.instant(40 * millisecond, chart.inputs(true, b)));
            CHECK(gates.shown() == (b ? step_1 : step_2));
            CHECK(gates.next_end() == never);
        }
    }
}

TEST_CASE("gate simulator: a scan of a clocked netlist, and a delay in it") {
    const TwoSteps chart("20ms/a", Style::clocked);
    GateSimulator gates(chart.grafcet, chart.netlist);
    REQUIRE(gates.start(chart.inputs(true), chart.zeros()));
    // At the end of the scan at 20 ms the delay is over, and the next scan clears the transition.
    for (const Time now : {0, 10, 20, 30}) {
        REQUIRE(gates.scan(now * millisecond, chart.inputs(true)));
        CHECK(gates.shown() == (now == 30 ? step_2 : step_1));
    }
}

TEST_CASE("gate simulator: rings do not settle, memories do") {
    TwoSteps chart("a", Style::nand);
    ForeignCells cells(chart.netlist);
    SUBCASE("an inverter on itself") {
        const NetId ring = cells.add(CellType::inverter, {cells.net("a")});
        chart.netlist.pins[chart.netlist.cells.items().back().first_pin] = ring;
        CHECK_FALSE(
            GateSimulator(chart.grafcet, chart.netlist).start(chart.inputs(false), chart.zeros()));
    }
    SUBCASE("an OR on itself") {
        const NetId memory = cells.add(CellType::or_gate, {cells.net("a"), cells.net("b")});
        chart.netlist.pins[chart.netlist.cells.items().back().first_pin] = memory;
        GateSimulator gates(chart.grafcet, chart.netlist);
        REQUIRE(gates.start(chart.inputs(false), chart.zeros()));
        REQUIRE(gates.instant(0, chart.inputs(false)));
        CHECK_FALSE(gates.values()[index_of(memory)]);
        REQUIRE(gates.instant(millisecond, chart.inputs(false, true)));
        REQUIRE(gates.instant(2 * millisecond, chart.inputs(false, false)));
        CHECK(gates.values()[index_of(memory)]);
    }
}

}  // namespace grafwire::testing
