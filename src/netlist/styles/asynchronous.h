#pragma once

#include <vector>

#include "equations/equations.h"
#include "netlist/styles/chart_netlist.h"
#include "netlist/styles/logic_builder.h"

namespace grafwire {

/// All signals that meet in the phase module of one step; absent ones are no_net.
struct PhaseSignals {
    StepId step{};
    NetId x = no_net;  ///< to be driven
    bool initial = false;
    NetId init = no_net;  ///< Init
    NetId not_init = no_net;
    NetId not_au_dur = no_net;
    NetId forced_off = no_net;       ///< OR of the X that force the graph
    NetId forced_on = no_net;        ///< OR of the X whose orders list the step
    NetId enclosing = no_net;        ///< X of the enclosing step
    std::vector<NetId> link;         ///< factors of the activation link; empty where there is none
    std::vector<TransitionId> into;  ///< the transitions that lead to the step
    std::vector<std::vector<NetId>> cdx;  ///< CDX as a sum of products; empty: never deactivated
};

/// What the three asynchronous styles have in common while a netlist is made.
struct AsynchronousBuild {
    Equations& equations;
    ChartNetlist& builder;
    LogicBuilder& logic;
    StepTransitions links;
    std::vector<NetId> clearing;  ///< per transition: its clearing gate, made when first asked for
    /// Per step: 1 where its activation writes a stored output or var. What follows waits for that.
    std::vector<std::uint8_t> writing_steps;

    /// The net that is 1 while a transition is being cleared: AND of the X before it and its
    /// receptivity.
    NetId clearing_net(TransitionId transition);
    /// The factors of that product.
    std::vector<NetId> clearing_factors(TransitionId transition);
    /// Whether a step after the transition leads straight back to one before it.
    bool is_in_loop_of_two(TransitionId transition) const;
    /// `X7`, for the names of inner nets.
    std::string_view step_name(NetId x) const { return builder.netlist().names[x]; }
};

/// One per style: makes the phase module of a step, driving its x.
using PhaseMaker = void (*)(AsynchronousBuild& build, const PhaseSignals& phase);

void make_gates_phase(AsynchronousBuild& build, const PhaseSignals& phase);
void make_nand_phase(AsynchronousBuild& build, const PhaseSignals& phase);
void make_nor_phase(AsynchronousBuild& build, const PhaseSignals& phase);

/// The whole netlist of an asynchronous style. `set_time`: from an input change to that of the X it
/// activates, which is also how long a pulse has to last: until the memory holds by itself, and no
/// longer, so that it does not reach the step after.
Netlist make_asynchronous(Equations& equations, PhaseMaker make_phase, Time set_time);

/// Clocked: see style_clocked.cpp.
Netlist make_clocked(Equations& equations);

}  // namespace grafwire
