// A netlist is let go before its stimuli begin: during the start Init is 1 and the other inputs are
// as the stimuli have them at instant 0. At 0 Init goes back, and then the stimuli count.

#include "formats/shared/bench.h"

#include <algorithm>

#include "trace/input_values.h"

namespace grafwire {

Bench bench_from(const Netlist& netlist, const Stimuli& stimuli, std::vector<Time> instants) {
    Bench bench;
    bench.stimuli = stimuli;
    for (Stimuli::Change& change : bench.stimuli.changes) {
        // Without modes the netlist has no Init, AUdur and AUdoux; the clock is not the stimuli's
        // affair.
        std::erase_if(change.assignments, [&](const Stimuli::Assignment& set) {
            return set.input >= netlist.inputs.size() ||
                   netlist.inputs[set.input].net == netlist.clock;
        });
    }
    if (instants.empty()) {
        instants.push_back(0);
        for (const Stimuli::Change& change : stimuli.changes) instants.push_back(change.at);
        instants.push_back(stimuli.end);
    }
    std::sort(instants.begin(), instants.end());
    instants.erase(std::unique(instants.begin(), instants.end()), instants.end());
    bench.instants = std::move(instants);
    return bench;
}

Bench idle_bench() {
    Bench bench;
    bench.instants = {0};
    return bench;
}

Time longest_sampling_delay(const Bench& bench, std::size_t row) {
    if (row + 1 == bench.instants.size()) return never;
    const Time gap = bench.instants[row + 1] - bench.instants[row];
    return gap - gap / 10;
}

Time sampling_delay(const Bench& bench, std::size_t row) {
    return std::min(bench.settling, longest_sampling_delay(bench, row));
}

std::vector<bool> starting_inputs(const Netlist& netlist, const Bench& bench) {
    StimuliPlayer player(bench.stimuli, netlist.inputs.size());
    player.advance(0);
    std::vector<bool> values(player.inputs().begin(), player.inputs().end());
    if (!netlist.has_modes) return values;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string& name = netlist.inputs[i].name;
        if (name == "Init") values[i] = true;
        if (name == "AUdur" || name == "AUdoux") values[i] = false;
    }
    return values;
}

std::vector<BenchEvent> bench_events(const Netlist& netlist, const Bench& bench) {
    std::vector<Time> moments = bench.instants;
    moments.push_back(0);
    const Time last = bench.instants.empty() ? 0 : bench.instants.back();
    for (const Stimuli::Change& change : bench.stimuli.changes) {
        if (change.at <= last) moments.push_back(change.at);
    }
    std::sort(moments.begin(), moments.end());
    moments.erase(std::unique(moments.begin(), moments.end()), moments.end());

    StimuliPlayer player(bench.stimuli, netlist.inputs.size());
    std::vector<bool> values = starting_inputs(netlist, bench);
    std::vector<BenchEvent> events;
    std::size_t row = 0;
    for (const Time at : moments) {
        BenchEvent& event = events.emplace_back(BenchEvent{at, {}, BenchEvent::no_row});
        if (row < bench.instants.size() && bench.instants[row] == at) event.row = row++;
        player.advance(at);
        for (std::uint32_t i = 0; i < values.size(); ++i) {
            const bool value = player.inputs()[i] != 0;
            if (values[i] == value) continue;
            values[i] = value;
            event.assignments.push_back({i, value});
        }
    }
    return events;
}

}  // namespace grafwire
