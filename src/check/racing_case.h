#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <unordered_set>

#include "check/netlist_case.h"
#include "netlist/delay_model.h"
#include "settling/circuit.h"
#include "settling/settling_model.h"

namespace grafwire {

/// A netlist whose delays are not known exactly, case by case: restores the state left, applies the
/// change, and compares everything that the delay model lets become of it. What it is made of must
/// outlive it.
class RacingCases : public NetlistCases {
  public:
    /// `most_states`: of a case, before it is left open; none but those of the delay model where it
    /// is as large as can be.
    RacingCases(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& nominal,
                const DelayModel& model, const KeepGoing& keep_going,
                std::size_t most_states = std::numeric_limits<std::size_t>::max());

    bool is_worth_sharing() const override { return true; }
    NetlistOutcomes run(const SimulatorState* start, const PartialInputs& left,
                        const PathStep& step, const ReferenceOutcome& expected) override;
    std::optional<Witness> replay(const Stimuli& stimuli, Time period) const override;

  private:
    NetlistOutcome outcome_of(const Rest& rest, const SimulatorState& before, const PathStep& step,
                              const ReferenceOutcome& expected);
    std::vector<NetId> unknown_memory(const CircuitState& state) const;
    bool starts_by_init() const;
    std::string key_of(const Stimuli& stimuli) const;

    const DelayModel delay_model_;
    const std::size_t most_states_;
    const KeepGoing keep_going_;
    const Circuit circuit_;
    const std::unique_ptr<SettlingModel> model_;
    /// Stimuli for which no delays were found that make a difference, as keys.
    mutable std::unordered_set<std::string> without_difference_;
};

}  // namespace grafwire
