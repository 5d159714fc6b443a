#pragma once

#include "netlist/styles/asynchronous.h"

namespace grafwire {

/// What the terms of CDX do while a transition into the step is being cleared.
enum class ResetWhileSet {
    blocked,  ///< nothing: they wait until the latch has been set
    open,     ///< they reach the latch, which is set and reset at once
};

/// The memory of a step as two cross-coupled NAND gates, one NAND a transition into the step and
/// one a term of CDX.
void make_nand_latch(AsynchronousBuild& build, const StepSignals& step, const GateMaker& gates,
                     ResetWhileSet reset);

}  // namespace grafwire
