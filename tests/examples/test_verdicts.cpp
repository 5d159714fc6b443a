// In which styles the wiring of an example is sound: as the table of examples/README.md says.

#include <doctest/doctest.h>

#include <algorithm>

#include "check/check_equivalence.h"
#include "examples/example.h"
#include "simulate/simulate.h"

namespace grafwire::test {

namespace {

/// 0: all there are.
constexpr std::uint64_t max_cases = is_slow_build ? 2'000 : 0;

bool is_sound(const Example& example, std::string_view style) {
    return std::count(example.sound_in.begin(), example.sound_in.end(), style) != 0;
}

CheckResult check(const Example& example, const Netlist& netlist) {
    CheckOptions options;
    options.max_cases = max_cases;
    return check_equivalence(example.grafcet, netlist, unit_delays(netlist), options);
}

/// The last rows of reference and gates on the stimuli of a witness differ.
bool replays(const Example& example, const Netlist& netlist, const Witness& witness) {
    const RunResult run = witness.scan_period == 0
                              ? run_until_stable(example.grafcet, witness.stimuli)
                              : run_scans(example.grafcet, witness.stimuli, witness.scan_period);
    SimulateOptions options;
    options.scan_period = witness.scan_period;
    const SimulateResult gates =
        simulate(example.grafcet, netlist, unit_delays(netlist), witness.stimuli, options);
    CHECK(run.broken_assumptions.empty());
    if (gates.unsettled_at) return !run.unstable_at;
    return !run.unstable_at && write_csv(run.trace) != write_csv(gates.trace);
}

}  // namespace

TEST_CASE("the column \"sound in\" holds names of styles, and the clocked style everywhere") {
    for (const Example& example : examples()) {
        INFO("example: " << example.name);
        CHECK(is_sound(example, "clocked"));
        for (const std::string& style : example.sound_in) {
            CHECK(std::any_of(style_table.begin(), style_table.end(),
                              [&](const StyleRow& row) { return row.name == style; }));
        }
    }
}

TEST_CASE("every example is equivalent in the styles in which it is sound, and in no other") {
    for (const Example& example : examples()) {
        for (const StyleRow& row : style_table) {
            INFO("example: " << example.name << ", style: " << row.name);
            const auto netlist = netlist_of(example.grafcet, row);
            if (!netlist) {
                CHECK(!is_sound(example, row.name));
                continue;
            }
            const CheckResult result = check(example, *netlist);
            if (is_sound(example, row.name)) {
                CHECK(!result.witness);
                if (result.complete) {
                    CHECK(result.verdict == Verdict::equivalent);
                } else {
                    // Only where the bound was reached.
                    CHECK(result.verdict == Verdict::undecided);
                    CHECK(max_cases != 0);
                    CHECK(result.coverage.cases >= max_cases);
                }
            } else if (result.verdict == Verdict::different) {
                REQUIRE(result.witness.has_value());
                CHECK(replays(example, *netlist, *result.witness));
            } else {
                CHECK_MESSAGE((is_slow_build && !result.complete),
                              "no difference where the README says there is one");
            }
        }
    }
}

}  // namespace grafwire::test
