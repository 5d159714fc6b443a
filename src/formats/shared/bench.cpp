// A netlist is let go before its stimuli begin: during the start Init is 1 and the other inputs are
// as the stimuli have them at instant 0. At 0 Init goes back, and then the stimuli count.

#include "formats/shared/bench.h"

#include <algorithm>
#include <map>

namespace grafwire {

Bench bench_from(const Netlist& netlist, const Stimuli& stimuli, std::vector<Time> instants) {
    Bench bench;
    for (const Stimuli::Change& change : stimuli.changes) {
        Bench::Change item{change.at, {}};
        for (const Stimuli::Assignment& assignment : change.assignments) {
            // Without modes the netlist has no Init, AUdur and AUdoux; the clock is not the
            // stimuli's affair.
            if (assignment.input >= netlist.inputs.size()) continue;
            if (netlist.inputs[assignment.input].net == netlist.clock) continue;
            item.assignments.push_back({assignment.input, assignment.value});
        }
        bench.changes.push_back(std::move(item));
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

Time sampling_delay(const Bench& bench, std::size_t row) {
    if (row + 1 == bench.instants.size()) return bench.settling;
    const Time gap = bench.instants[row + 1] - bench.instants[row];
    return std::min(bench.settling, gap - gap / 10);
}

std::vector<bool> starting_inputs(const Netlist& netlist, const Bench& bench) {
    std::vector<bool> values(netlist.inputs.size());
    if (!bench.changes.empty() && bench.changes.front().at == 0) {
        for (const Bench::Assignment& assignment : bench.changes.front().assignments) {
            values[assignment.input] = assignment.value;
        }
    }
    if (!netlist.has_modes) return values;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string& name = netlist.inputs[i].name;
        if (name == "Init") values[i] = true;
        if (name == "AUdur" || name == "AUdoux") values[i] = false;
    }
    return values;
}

std::vector<BenchEvent> bench_events(const Netlist& netlist, const Bench& bench) {
    // All that is assigned at each moment, whether it changes anything or not.
    std::map<Time, BenchEvent> moments;
    std::vector<Bench::Assignment>& at_zero = moments[0].assignments;
    std::vector<bool> first(netlist.inputs.size());
    const Time last = bench.instants.empty() ? 0 : bench.instants.back();
    for (const Bench::Change& change : bench.changes) {
        if (change.at > last) break;
        if (change.at != 0) {
            moments[change.at].assignments = change.assignments;
            continue;
        }
        for (const Bench::Assignment& item : change.assignments) first[item.input] = item.value;
    }
    for (std::uint32_t i = 0; i < first.size(); ++i) {
        at_zero.push_back({i, first[i]});
    }
    for (std::size_t row = 0; row < bench.instants.size(); ++row) {
        moments[bench.instants[row]].row = row;
    }
    // Only changes stay.
    std::vector<bool> values = starting_inputs(netlist, bench);
    std::vector<BenchEvent> events;
    for (const auto& [at, moment] : moments) {
        BenchEvent& event = events.emplace_back(BenchEvent{at, {}, moment.row});
        for (const Bench::Assignment& item : moment.assignments) {
            if (values[item.input] == item.value) continue;
            values[item.input] = item.value;
            event.assignments.push_back(item);
        }
    }
    return events;
}

}  // namespace grafwire
