#pragma once

#include <cstdint>
#include <random>
#include <string_view>

#include "check/check_equivalence.h"
#include "check/netlist_witness.h"

namespace grafwire::testing {

/// The check of a netlist under a delay model, without the remark about many changes.
inline CheckResult checked(const Grafcet& grafcet, const Netlist& netlist, std::string_view delays,
                           std::uint64_t max_cases = 0) {
    CheckOptions options;
    options.delays = *delay_model_of(delays);
    options.looks_at_many = false;
    options.max_cases = max_cases;
    return check_equivalence(grafcet, netlist, options);
}

/// One change of an input every 10 ms.
inline Stimuli single_changes(std::mt19937& random, const Grafcet& grafcet) {
    Stimuli stimuli;
    stimuli.changes.push_back({0, {}, {}});
    std::vector<bool> values(grafcet.inputs.size());
    for (Time at = 1; at <= 12; ++at) {
        const auto input = static_cast<std::uint32_t>(random() % values.size());
        values[input] = !values[input];
        stimuli.end = at * 10 * millisecond;
        stimuli.changes.push_back({stimuli.end, {{input, values[input]}}, {}});
    }
    return stimuli;
}

/// Whether the delays of a witness show it in a simulation.
inline bool replays(const Grafcet& grafcet, const Netlist& netlist, const Witness& witness,
                    std::string_view delays) {
    const CellDelays nominal = cell_delays(netlist, *delay_model_of(delays));
    const Netlist powered = with_power_up(netlist, witness.power_up);
    const auto again = replay(grafcet, powered, nominal, witness.stimuli, 0, witness.delays);
    return again && again->kind == witness.kind;
}

}  // namespace grafwire::testing
