#pragma once

#include <vector>

#include "equations/equations.h"
#include "text/diagnostics.h"

namespace grafwire {

/// Something in the structure of a GRAFCET that asynchronous wiring may get wrong.
struct WiringHazard {
    enum class Kind {
        /// Two steps follow each other: in the successor form `step` is reset by the very steps
        /// from which `back` sets it. `out` is the transition from it to these; where a step
        /// follows itself, both are the same.
        step_loop,
        /// `step` and all steps after `out` can be active together without `out` being cleared: in
        /// the successor form they reset it.
        two_tokens,
        /// `out` follows `back` by `step`, and both read `edge`: a pulse that is longer than the
        /// passage through the step clears both, in either form.
        repeated_edge,
    };
    Kind kind = Kind::step_loop;
    StepId step{};
    TransitionId out{};
    TransitionId back{};    ///< of two_tokens without meaning
    ExprId edge = no_expr;  ///< repeated_edge: in the pool of the GRAFCET
};

/// All of them, by kind, then in the order of the steps.
std::vector<WiringHazard> wiring_hazards(const Grafcet& grafcet);

/// Warns of those that matter to wiring in this form of CDX, with what helps.
void warn_of_wiring(const Grafcet& grafcet, CdxForm cdx, Diagnostics& diagnostics);

}  // namespace grafwire
