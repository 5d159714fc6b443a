#pragma once

#include <string>
#include <vector>

#include "equations/equations.h"
#include "netlist/delay_model.h"
#include "netlist/styles/chart_netlist.h"
#include "netlist/styles/logic_builder.h"

namespace grafwire {

/// All signals that meet in the module of one step; absent ones are no_net.
struct StepSignals {
    StepId step{};
    NetId x = no_net;  ///< to be driven
    bool initial = false;
    NetId init = no_net;  ///< Init; no_net without modes
    NetId not_init = no_net;
    NetId not_au_dur = no_net;
    LogicBuilder::Signal forced_off;  ///< OR of the X that force the graph
    LogicBuilder::Signal forced_on;   ///< OR of the X whose orders list the step
    NetId enclosing = no_net;         ///< X of the enclosing step
    std::vector<NetId> link;          ///< factors of the activation link; empty where there is none
    std::vector<TransitionId> into;   ///< the transitions that lead to the step
    std::vector<std::vector<NetId>> cdx;  ///< CDX as a sum of products; empty: never deactivated
};

/// What the parts of an asynchronous netlist share while it is being made.
class AsynchronousBuild {
  public:
    AsynchronousBuild(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays,
                      Time pulse_width);
    AsynchronousBuild(const AsynchronousBuild&) = delete;
    AsynchronousBuild& operator=(const AsynchronousBuild&) = delete;

    const Grafcet& grafcet;
    const Equations& equations;
    const DelayModel& delays;
    ChartNetlist chart;
    const VariableNets nets;
    LogicBuilder logic;
    const StepTransitions links;

    /// The net that is 1 while a transition is being cleared: AND of the X before it and its
    /// condition, made for whichever step asks first.
    NetId clearing_net(TransitionId transition, const GateMaker& gates);
    /// The factors of that product.
    std::vector<NetId> clearing_factors(TransitionId transition, const GateMaker& gates);
    NetId control(ControlInput input) const { return nets.control(grafcet, input); }

  private:
    bool is_in_loop_of_two(TransitionId transition) const;

    std::vector<NetId> clearing_;  ///< per transition; no_net until asked for
    /// Per step: 1 where its activation writes a stored output or var. What follows waits for that.
    std::vector<std::uint8_t> writing_steps_;
};

/// What tells one asynchronous style from another: how the memory of a step is made of gates.
struct AsynchronousStyle {
    /// Makes the module of a step, driving its X.
    void (*make_step)(AsynchronousBuild& build, const StepSignals& step, const GateMaker& gates);
    /// The cells from an input change to the X it activates. The time they take is also how long a
    /// pulse has to last: until the memory holds by itself, and no longer, so that it does not
    /// reach the step after.
    std::vector<CellType> path_of_set;
};

/// The netlist of a GRAFCET without counters, in one of these styles.
Netlist make_asynchronous(const Grafcet& grafcet, const Equations& equations,
                          const AsynchronousStyle& style, const DelayModel& delays);

/// What the makers of step modules share whose memory is two cross-coupled gates, X and its other
/// half:
///
///     X   = gate(x terms, X$q)
///     X$q = gate(other terms, X)
///
/// Without modes nothing sets such a memory, so both halves start at known values.
class LatchModule {
  public:
    LatchModule(AsynchronousBuild& build, const StepSignals& step, const GateMaker& gates)
        : build_(build), step_(step), gates_(gates) {}

  protected:
    bool has_modes() const { return step_.init != no_net; }
    std::string set_role(TransitionId into) const {
        return "set" + build_.grafcet.transitions[into].name;
    }

    void cross_couple(CellType type, std::vector<NetId> x_terms, std::vector<NetId> other_terms) {
        const NetId other = gates_.add_net("q");
        x_terms.push_back(other);
        gates_.drive(step_.x, type, x_terms);
        other_terms.push_back(step_.x);
        gates_.drive(other, type, other_terms);
        if (!has_modes()) gates_.builder().set_initial(other, !step_.initial);
    }

    AsynchronousBuild& build_;
    const StepSignals& step_;
    const GateMaker& gates_;
    std::vector<NetId> sets_;
    std::vector<NetId> resets_;
};

}  // namespace grafwire
