#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "check/partial_inputs.h"
#include "evolution/evolution.h"

namespace grafwire {

/// What the reference does in one case, down to the outputs that a netlist is compared with.
struct ReferenceOutcome {
    bool stable = true;
    std::vector<std::string> changing;  ///< not stable: what keeps changing
    EvolutionState state;               ///< at the end
    OutputValues outputs;               ///< there
    /// For clocked netlists: situation and outputs after every scan of the instant.
    struct Scan {
        BitTable situation;
        OutputValues outputs;
    };
    std::vector<Scan> scans;
    /// The inputs of the case, closed (to 0) where the reference looked at them while they were
    /// open.
    PartialInputs inputs;
    /// The inputs closed that way, in order.
    std::vector<std::uint32_t> closed;
};

/// Runs the reference through the cases that leave a state, opening only those inputs that it looks
/// at (see the comment in the source on why that is sound).
class ReferenceCases {
  public:
    ReferenceCases(const Evolution& evolution, bool scan_by_scan)
        : evolution_(evolution), scan_by_scan_(scan_by_scan) {}

    /// One instant from `start` (none: the start of the GRAFCET), after the given delays have
    /// ended, with open inputs taken as 0 but noted when looked at.
    ReferenceOutcome run(const EvolutionState* start, const std::vector<std::uint32_t>& ended,
                         const PartialInputs& inputs) const;

    /// One scan at moment `now`, with the lengths of delays, for devices that are executed scan by
    /// scan; otherwise the same.
    ReferenceOutcome scan(const EvolutionState* start, const PartialInputs& inputs, Time now) const;

    /// The inputs, among those not open, that a further instant with the same inputs does not look
    /// at (nor does the GRAFCET while nothing else changes). Outputs do not count.
    std::vector<std::uint32_t> unread_inputs(const EvolutionState& state,
                                             const PartialInputs& inputs) const;

  private:
    void run_scans(ReferenceOutcome& outcome, const EvolutionInputs& inputs) const;

    const Evolution& evolution_;
    bool scan_by_scan_;
};

/// All cases that inputs, some of them open, stand for: `run` runs the reference under them (see
/// ReferenceCases), and `visit` is given what came of it, once for every way to close the inputs
/// that were looked at; it says whether to go on. What breaks the assumptions is left out.
void for_each_case(const Assumptions& assumptions, const PartialInputs& inputs,
                   const std::function<ReferenceOutcome(const PartialInputs&)>& run,
                   const std::function<bool(const ReferenceOutcome&)>& visit);

}  // namespace grafwire
