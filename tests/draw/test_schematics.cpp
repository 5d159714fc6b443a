// Schematics drawn, and measured in the SVG file.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "draw/draw_schematic.h"
#include "draw/schematic_nets.h"
#include "draw/schematic_rules.h"
#include "draw/write_drawing.h"
#include "equations/equations.h"
#include "netlist/styles/styles.h"
#include "random/random_grafcet.h"
#include "random/read_text.h"
#include "support/chart_files.h"
#include "support/mutate.h"
#include "support/slow_build.h"

namespace grafwire::testing {

namespace {

/// Empty where the style cannot hold the chart.
std::optional<Netlist> netlist_of(const Grafcet& grafcet, const StyleRow& row, bool modes) {
    Diagnostics diagnostics;
    return netlist_from(grafcet, equations_from(grafcet, {row.default_cdx, modes}), row.style,
                        diagnostics);
}

std::string svg_of_netlist(const Netlist& netlist, const SchematicDrawing& how = {}) {
    return write_svg_drawing(draw_schematic(netlist, how), netlist.name, how.paper, how.language);
}

std::string faults_of(const Netlist& netlist, const SchematicDrawing& how = {}) {
    return told(all_schematic_faults(netlist, read_picture(svg_of_netlist(netlist, how))));
}

/// Values of all kinds.
std::vector<Logic> some_values(const Netlist& netlist) {
    std::vector<Logic> values;
    for (std::size_t net = 0; net < netlist.net_count(); ++net) {
        values.push_back(static_cast<Logic>(net % 3));
    }
    return values;
}

}  // namespace

TEST_CASE("schematics: the examples in all styles") {
    for (const ChartFiles& example : example_charts()) {
        const auto grafcet = read_grafcet(example.chart);
        REQUIRE(grafcet);
        for (const StyleRow& row : style_table) {
            const auto netlist = netlist_of(*grafcet, row, true);
            if (!netlist) continue;
            CAPTURE(example.name);
            CAPTURE(row.name);
            CHECK(faults_of(*netlist) == "");
            CHECK(svg_of_netlist(*netlist) == svg_of_netlist(*netlist));
            SchematicDrawing how;
            how.shapes = GateShapes::us;
            how.language = Language::french;
            how.values = some_values(*netlist);
            CHECK(faults_of(*netlist, how) == "");
        }
    }
}

TEST_CASE("schematics: random charts, and netlists with a mistake") {
    RandomSource random(20261130);
    for (int i = 0; i < (is_slow_build ? 8 : 80); ++i) {
        Features features;
        features.steps = 2 + static_cast<std::size_t>(i) % 20;
        features.plain = i % 3 == 0;
        features.counters = i % 5 == 0 ? 1 : 0;
        const std::string text = random_grafcet(random, features);
        const auto grafcet = read_grafcet(text);
        REQUIRE(grafcet);
        const StyleRow& row = style_table[static_cast<std::size_t>(i) % style_table.size()];
        std::optional<Netlist> netlist = netlist_of(*grafcet, row, i % 2 == 0);
        if (!netlist) continue;
        CAPTURE(i);
        CAPTURE(row.name);
        CAPTURE(text);
        const std::string faults = faults_of(*netlist);
        CHECK(faults == "");
        if (!faults.empty()) break;
        const std::vector<Mutation> mutations = mutations_of(*netlist);
        if (mutations.empty()) continue;
        const Mutation& mutation = mutations[random.below(mutations.size())];
        CAPTURE(describe(*netlist, mutation));
        CHECK(faults_of(mutated(std::move(*netlist), mutation)) == "");
    }
}

TEST_CASE("schematics: a netlist of no chart") {
    // Two inverters in a ring, an input that is an output, an output of another name, a gate that
    // nothing reads, a gate of many inputs.
    Netlist netlist;
    netlist.name = "odd";
    const auto net = [&](const char* name) { return netlist.names.add(name); };
    const NetId a = net("a");
    const NetId p = net("p");
    const NetId q = net("q");
    const NetId wide = net("wide");
    netlist.inputs = {{"a", a}};
    netlist.origins.emplace_back();
    const auto cell = [&](CellType type, std::vector<NetId> pins, NetId output) {
        Cell made;
        made.type = type;
        made.first_pin = static_cast<std::uint32_t>(netlist.pins.size());
        made.pin_count = static_cast<std::uint32_t>(pins.size());
        made.output = output;
        made.origin = 0;
        netlist.pins.insert(netlist.pins.end(), pins.begin(), pins.end());
        netlist.cells.add(made);
    };
    cell(CellType::inverter, {q}, p);
    cell(CellType::inverter, {p}, q);
    cell(CellType::or_gate, std::vector<NetId>(100, a), wide);
    netlist.outputs = {{"X1", p}, {"same", a}};
    netlist.step_count = 1;
    netlist.modules = {{"all", "", 0, 3}};
    REQUIRE(fault_of(netlist) == "");
    CHECK(faults_of(netlist) == "");
    netlist.modules.clear();
    CHECK(faults_of(netlist) == "");
}

TEST_CASE("schematics: what nets are called") {
    const auto grafcet = read_grafcet(
        "grafcet g\ninput a, b\noutput A\ngraph G {\n initial 1\n step 2 : A\n"
        " (1) 1 -> 2 : ↑a\n (2) 2 -> 1 : 3s/X2 . /b\n}\n");
    REQUIRE(grafcet);
    const auto netlist = netlist_of(*grafcet, style_table[0], true);
    REQUIRE(netlist);
    const std::vector<std::string> names = shown_names(*netlist, drivers_of(*netlist));
    const auto shown = [&](std::string_view name) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (netlist->names[static_cast<NetId>(i)] == name) return names[i];
        }
        return std::string("no such net");
    };
    CHECK(shown("X1") == "X1");
    CHECK(shown("X1$not") == "/X1");
    CHECK(shown("Init$not$buf") == "/Init′");
    CHECK(shown("T2$clear") == "(2)");
    CHECK(shown("a$rise0") == "↑a");
    CHECK(shown("X2$timer0") == "3s/X2");
    CHECK(shown("X1$hold") == "X1$hold");
}

}  // namespace grafwire::testing
