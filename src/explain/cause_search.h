#pragma once

#include <optional>
#include <vector>

#include "explain/causal_chain.h"
#include "explain/compare_functions.h"
#include "explain/explain.h"
#include "explain/explanation_writer.h"

namespace grafwire {

/// What is known of a witness when its cause is looked for. Everything referred to must outlive it.
struct WitnessFacts {
    const Grafcet& grafcet;
    const Netlist& netlist;
    const CellDelays& delays;
    const Witness& witness;
    const NetHistory& history;
    const ReferenceEnd& reference;
    const NetReader& reader;
    CdxForm cdx = CdxForm::successor;  ///< that the netlist has
    struct WrongStep {
        StepId step{};
        bool expected = false;
        FunctionComparison comparison;
        bool is_decided = false;  ///< a fault shows in the values at the end of the witness
    };
    std::vector<WrongStep> steps;   ///< that are wrong or keep changing
    bool has_wrong_output = false;  ///< an output has another equation, and that shows
};

/// The cause, where it is a known one. It is found in what happened (the values of the nets, the
/// transitions the reference cleared) and in the structure of the GRAFCET, and only where the
/// netlist has the right equations; a race of inputs by trying them one after the other.
std::optional<Cause> cause_of(const WitnessFacts& facts);

}  // namespace grafwire
