// Every name that a maker of netlists gives to an inner net is explained: in all styles, for all
// examples and random charts, with timers counted or not.

#include <doctest/doctest.h>

#include <string>

#include "netlist/net_roles.h"
#include "netlist/netlist_builder.h"
#include "netlist/passes/counted_timers.h"
#include "netlist/styles/styles.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "support/chart_files.h"

namespace grafwire::testing {

namespace {

/// The first name with a part that says no role; empty if there is none. For charts whose names
/// hold no `$`.
std::string unexplained_name(const Netlist& netlist) {
    for (std::size_t i = 0; i < netlist.net_count(); ++i) {
        const std::string_view name = netlist.names[static_cast<NetId>(i)];
        for (std::size_t at = name.find('$'); at != std::string_view::npos;) {
            const std::size_t end = name.find('$', at + 1);
            const std::string_view part = name.substr(at + 1, end - at - 1);
            // A `$` more tells two nets apart.
            if (!part.empty() && role_of(name.substr(0, at), part) == nullptr) {
                return std::string(name);
            }
            at = end;
        }
    }
    return {};
}

/// Likewise, of the netlists of a chart in every style, those with clocked timers also as SPICE has
/// them.
std::string unexplained_name(const std::string& chart) {
    const auto grafcet = read_grafcet(chart);
    if (!grafcet) return "the chart";
    for (const StyleRow& row : style_table) {
        Diagnostics diagnostics;
        const Equations equations = equations_from(*grafcet, {row.default_cdx, true});
        const auto netlist = netlist_from(*grafcet, equations, row.style, diagnostics);
        if (!netlist) continue;
        std::string name = unexplained_name(*netlist);
        if (name.empty() && has_scan_timers(*netlist)) {
            name = unexplained_name(with_counted_timers(*netlist, 10 * millisecond).netlist);
        }
        if (!name.empty()) return std::string(row.name) + ": " + name;
    }
    return {};
}

}  // namespace

TEST_CASE("the parts of a name say roles") {
    const auto meaning = [](std::string_view owner, std::string_view part) {
        const NetRole* role = role_of(owner, part);
        return role == nullptr ? std::string() : std::string(role->meaning);
    };
    CHECK(meaning("X1", "hold") == "keeps the owner as it is");
    CHECK(meaning("X1", "q") == "the other gate of the latch");
    CHECK(meaning("n", "q2") == "bit N of the counter");
    CHECK(meaning("T0", "3") == "a gate of a condition of the owner");
    CHECK(meaning("timer", "3") == "time condition N of the chart, counted from 0");
    CHECK(meaning("edge", "3") == "edge N of the chart, counted from 0");
    CHECK(meaning("X1", "set").starts_with("sets the owner"));
    CHECK(meaning("X1", "setgo") == meaning("X1", "set0"));
    for (const std::string_view part : {"", "hold1", "Q", "se", "abc$"}) {
        CHECK(role_of("X1", part) == nullptr);
    }
}

TEST_CASE("the legend has what occurs, in the order of names") {
    NetlistBuilder builder("few", InnerNames::by_role);
    for (const char* name : {"a", "X1$set0", "X1$q", "X1$set0$not", "G$x", "b$"}) {
        builder.add_net(name);
    }
    CHECK(legend_of_roles(builder.netlist()) ==
          std::vector<std::string>{
              "$not   the owner inverted", "$q     the other gate of the latch",
              "$setT  sets the owner: of a step, by transition T; of others, write T"});
}

TEST_CASE("names in the netlists of all examples are explained") {
    for (const ChartFiles& example : example_charts()) {
        CAPTURE(example.name);
        CHECK(unexplained_name(example.chart) == "");
    }
}

TEST_CASE("names in the netlists of random charts are explained") {
    Features features;
    features.odd_names = false;
    check_property([](const RandomCase& item) { return unexplained_name(item.chart); }, features,
                   970'000, 150);
}

}  // namespace grafwire::testing
