// Netlists written as BLIF and as Yosys JSON, read back and checked: the verdict is that of the
// netlist that was written.

#include <doctest/doctest.h>

#include <array>

#include "check/check_equivalence.h"
#include "check/compare_ports.h"
#include "examples/example.h"
#include "formats/netlist_formats.h"
#include "simulate/simulator.h"

namespace grafwire::testing {

namespace {

std::optional<Netlist> read_back(const NetlistFormat& format, const Netlist& netlist) {
    Diagnostics diagnostics;
    const SourceFile source{"netlist", write_netlist(format, netlist)};
    auto result = format.read(source, diagnostics);
    INFO("messages: " << format_diagnostics(diagnostics, source));
    CHECK(diagnostics.items().empty());
    return result;
}

CheckResult check(const Grafcet& grafcet, const Netlist& netlist) {
    CheckOptions options;
    options.max_cases = is_slow_build ? 500 : 5'000;
    return check_equivalence(grafcet, netlist, options);
}

}  // namespace

TEST_CASE("netlists of the examples, read back, get the same verdict for the same reason") {
    std::array<std::size_t, 3> verdicts{};
    for (const Example& example : examples()) {
        for (const StyleRow& row : style_table) {
            const auto netlist = netlist_of(example.grafcet, row);
            if (!netlist) continue;
            const CheckResult expected = check(example.grafcet, *netlist);
            for (const NetlistFormat& format : netlist_formats()) {
                if (format.read == nullptr) continue;
                INFO("example: " << example.name << ", style: " << row.name
                                 << ", format: " << format.name);
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
