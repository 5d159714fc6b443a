#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "equations/equations.h"
#include "explain/equation_functions.h"
#include "explain/truth_table.h"
#include "netlist/netlist.h"
#include "simulate/simulate.h"

namespace grafwire {

/// The gates between a net and what it depends on.
struct Cone {
    std::vector<NetId> inner;  ///< nets of gates, each after those it reads, the net itself last
    std::unordered_map<NetId, FunctionVariable> leaves;
    std::vector<NetId> leaf_order;  ///< as they were met
    /// Nets at which a feedback loop was cut that does not go through an X.
    std::vector<NetId> loops;
};

/// Reads Boolean functions off a netlist, in terms of what the GRAFCET has names for: inputs, X,
/// stored outputs, vars, edges and time conditions. What it refers to must outlive it.
class NetReader {
  public:
    NetReader(const Grafcet& grafcet, const Netlist& netlist);

    /// The gates behind a net, up to what has a name. `as_memory`: of the net of an X what makes
    /// it, with the same X as a variable, for what it is before; else an X is what it is.
    Cone cone_of(NetId net, bool as_memory) const;
    /// The cone as a function; every variable of it must have been added, and not more than
    /// TruthTable::most_variables.
    TruthTable function(const Cone& cone, const FunctionVariables& variables) const;

    /// Fills in where the values of inputs, X and outputs can be read that the netlist has ports
    /// for.
    void locate(FunctionVariables& variables) const;

    /// The other of the two cross-coupled gates that are the memory of a step; no_net where it has
    /// another one.
    NetId other_half(StepId step) const;

    const Grafcet& grafcet() const { return grafcet_; }
    const Netlist& netlist() const { return netlist_; }
    const PortMap& ports() const { return ports_; }
    CellId driver(NetId net) const { return drivers_[net]; }

  private:
    class Walk;
    void name_port(NetId net, Variable variable);
    void name_step(std::size_t index);
    void name_complements();
    NetId cross_coupled(NetId net) const;
    void name_timers(const Expressions& pool);
    void name_memories(const Expressions& pool);
    std::optional<FunctionVariable> leaf(NetId net) const;
    std::string text_of(NetId net) const;
    TruthTable value_of(const Cell& cell, const std::unordered_map<NetId, TruthTable>& known,
                        std::size_t variables) const;

    const Grafcet& grafcet_;
    const Netlist& netlist_;
    PortMap ports_;
    Table<NetId, CellId> drivers_;
    std::unordered_map<NetId, FunctionVariable> named_;
    std::unordered_map<std::string, NetId> ports_by_name_;
};

}  // namespace grafwire
