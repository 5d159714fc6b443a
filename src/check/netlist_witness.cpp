// A difference counts only if it can be shown again: the stimuli are run once more from the start,
// through the reference on the one side and from power-up through the gates on the other, with real
// moments and real lengths of delays, and the first moment at which the two differ is the witness.
//
// A value that comes out unknown is no difference yet: three-valued simulation is pessimistic. It
// comes from memories whose value at power-up is not known, so such values are tried until one
// leads to a wrong value that is known.

#include "check/netlist_witness.h"

#include "evolution/run.h"
#include "netlist/loops.h"
#include "simulate/simulate.h"

namespace grafwire {

namespace {

constexpr int most_power_ups = 64;

/// Whether a value that comes out unknown is really left open: some power-up of the memories that
/// nothing is known of leads to a difference between known values, or to no rest at all.
bool is_left_open(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                  const Stimuli& stimuli, const RunResult& expected, Time period) {
    SimulateOptions options;
    options.scan_period = period;
    for (int number = 0; number < most_power_ups; ++number) {
        const std::vector<Netlist::InitialValue> values = power_up_values(netlist, number);
        if (values.empty()) return false;
        const Netlist powered = with_power_up(netlist, values);
        const SimulateResult got = simulate(grafcet, powered, delays, stimuli, options);
        const auto witness =
            first_difference(grafcet, stimuli, expected, got.trace, got.unsettled_at);
        if (witness && witness->kind != DifferenceKind::race) return true;
    }
    return false;
}

}  // namespace

std::vector<Netlist::InitialValue> power_up_values(const Netlist& netlist, int number) {
    std::uint64_t random = 0x9e3779b97f4a7c15U * static_cast<std::uint64_t>(number + 1);
    const auto next_value = [&] {
        if (number < 2) return number == 1;
        random = random * 6364136223846793005U + 1442695040888963407U;
        return (random >> 63U) != 0;
    };
    std::vector<std::uint8_t> is_known(netlist.net_count());
    for (const Netlist::InitialValue& initial : netlist.initial_values) {
        is_known[index_of(initial.net)] = 1;
    }
    // A net that is held at its initial value until the others rest closes no loop for them.
    Netlist cut = netlist;
    for (Cell& cell : cut.cells) {
        if (is_known[index_of(cell.output)] != 0) cell.pin_count = 0;
    }
    const std::vector<std::uint8_t> on_loop = cells_on_loops(cut);
    std::vector<Netlist::InitialValue> values;
    for (std::size_t i = 0; i < netlist.cells.size(); ++i) {
        const Cell& cell = netlist.cells.items()[i];
        const bool is_open = row_of(cell.type).has_memory
                                 ? cell.initial == Logic::unknown
                                 : on_loop[i] != 0 && is_known[index_of(cell.output)] == 0;
        if (is_open) values.push_back({cell.output, next_value()});
    }
    return values;
}

Netlist with_power_up(const Netlist& netlist, const std::vector<Netlist::InitialValue>& values) {
    Netlist powered = netlist;
    const Table<NetId, CellId> drivers = drivers_of(netlist);
    for (const Netlist::InitialValue& value : values) {
        Cell& cell = powered.cells[drivers[value.net]];
        if (row_of(cell.type).has_memory) {
            cell.initial = logic_of(value.value);
        } else {
            powered.initial_values.push_back(value);
        }
    }
    return powered;
}

std::optional<Witness> replay(const Grafcet& grafcet, const Netlist& netlist,
                              const CellDelays& delays, const Stimuli& stimuli, Time period) {
    const RunResult expected =
        period == 0 ? run_until_stable(grafcet, stimuli) : run_scans(grafcet, stimuli, period);
    SimulateOptions options;
    options.scan_period = period;
    const SimulateResult got = simulate(grafcet, netlist, delays, stimuli, options);
    auto witness = first_difference(grafcet, stimuli, expected, got.trace, got.unsettled_at);
    if (!witness) return std::nullopt;
    witness->scan_period = period;
    if (witness->kind == DifferenceKind::race) {
        if (!is_left_open(grafcet, netlist, delays, stimuli, expected, period)) return std::nullopt;
        if (witness->stimuli.end == 0) witness->kind = DifferenceKind::power_up;
    }
    return witness;
}

}  // namespace grafwire
