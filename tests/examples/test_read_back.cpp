// Netlists written as BLIF and as Yosys JSON, read back and checked: the verdict is that of the
// netlist that was written.

#include <doctest/doctest.h>

#include <array>

#include "check/check_equivalence.h"
#include "check/compare_ports.h"
#include "examples/example.h"
#include "formats/blif/read_blif.h"
#include "formats/exporters.h"
#include "formats/yosys/read_yosys_json.h"
#include "simulate/simulator.h"

namespace grafwire::testing {

namespace {

std::optional<Netlist> read_back(std::string_view format, const Netlist& netlist) {
    Diagnostics diagnostics;
    const Exporter* exporter = exporter_named(format);
    REQUIRE(exporter != nullptr);
    const SourceFile source{"netlist", exporter->write(netlist, {}, diagnostics)};
    auto result =
        format == "blif" ? read_blif(source, diagnostics) : read_yosys_json(source, diagnostics);
    INFO("messages: " << format_diagnostics(diagnostics, source));
    CHECK(diagnostics.items().empty());
    return result;
}

CheckResult check(const Grafcet& grafcet, const Netlist& netlist) {
    CheckOptions options;
    options.max_cases = is_slow_build ? 500 : 5'000;
    return check_equivalence(grafcet, netlist, unit_delays(netlist), options);
}

}  // namespace

TEST_CASE("netlists of the examples, read back, get the same verdict for the same reason") {
    std::array<std::size_t, 3> verdicts{};
    for (const Example& example : examples()) {
        for (const StyleRow& row : style_table) {
            const auto netlist = netlist_of(example.grafcet, row);
            if (!netlist) continue;
            const CheckResult expected = check(example.grafcet, *netlist);
            for (const std::string_view format : {"blif", "json"}) {
                INFO("example: " << example.name << ", style: " << row.name
                                 << ", format: " << format);
                auto copy = read_back(format, *netlist);
                REQUIRE(copy.has_value());
                CHECK(fault_of(*copy) == "");
                REQUIRE(compare_ports(example.grafcet, *copy).fits());
                adopt_ports(example.grafcet, *copy);
                const CheckResult result = check(example.grafcet, *copy);
                CHECK(result.verdict == expected.verdict);
                CHECK(result.witness.has_value() == expected.witness.has_value());
                ++verdicts[static_cast<std::size_t>(result.verdict)];
            }
        }
    }
    // All three kinds have been met.
    for (const std::size_t count : verdicts) CHECK(count > 0);
}

}  // namespace grafwire::testing
