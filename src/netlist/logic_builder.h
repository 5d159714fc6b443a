#pragma once

#include <string>
#include <vector>

#include "equations/equations.h"
#include "netlist/netlist_builder.h"

namespace grafwire {

/// Turns expressions of the equations into gates, each expression once.
///
/// Levels. Where several inputs change in the same instant, a gate must see them together: an input
/// that comes straight and one that comes through an inverter are one gate delay apart, and in that
/// time `a./b` is 1 although it is 0 before and after. So every signal that stems from inputs has a
/// level (the gates it has come through), and the operands of a gate are brought to the same level
/// by buffers. Signals that stem from X variables alone have no level: they change one at a time,
/// as the consequence of something that has already been seen.
class LogicBuilder {
  public:
    struct Signal {
        NetId net = no_net;
        int level = no_level;
    };
    static constexpr int no_level = -1;

    LogicBuilder(const Equations& equations, NetlistBuilder& builder);

    /// Where the variables are found, by their index.
    std::vector<NetId> inputs;  ///< declared inputs, Init, AUdur, AUdoux (no_net without modes: 0)
    std::vector<NetId> steps;
    std::vector<NetId> outputs;  ///< of stored outputs
    std::vector<NetId> vars;

    /// How long the output of a pulse cell stays 1.
    Time pulse_width = 0;
    /// The owner in the names of the gates that are made next.
    std::string owner;

    Signal signal(ExprId id);
    NetId net(ExprId id) { return signal(id).net; }

    /// The nets of the factors of a product, brought to one level; a single net where the
    /// expression is no conjunction, none where it is the constant 1.
    std::vector<NetId> factors(ExprId id);

    /// An expression for the right-hand side of a write, in which stored outputs and vars are read
    /// at their `held` nets where these are not no_net. Edges and time conditions in it are the
    /// shared ones.
    Signal held_signal(ExprId id, const std::vector<NetId>& held_outputs,
                       const std::vector<NetId>& held_vars);

  private:
    Signal make(ExprId id);
    Signal make_variable(Variable variable);
    Signal make_gate(CellType type, std::vector<Signal> operands);
    Signal make_edge(ExprId id);
    Signal make_time_condition(ExprId id);
    int align(std::vector<Signal>& operands);
    std::string next_role();

    const Equations& equations_;
    const Expressions& pool_;
    NetlistBuilder& builder_;
    std::vector<Signal> made_;
    std::string role_owner_;
    std::uint32_t role_number_ = 0;
};

}  // namespace grafwire
