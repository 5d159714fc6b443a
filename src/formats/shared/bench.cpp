#include "formats/shared/bench.h"

#include <algorithm>

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

namespace {

/// The starting values, then what the changes make of them.
class InputTracker {
  public:
    explicit InputTracker(std::vector<bool> values) : values_(std::move(values)) {}

    void set(std::uint32_t input, bool value, std::vector<Bench::Assignment>& changed) {
        if (values_[input] == value) return;
        values_[input] = value;
        changed.push_back({input, value});
    }
    std::size_t size() const { return values_.size(); }

  private:
    std::vector<bool> values_;
};

}  // namespace

std::vector<BenchEvent> bench_events(const Netlist& netlist, const Bench& bench) {
    InputTracker inputs(starting_inputs(netlist, bench));
    std::vector<bool> first(inputs.size());
    std::size_t change = 0;
    if (!bench.changes.empty() && bench.changes.front().at == 0) {
        for (const Bench::Assignment& item : bench.changes.front().assignments) {
            first[item.input] = item.value;
        }
        ++change;
    }
    std::vector<BenchEvent> events(1);
    for (std::uint32_t i = 0; i < inputs.size(); ++i) {
        inputs.set(i, first[i], events[0].assignments);
    }
    std::size_t row = 0;
    if (!bench.instants.empty() && bench.instants[0] == 0) events[0].row = row++;
    while (row < bench.instants.size()) {
        const bool has_change =
            change < bench.changes.size() && bench.changes[change].at <= bench.instants[row];
        BenchEvent event;
        event.at = has_change ? bench.changes[change].at : bench.instants[row];
        if (has_change) {
            for (const Bench::Assignment& item : bench.changes[change++].assignments) {
                inputs.set(item.input, item.value, event.assignments);
            }
        }
        if (bench.instants[row] == event.at) event.row = row++;
        events.push_back(std::move(event));
    }
    return events;
}

}  // namespace grafwire
