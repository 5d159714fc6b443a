// Runs of random charts over random stimuli: of the reference, until stable and scan by scan, and
// of the gates in every style with the waveform of every net.

#include <fmt/core.h>

#include "pinned/pinned_charts.h"
#include "pinned/pinned_table.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "referee/graft.h"
#include "workflow/netlists.h"
#include "workflow/runs.h"

namespace grafwire::testing {

namespace {

constexpr std::uint64_t first_run_seed = 43'000'000;
constexpr std::uint64_t run_charts = 240;

/// Every third chart is small, so that more of it is exercised.
Features features_of(std::uint64_t seed) {
    return seed % 3 == 0 ? Features::small() : Features{};
}

std::optional<Time> period_of(std::uint64_t seed) {
    if (seed % 2 == 0) return std::nullopt;
    return (1 + seed % 7) * 5 * millisecond;
}

std::string text_of(const RunResult& result) {
    std::string text = write_csv(result.trace);
    if (result.unstable_at) text += fmt::format("unstable at {}\n", *result.unstable_at);
    for (const std::string& name : result.changing) text += name + "\n";
    for (const auto& broken : result.broken_assumptions) {
        text += fmt::format("assumption {} at {}\n", broken.assumption, broken.at);
    }
    return text;
}

std::string text_of(const SimulateResult& result, const Netlist& netlist) {
    std::string text = write_csv(result.trace) + result.waveform.vcd;
    if (result.unsettled_at) {
        text += fmt::format("unsettled at {}: {}\n", *result.unsettled_at,
                            oscillating_cells(netlist, result.oscillating).english);
    }
    return text;
}

/// The gates as they are made, and with something foreign among them.
PinnedCase pinned_gates(const Chart& chart, const Netlist& netlist, const Stimuli& stimuli,
                        std::uint64_t seed) {
    PinnedCase pinned;
    RandomSource random(seed);
    std::string told;
    const Netlist foreign = grafted(netlist, random, told);
    for (const Netlist* run : {&netlist, &foreign}) {
        const SimulateResult result =
            simulate_gates(chart, *run, stimuli, DelayModel{},
                           run->is_clocked() ? period_of(seed) : std::nullopt, true);
        pinned.add(fmt::format("{} rows, {} events", result.trace.row_count(), result.events),
                   (run == &foreign ? told : "as made") + "\n" + text_of(result, *run));
    }
    return pinned;
}

void pin_runs(PinnedTable& table, std::uint64_t seed) {
    const RandomCase item = random_case(first_run_seed + seed, features_of(seed), 14);
    const Chart chart = pinned_chart(item.chart);
    const auto stimuli = read_stimuli(item.stimuli, chart.grafcet);
    REQUIRE(stimuli);
    PinnedCase reference;
    for (const auto period : {std::optional<Time>(), std::optional<Time>(7 * millisecond)}) {
        const RunResult result = run_reference(chart, *stimuli, period);
        reference.add(fmt::format("{} rows", result.trace.row_count()), text_of(result));
    }
    table.add(fmt::format("{:03} reference", seed), reference);
    for (const StyleRow& row : style_table) {
        NetlistOptions options;
        options.style = row.style;
        Diagnostics diagnostics;
        const auto netlist = make_netlist(chart, options, diagnostics);
        if (!netlist) continue;
        table.add(fmt::format("{:03} {}", seed, row.name),
                  pinned_gates(chart, *netlist, *stimuli, seed));
    }
}

}  // namespace

TEST_CASE("pinned: runs") {
    PinnedTable table("runs.txt");
    for (std::uint64_t seed = 0; seed < run_charts; seed += pinned_stride) pin_runs(table, seed);
    table.finish(!is_slow_build);
}

}  // namespace grafwire::testing
