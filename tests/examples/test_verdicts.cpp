// In which styles the wiring of an example is sound: as the table of examples/README.md says.

#include <doctest/doctest.h>

#include <algorithm>

#include "check/check_equivalence.h"
#include "examples/example.h"
#include "simulate/simulate.h"

namespace grafwire::test {

namespace {

/// What takes too long to explore in full; within the bound there is no difference.
struct Bound {
    std::string_view example;
    std::string_view style;
    std::uint64_t max_cases;
};
constexpr Bound bounds[] = {
    {"manipulator-modes", "clocked", 200'000},
    {"batch-counter", "clocked", 200'000},
    {"level-crossing", "clocked", 100'000},
};

std::uint64_t bound_of(const Example& example, std::string_view style) {
    std::uint64_t bound = 0;
    for (const Bound& item : bounds) {
        if (item.example == example.name && item.style == style) bound = item.max_cases;
    }
    constexpr std::uint64_t bound_of_slow_builds = 2'000;
    return is_slow_build && (bound == 0 || bound > bound_of_slow_builds) ? bound_of_slow_builds
                                                                         : bound;
}

bool is_sound(const Example& example, std::string_view style) {
    return std::count(example.sound_in.begin(), example.sound_in.end(), style) != 0;
}

CheckResult check(const Example& example, const Netlist& netlist, std::uint64_t max_cases) {
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
            const std::uint64_t bound = bound_of(example, row.name);
            const CheckResult result = check(example, *netlist, bound);
            CHECK(result.impossible_timings == 0);
            if (is_sound(example, row.name)) {
                CHECK(result.verdict != Verdict::different);
                CHECK(!result.witness);
                // Undecided only where the bound was reached.
                CHECK((result.verdict == Verdict::equivalent) == result.complete);
                if (!result.complete) CHECK((bound != 0 && result.coverage.cases >= bound));
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
