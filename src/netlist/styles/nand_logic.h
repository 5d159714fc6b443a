#pragma once

#include <vector>

#include "equations/equations.h"
#include "netlist/styles/chart_netlist.h"

namespace grafwire {

/// Turns expressions of the equations into NAND gates and inverters, each expression and each
/// complement once. Nothing is done about signals that come late: it is for what lies outside of
/// all loops, where that costs a glitch and nothing else.
class NandLogic {
  public:
    NandLogic(const Grafcet& grafcet, const Equations& equations, ChartNetlist& chart,
              const VariableNets& nets);

    NetId net(ExprId id, const GateMaker& gates) { return made(id, false, gates); }
    NetId complement(ExprId id, const GateMaker& gates) { return made(id, true, gates); }
    /// Drives a net that exists.
    void drive(NetId output, ExprId id, const GateMaker& gates);
    /// The timer of a time condition, made for what asks first.
    NetId timer(ExprId id, const GateMaker& gates);

  private:
    NetId made(ExprId id, bool negated, const GateMaker& gates);
    NetId make(ExprId id, bool negated, const GateMaker& gates);
    NetId variable(Variable variable, const GateMaker& gates);
    std::vector<NetId> nets_of(std::span<const ExprId> ids, bool negated, const GateMaker& gates);
    NetId nand_of(std::span<const NetId> pins, const GateMaker& gates);
    NetId exclusive(std::span<const ExprId> ids, const GateMaker& gates);

    const Grafcet& grafcet_;
    const Expressions& pool_;
    ChartNetlist& chart_;
    const VariableNets& nets_;
    std::vector<NetId> made_[2];  ///< per expression: itself, its complement
    std::vector<std::pair<std::string, std::uint32_t>> role_numbers_;
    std::uint32_t next_number(const GateMaker& gates);
};

}  // namespace grafwire
