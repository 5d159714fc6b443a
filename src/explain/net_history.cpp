#include "explain/net_history.h"

#include <algorithm>

namespace grafwire {

namespace {

/// The values of all nets once the netlist has been initialised with the inputs of moment 0.
std::vector<Logic> start_values(const Grafcet& grafcet, const Netlist& netlist,
                                const CellDelays& delays, const Stimuli& stimuli) {
    std::vector<Logic> inputs(grafcet.all_input_count(), Logic::zero);
    for (const Stimuli::Change& change : stimuli.changes) {
        if (change.at > 0) break;
        for (const auto& [input, value] : change.assignments) {
            inputs[input] = logic_of(value);
        }
    }
    Simulator simulator(netlist, delays);
    initialise(simulator, grafcet, netlist, map_ports(grafcet, netlist), inputs);
    std::vector<Logic> values;
    for (std::size_t net = 0; net < netlist.net_count(); ++net) {
        values.push_back(simulator.value(static_cast<NetId>(net)));
    }
    return values;
}

}  // namespace

NetHistory::NetHistory(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                       const Witness& witness)
    : start(start_values(grafcet, netlist, delays, witness.stimuli)) {
    SimulateOptions options;
    options.scan_period = witness.scan_period;
    options.observer = [&](Time at, NetId net, Logic value) {
        changes.push_back({at, net, value});
    };
    oscillating = simulate(grafcet, netlist, delays, witness.stimuli, options).oscillating;
    const auto first = std::find_if(changes.begin(), changes.end(), [&](const NetChange& change) {
        return change.at >= witness.stimuli.end;
    });
    first_of_end = static_cast<std::size_t>(first - changes.begin());
}

std::vector<Logic> NetHistory::before_end() const {
    std::vector<Logic> values = start;
    for (std::size_t i = 0; i < first_of_end; ++i) {
        values[index_of(changes[i].net)] = changes[i].value;
    }
    return values;
}

}  // namespace grafwire
