// The clocked netlist is the reference, scan by scan and until stable, in every column of the
// trace.

#include <doctest/doctest.h>

#include <algorithm>

#include "evolution/run.h"
#include "netlist/passes/counted_timers.h"
#include "netlist/styles/styles.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "simulate/simulate.h"

namespace grafwire::testing {

namespace {

std::string compare(const Trace& expected, const Trace& got) {
    const std::string a = write_csv(expected);
    const std::string b = write_csv(got);
    return a == b ? "" : "reference\n" + a + "netlist\n" + b;
}

std::optional<Netlist> clocked(const Grafcet& grafcet) {
    const Equations equations = equations_from(grafcet, {CdxForm::transition, true});
    Diagnostics diagnostics;
    return netlist_from(grafcet, equations, Style::clocked, diagnostics);
}

SimulateResult cycles(const Grafcet& grafcet, const Netlist& netlist, const Stimuli& stimuli,
                      Time period) {
    SimulateOptions options;
    options.scan_period = period;
    return simulate(grafcet, netlist, cell_delays(netlist, {}), stimuli, options);
}

std::string clocked_scans(const RandomCase& item) {
    const auto grafcet = read_grafcet(item.chart);
    const auto stimuli = read_stimuli(item.stimuli, *grafcet);
    const auto netlist = clocked(*grafcet);
    if (!netlist) return "no netlist";
    if (const std::string fault = fault_of(*netlist); !fault.empty()) return fault;
    for (const Time period : {millisecond, 1500 * microsecond}) {
        const RunResult expected = run_scans(*grafcet, *stimuli, period);
        const SimulateResult got = cycles(*grafcet, *netlist, *stimuli, period);
        if (got.unsettled_at) return "the netlist does not settle within a scan";
        const std::string difference = compare(expected.trace, got.trace);
        if (!difference.empty()) return "every " + format_duration(period) + "\n" + difference;
    }
    return {};
}

/// The timers as counters of scans, as formats without timers have them.
std::string counted_scans(const RandomCase& item) {
    const auto grafcet = read_grafcet(item.chart);
    const auto stimuli = read_stimuli(item.stimuli, *grafcet);
    const auto netlist = clocked(*grafcet);
    if (!netlist) return "no netlist";
    for (const Time period : {millisecond, 1500 * microsecond}) {
        const CountedTimers counted = with_counted_timers(*netlist, period);
        if (const std::string fault = fault_of(counted.netlist); !fault.empty()) return fault;
        const RunResult expected = run_scans(*grafcet, *stimuli, period);
        const SimulateResult got = cycles(*grafcet, counted.netlist, *stimuli, period);
        const std::string difference = compare(expected.trace, got.trace);
        if (!difference.empty()) return "every " + format_duration(period) + "\n" + difference;
    }
    return {};
}

bool reads_condition_without_delay(const Expressions& pool, ExprId id) {
    if (pool.kind(id) == ExprKind::time_condition) {
        const TimeCondition& condition = pool.time_condition_of(id);
        if (condition.on_delay == 0 || condition.off_delay == 0) return true;
    }
    const auto operands = pool.operands(id);
    return std::any_of(operands.begin(), operands.end(), [&](ExprId operand) {
        return reads_condition_without_delay(pool, operand);
    });
}

/// Whether a time condition reads another that changes at once. Of that the reference knows the
/// value since the last scan at the beginning of an instant; the netlist works it out of what it is
/// made of, and has it under the new inputs already.
bool nests_condition_without_delay(const Grafcet& grafcet) {
    const Expressions& pool = grafcet.expressions;
    const auto& conditions = pool.time_conditions();
    return std::any_of(conditions.begin(), conditions.end(), [&](ExprId id) {
        return reads_condition_without_delay(pool, pool.time_condition_of(id).operand);
    });
}

std::string clocked_until_stable(const RandomCase& item) {
    const auto grafcet = read_grafcet(item.chart);
    if (nests_condition_without_delay(*grafcet)) return {};
    const auto stimuli = read_stimuli(item.stimuli, *grafcet);
    const auto netlist = clocked(*grafcet);
    if (!netlist) return "no netlist";
    const RunResult expected = run_until_stable(*grafcet, *stimuli);
    const SimulateResult got = cycles(*grafcet, *netlist, *stimuli, 0);
    if (got.unsettled_at != expected.unstable_at) {
        return "unstable: reference " +
               (expected.unstable_at ? format_milliseconds(*expected.unstable_at) : "never") +
               ", netlist " +
               (got.unsettled_at ? format_milliseconds(*got.unsettled_at) : "never") + "\n" +
               compare(expected.trace, got.trace);
    }
    return compare(expected.trace, got.trace);
}

}  // namespace

TEST_CASE("the clocked netlist is the reference scan by scan") {
    check_property(clocked_scans, Features(), 500'000, 4000, 15);
}

// The outer condition reads what the inner one becomes in the same scan.
TEST_CASE("time conditions within time conditions, scan by scan and until stable") {
    Features features = Features::small();
    features.time_conditions = 6;
    features.expression_depth = 4;
    check_property(clocked_scans, features, 650'000, 2000, 15);
    check_property(clocked_until_stable, features, 660'000, 2000, 15);
}

TEST_CASE("clocked timers as counters, scan by scan") {
    Features features = Features::small();
    features.time_conditions = 6;
    features.expression_depth = 4;
    check_property(counted_scans, features, 670'000, 2000, 15);
}

TEST_CASE("the clocked netlist is the reference until stable") {
    check_property(clocked_until_stable, Features(), 600'000, 5000, 15);
}

}  // namespace grafwire::testing
