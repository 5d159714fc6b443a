// How much the check looks at for two of the examples, to the last case. A check that forgets to
// look at something, or looks at the same thing again and again, mostly comes to the same verdict;
// it does not come to the same numbers.

#include <doctest/doctest.h>
#include <fmt/core.h>

#include "check/check_equivalence.h"
#include "examples/example.h"
#include "support/reviewed_file.h"

namespace grafwire::testing {

namespace {

/// Without a style that refuses the chart, nothing.
std::string coverage_of(const Example& example, const StyleRow& style, bool has_modes,
                        Changes changes) {
    static constexpr const char* verdicts[] = {"equivalent", "different", "undecided"};
    const Equations equations = equations_from(example.grafcet, {style.default_cdx, has_modes});
    Diagnostics diagnostics;
    const auto netlist = netlist_from(example.grafcet, equations, style.style, diagnostics);
    if (!netlist) return {};
    CheckOptions options;
    options.changes = changes;
    const CheckResult result = check_changes(example.grafcet, *netlist, options);
    const Coverage& coverage = result.coverage;
    return fmt::format("{:<13}{:<9}{:<6}{:<8}{:<11}{:>10}{:>7}{:>9}\n", example.name, style.name,
                       has_modes ? "on" : "off", changes == Changes::one ? "one" : "many",
                       verdicts[static_cast<std::size_t>(result.verdict)], coverage.situations,
                       coverage.cases, coverage.unstable);
}

}  // namespace

// coverage.txt is renewed by `tools/bless --tables`.
TEST_CASE("the check of two examples takes as many cases as it should") {
    std::string table =
        "example      style    modes changes verdict    situations  cases unstable\n";
    for (const char* name : {"manipulator", "nine-steps"}) {
        for (const StyleRow& style : style_table) {
            for (const bool has_modes : {true, false}) {
                for (const Changes changes : {Changes::one, Changes::many}) {
                    // A clocked netlist samples its inputs: there it is the same.
                    if (style.style == Style::clocked && changes == Changes::many) continue;
                    table += coverage_of(example_named(name), style, has_modes, changes);
                }
            }
        }
    }
    check_reviewed("examples/coverage.txt", table);
}

}  // namespace grafwire::testing
