#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "check/partial_inputs.h"
#include "evolution/evolution.h"
#include "text/keep_going.h"

namespace grafwire {

/// What the reference does in one case, down to the outputs that a netlist is compared with.
struct ReferenceOutcome {
    bool stable = true;
    bool broken_off = false;            ///< the check is to stop; the rest is of no meaning
    std::vector<std::string> changing;  ///< not stable: what keeps changing
    EvolutionState state;               ///< at the end
    OutputValues outputs;               ///< there
    std::vector<std::uint8_t> cleared;  ///< per transition, 1 where it was cleared
    /// The inputs of the case, assigned (0) where the reference looked at them while they were
    /// unassigned.
    PartialInputs inputs;
    /// The inputs assigned that way, in order.
    std::vector<std::uint32_t> assigned;
};

/// Runs the reference through the cases that leave a state, assigning only those inputs that it
/// looks at (see the comment in the source on why that is sound).
class ReferenceCases {
  public:
    ReferenceCases(const Evolution& evolution, KeepGoing keep_going)
        : evolution_(evolution), keep_going_(std::move(keep_going)) {}

    /// One instant from `start` (none: the start of the GRAFCET), until stable. The given delays
    /// are due at it. Unassigned inputs are taken as 0 but noted when looked at.
    ReferenceOutcome instant(const EvolutionState* start, const std::vector<std::uint32_t>& due,
                             const PartialInputs& inputs) const;

    /// How often the reference changes each X and output in such an instant, X first, as it goes
    /// through its transient situations; at most `most_changes`. `before` holds their values before
    /// it. The inputs that are looked at while they are unassigned are taken as 0, and named.
    struct Changes {
        std::vector<std::uint8_t> counts;
        std::vector<std::uint32_t> assigned;
    };
    static constexpr std::uint8_t most_changes = 250;
    Changes changes(const EvolutionState& start, const std::vector<std::uint32_t>& due,
                    const PartialInputs& inputs, const std::vector<Logic>& before) const;

    /// One scan, by which the given delays have fallen due; otherwise the same.
    ReferenceOutcome scan_after(const EvolutionState* start, const std::vector<std::uint32_t>& due,
                                const PartialInputs& inputs) const;

    /// One scan at time `now`, with the lengths of delays, for devices that are executed scan by
    /// scan; otherwise the same.
    ReferenceOutcome scan(const EvolutionState* start, const PartialInputs& inputs, Time now) const;

    /// The inputs, among those assigned, that a further instant with the same inputs does not look
    /// at (nor does the GRAFCET while nothing else changes). Outputs do not count.
    std::vector<std::uint32_t> unread_inputs(const EvolutionState& state,
                                             const PartialInputs& inputs) const;

  private:
    const Evolution& evolution_;
    KeepGoing keep_going_;
};

/// All cases that partial inputs stand for: `run` runs the reference under them (see
/// ReferenceCases), and `visit` is given what came of it, once for every way to assign the inputs
/// that were looked at; it says whether to go on. What breaks the assumptions is left out.
void for_each_case(const Assumptions& assumptions, const PartialInputs& inputs,
                   const std::function<ReferenceOutcome(const PartialInputs&)>& run,
                   const std::function<bool(const ReferenceOutcome&)>& visit);

}  // namespace grafwire
