// Runs over stimuli, and what users must be told about them: which cells keep changing, which
// assumption the stimuli break, which inputs a listing does not have.

#include "workflow/runs.h"

#include <fmt/format.h>

#include <algorithm>

#include "explain/gate_story.h"
#include "explain/write_gate_story.h"
#include "grafcet/write_grafcet.h"
#include "story/write_story.h"
#include "text/joined.h"
#include "trace/input_values.h"
#include "workflow/messages.h"

namespace grafwire {

RunResult run_reference(const Chart& chart, const Stimuli& stimuli, std::optional<Time> period) {
    return period ? run_scans(chart.grafcet, stimuli, *period)
                  : run_until_stable(chart.grafcet, stimuli);
}

ToldRun tell_reference(const Chart& chart, const Stimuli& stimuli, std::optional<Time> period) {
    return tell_run(chart.grafcet, stimuli, period);
}

std::string explain_run(const Chart& chart, const ToldRun& run, Language language) {
    return write_stories(chart.grafcet, run.stories, language);
}

namespace {

SimulateOptions options_for(const GateDelays& delays, std::optional<Time> period,
                            bool with_waveform) {
    SimulateOptions options;
    options.schedule = delays.schedule;
    options.waveform = with_waveform;
    options.scan_period = period.value_or(0);
    return options;
}

}  // namespace

SimulateResult simulate_gates(const Chart& chart, const Netlist& netlist, const Stimuli& stimuli,
                              const GateDelays& delays, std::optional<Time> period,
                              bool with_waveform) {
    return simulate(chart.grafcet, netlist, cell_delays(netlist, delays.model), stimuli,
                    options_for(delays, period, with_waveform));
}

ExplainedSimulation explain_gates(const Chart& chart, const Netlist& netlist,
                                  const Stimuli& stimuli, const GateDelays& delays,
                                  std::optional<Time> period, bool with_waveform,
                                  Language language) {
    ToldSimulation told =
        tell_simulation(chart.grafcet, netlist, cell_delays(netlist, delays.model), stimuli,
                        options_for(delays, period, with_waveform));
    return {std::move(told.result),
            write_gate_stories(chart.grafcet, netlist, told.stories, language)};
}

Localized oscillating_cells(const Netlist& netlist, const std::vector<NetId>& nets) {
    constexpr std::size_t most = 12;
    const Table<NetId, CellId> drivers = drivers_of(netlist);
    const auto cells_in = [&](Language language) {
        std::vector<std::string> names;
        for (const NetId net : nets) {
            if (drivers[net] == no_cell) continue;
            names.push_back(cell_description(netlist, drivers[net], language));
        }
        const bool cut = names.size() > most;
        if (cut) names.resize(most);
        return fmt::format("{}{}", joined(names, ", "), cut ? ", …" : "");
    };
    return {cells_in(Language::english), cells_in(Language::french)};
}

std::vector<RunResult::BrokenAssumption> broken_assumptions(const Grafcet& grafcet,
                                                            const Stimuli& stimuli) {
    std::vector<RunResult::BrokenAssumption> broken;
    StimuliPlayer player(stimuli, grafcet.all_input_count());
    for (const Stimuli::Change& change : stimuli.changes) {
        player.advance(change.at);
        const std::size_t found = broken_assumption(grafcet, player.inputs());
        const bool known = std::any_of(broken.begin(), broken.end(),
                                       [&](const auto& item) { return item.assumption == found; });
        if (found < grafcet.assumptions.size() && !known) broken.push_back({change.at, found});
    }
    return broken;
}

Localized broken_assumption_text(const Grafcet& grafcet,
                                 const RunResult::BrokenAssumption& broken) {
    return messages::workflow::broken_assumption(
        format_milliseconds(broken.at),
        write_expression(grafcet, grafcet.expressions,
                         grafcet.assumptions[broken.assumption].expression));
}

std::optional<ListingColumns> columns_of(const s7::Listing& listing,
                                         const s7::IoAssignment* assignment, const Chart* chart,
                                         Diagnostics& diagnostics) {
    s7::IoAssignment used = assignment != nullptr ? *assignment : s7::addresses_of(listing);
    ListingColumns columns;
    if (chart != nullptr) {
        columns.grafcet = chart->grafcet;
    } else {
        columns.grafcet = s7::names_of(used);
        // What is no column needs no address.
        std::erase_if(used.entries,
                      [&](const s7::IoAssignment::Entry& entry) { return !s7::is_shown(entry); });
    }
    auto binding = s7::bind(columns.grafcet, used, diagnostics);
    if (!binding) return std::nullopt;
    columns.binding = std::move(*binding);
    return columns;
}

std::vector<std::string> lost_inputs(const ListingColumns& columns, const Stimuli& stimuli) {
    std::vector<std::string> names;
    std::vector<bool> is_told(columns.binding.inputs.size(), false);
    for (const Stimuli::Change& change : stimuli.changes) {
        for (const Stimuli::Assignment& set : change.assignments) {
            if (columns.binding.inputs[set.input] || is_told[set.input]) continue;
            is_told[set.input] = true;
            names.emplace_back(input_name(columns.grafcet, set.input));
        }
    }
    return names;
}

}  // namespace grafwire
