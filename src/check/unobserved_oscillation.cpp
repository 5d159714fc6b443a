// Oscillation where no X and no output looks.
//
// A ring of gates that nothing reads makes no X wrong, but it never comes to rest, which matters
// when it is wired. Its state is no part of the exploration, and in three values it may rest at
// unknown, where the real one goes on and on. So it is simulated in two values, along random walks
// of single changes. Only netlists that have such loops pay for it, and generated ones have none.

#include <algorithm>

#include "check/check_equivalence.h"
#include "check/netlist_case.h"
#include "check/netlist_witness.h"
#include "check/path.h"
#include "evolution/run.h"
#include "netlist/loops.h"
#include "simulate/simulate.h"

namespace grafwire {

namespace {

constexpr int walks = 16;
constexpr int instants = 60;

bool has_unobserved_loops(const Grafcet& grafcet, const Netlist& netlist) {
    const PortMap ports = map_ports(grafcet, netlist);
    std::vector<NetId> compared = ports.steps;
    compared.insert(compared.end(), ports.outputs.begin(), ports.outputs.end());
    const std::vector<std::uint8_t> relevant = cone_of_influence(netlist, compared);
    const std::vector<std::uint8_t> on_loop = cells_on_loops(netlist);
    for (std::size_t i = 0; i < on_loop.size(); ++i) {
        if (on_loop[i] != 0 && relevant[index_of(netlist.cells.items()[i].output)] == 0)
            return true;
    }
    return false;
}

/// The same numbers every time.
class Dice {
  public:
    explicit Dice(int seed) : state_(static_cast<std::uint64_t>(seed) * 0x9e3779b97f4a7c15U + 1) {}
    std::size_t below(std::size_t limit) {
        state_ = state_ * 6364136223846793005U + 1442695040888963407U;
        return static_cast<std::size_t>(state_ >> 33U) % limit;
    }

  private:
    std::uint64_t state_;
};

/// Single changes, one every 10 ms, the first instant with any inputs that the assumptions allow.
std::optional<Stimuli> walk(const Grafcet& grafcet, const Assumptions& assumptions, bool has_modes,
                            Dice& dice) {
    InputValues values(grafcet.all_input_count(), 0);
    for (std::size_t i = 0; i < grafcet.inputs.size(); ++i) {
        values[i] = static_cast<std::uint8_t>(dice.below(2));
    }
    const auto start = assumptions.complete(unassigned_inputs(grafcet, has_modes), values);
    if (!start) return std::nullopt;
    Stimuli stimuli;
    stimuli.changes.push_back({0, differences(InputValues(values.size(), 0), *start), {}});
    PartialInputs inputs = assigned_inputs(*start);
    values = *start;
    for (int instant = 1; instant < instants; ++instant) {
        std::vector<PartialInputs> changes = single_changes(assumptions, inputs, has_modes);
        if (changes.empty()) break;
        inputs = changes[dice.below(changes.size())];
        const InputValues next = *assumptions.complete(inputs, values);
        stimuli.end = instant * 10 * millisecond;
        stimuli.changes.push_back({stimuli.end, differences(values, next), {}});
        values = next;
    }
    return stimuli;
}

/// The values at power-up without which it would not oscillate.
std::vector<Netlist::InitialValue> values_needed(const Grafcet& grafcet, const Netlist& netlist,
                                                 const CellDelays& delays, const Witness& witness,
                                                 std::vector<Netlist::InitialValue> power_up) {
    for (std::size_t i = power_up.size(); i-- > 0;) {
        std::vector<Netlist::InitialValue> rest = power_up;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
        const auto again = replay(grafcet, with_power_up(netlist, rest), delays, witness.stimuli,
                                  witness.scan_period);
        if (again && again->kind == DifferenceKind::oscillation) power_up = std::move(rest);
    }
    return power_up;
}

}  // namespace

std::optional<Witness> find_unobserved_oscillation(const Grafcet& grafcet, const Netlist& netlist,
                                                   const CheckOptions& options,
                                                   bool has_uninitialised_memory) {
    if (!has_uninitialised_memory && !has_unobserved_loops(grafcet, netlist)) return std::nullopt;
    const Assumptions assumptions(grafcet);
    const Time period = !netlist.is_clocked() ? 0 : options.scan_period.value_or(10 * millisecond);
    const CellDelays delays = cell_delays(netlist, options.delays);
    for (int number = 0; number < walks; ++number) {
        if (options.keep_going && !options.keep_going()) return std::nullopt;
        Dice dice(number);
        const auto stimuli = walk(grafcet, assumptions, netlist.has_modes, dice);
        if (!stimuli) return std::nullopt;
        const std::vector<Netlist::InitialValue> power_up = power_up_values(netlist, number);
        const Netlist powered = with_power_up(netlist, power_up);
        auto witness = replay(grafcet, powered, delays, *stimuli, period);
        if (!witness || witness->kind != DifferenceKind::oscillation) continue;
        witness->power_up = values_needed(grafcet, netlist, delays, *witness, power_up);
        for (Witness::Value& value : witness->values) value.got = value.expected;
        return witness;
    }
    return std::nullopt;
}

}  // namespace grafwire
