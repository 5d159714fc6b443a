// In which styles the wiring of an example is sound, and whether many inputs may change at once: as
// the table of examples/README.md says.

#include <doctest/doctest.h>

#include <algorithm>

#include "check/check_equivalence.h"
#include "examples/example.h"
#include "simulate/simulate.h"

namespace grafwire::testing {

namespace {

/// 0: all there are.
constexpr std::uint64_t max_cases = is_slow_build ? 2'000 : 0;

bool holds(const std::vector<std::string>& styles, std::string_view style) {
    return std::count(styles.begin(), styles.end(), style) != 0;
}

CheckResult check(const Example& example, const Netlist& netlist) {
    CheckOptions options;
    options.max_cases = max_cases;
    return check_equivalence(example.grafcet, netlist, options);
}

/// The last rows of reference and gates on the stimuli of a witness differ.
bool replays(const Example& example, const Netlist& netlist, const Witness& witness) {
    const RunResult run = witness.scan_period == 0
                              ? run_until_stable(example.grafcet, witness.stimuli)
                              : run_scans(example.grafcet, witness.stimuli, witness.scan_period);
    SimulateOptions options;
    options.scan_period = witness.scan_period;
    const SimulateResult gates =
        simulate(example.grafcet, netlist, cell_delays(netlist, {}), witness.stimuli, options);
    CHECK(run.broken_assumptions.empty());
    if (gates.unsettled_at) return !run.unstable_at;
    return !run.unstable_at && write_csv(run.trace) != write_csv(gates.trace);
}

/// Equivalent one input at a time; many at once as the README says.
void check_sound(const Example& example, std::string_view style, const CheckResult& result) {
    CHECK(!result.witness);
    if (!result.complete) {
        // Only where the bound was reached.
        CHECK(result.verdict == Verdict::undecided);
        CHECK(max_cases != 0);
        CHECK(result.coverage.cases >= max_cases);
        return;
    }
    CHECK(result.verdict == Verdict::equivalent);
    CHECK(result.never.none());
    if (style == "clocked") return;
    REQUIRE(result.together);
    if (is_slow_build && result.together->verdict == Verdict::undecided) return;
    CHECK(result.together->verdict ==
          (holds(example.sound_in, style) ? Verdict::equivalent : Verdict::different));
}

}  // namespace

TEST_CASE("the columns of styles hold names of styles, \"sound in\" the clocked one everywhere") {
    for (const Example& example : examples()) {
        INFO("example: " << example.name);
        CHECK(holds(example.sound_in, "clocked"));
        for (const auto* column : {&example.sound_in, &example.sound_one_at_a_time}) {
            for (const std::string& style : *column) {
                CHECK(std::any_of(style_table.begin(), style_table.end(),
                                  [&](const StyleRow& row) { return row.name == style; }));
            }
        }
    }
}

TEST_CASE("every example is equivalent in the styles in which it is sound, and in no other") {
    for (const Example& example : examples()) {
        for (const StyleRow& row : style_table) {
            INFO("example: " << example.name << ", style: " << row.name);
            const bool is_sound =
                holds(example.sound_in, row.name) || holds(example.sound_one_at_a_time, row.name);
            const auto netlist = netlist_of(example.grafcet, row);
            if (!netlist) {
                CHECK(!is_sound);
                continue;
            }
            const CheckResult result = check(example, *netlist);
            if (is_sound) {
                check_sound(example, row.name, result);
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

}  // namespace grafwire::testing
