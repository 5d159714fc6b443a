#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "equations/equations.h"
#include "netlist/delay_model.h"
#include "netlist/styles/chart_netlist.h"

namespace grafwire {

/// Turns expressions of the equations into gates, each expression once. A gate stands in the module
/// and has the owner of the GateMaker with which it was first asked for.
///
/// Latency. Where several signals change in the same instant, a gate must see them together: an
/// input that comes straight and one that comes through an inverter are one gate delay apart, and
/// in that time `a./b` is 1 although it is 0 before and after. Likewise for X variables: where a
/// step is activated in the same instant as the one that freezes its graph, /X3 must not be later
/// than X11. So every signal knows how long it takes from an input and from an X variable under the
/// delay model, and the operands of a gate that stem from the same kind of source are brought to
/// the same latency by buffers. Inputs and X variables need not be brought together: an X changes
/// as the consequence of something that all gates have already seen.
class LogicBuilder {
  public:
    struct Signal {
        static constexpr Time independent = -1;
        NetId net = no_net;
        Time since_input = independent;  ///< delay since an input; independent: stems from none
        Time since_step = independent;   ///< delay since an X variable
        /// The same signal behind one more gate, which takes that long.
        Signal through(NetId gate, Time delay) const {
            return {gate, since_input == independent ? independent : since_input + delay,
                    since_step == independent ? independent : since_step + delay};
        }
    };

    /// `pulse_width`: how long the output of a pulse cell stays 1. What it refers to must outlive
    /// it; of the outputs the nets of stored ones are read.
    LogicBuilder(const Grafcet& grafcet, const Equations& equations, ChartNetlist& chart,
                 const VariableNets& nets, const DelayModel& delays, Time pulse_width);

    Signal signal(ExprId id, const GateMaker& gates);
    NetId net(ExprId id, const GateMaker& gates) { return signal(id, gates).net; }

    /// The nets of the factors of a product, brought to one latency; a single net where the
    /// expression is no conjunction, none where it is the constant 1.
    std::vector<NetId> factors(ExprId id, const GateMaker& gates);
    /// The same for the clearing condition of a transition, in which the X of `slow` steps (one
    /// byte per step) are seen late enough for their writes to be done, and the factor `/frozen`
    /// (no_expr for none) stays as it was for as long.
    std::vector<NetId> clearing_factors(ExprId id, const std::vector<std::uint8_t>& slow,
                                        ExprId frozen, const GateMaker& gates);
    /// How long an input takes to where it enters that product; 0 where it reads none.
    Time input_latency(ExprId product, const GateMaker& gates);

    /// The net, later by so much: behind as many buffers as take that time.
    NetId delayed(NetId net, Time time, const GateMaker& gates) const {
        return gates.delayed(net, delays_.buffers_for(time));
    }

    /// Where stored outputs and vars keep what they were while they are being written; no_net where
    /// that is not read.
    struct HeldNets {
        std::vector<NetId> outputs;
        std::vector<NetId> vars;
    };
    /// An expression for the right-hand side of a write, in which stored outputs and vars are read
    /// at their held nets. Edges and time conditions in it are the shared ones.
    Signal held_signal(ExprId id, const HeldNets& held, const GateMaker& gates);

  private:
    Signal make(ExprId id, const GateMaker& gates);
    Signal make_variable(Variable variable, const GateMaker& gates);
    Signal make_gate(CellType type, std::vector<Signal> operands, const GateMaker& gates);
    Signal make_edge(ExprId id, const GateMaker& gates);
    Signal make_time_condition(ExprId id, const GateMaker& gates);
    GateMaker made_for(ExprId id, const GateMaker& gates);
    Signal align(std::vector<Signal>& operands, const GateMaker& gates) const;
    std::vector<NetId> aligned_nets(std::vector<Signal> signals, const GateMaker& gates) const;
    std::vector<Signal> factor_signals(ExprId id, const GateMaker& gates);

    const Grafcet& grafcet_;
    const Expressions& pool_;
    ChartNetlist& chart_;
    const VariableNets& nets_;
    const DelayModel& delays_;
    Time pulse_width_;
    /// From an X to the stored variable that it writes. A variable counts as a signal that has come
    /// so far since an X, so that where a transition reads it the X before the transition is
    /// delayed until what that step writes can be seen.
    Time write_latency_;
    std::vector<Signal> made_;
    /// Per owner the gates numbered so far; an owner may be come back to.
    std::unordered_map<std::string, std::uint32_t> role_numbers_;
};

}  // namespace grafwire
