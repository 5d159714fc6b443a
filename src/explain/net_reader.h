#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "equations/equations.h"
#include "explain/truth_table.h"
#include "netlist/netlist.h"
#include "simulate/simulate.h"

namespace grafwire {

/// The name of a variable as equations write it: quoted where it has to be.
std::string operand_name(const Grafcet& grafcet, Variable variable);

/// Something a function depends on, by the name that the GRAFCET (or else the netlist) has for it.
struct FunctionVariable {
    std::string name;  ///< `X1`, `a`, `↑a`, `5s/X13`; of a memory of its own the name of the net
    NetId net = no_net;        ///< where its value can be read; no_net: nowhere in the netlist
    bool is_inverted = false;  ///< the net carries the complement
    bool is_own = false;       ///< a memory of the netlist's that the GRAFCET has no name for
    /// An edge, time condition, var or comparison: a netlist makes it, out of memories of its own.
    bool is_made = false;
};

/// The variables of some functions that are compared, each once.
class FunctionVariables {
  public:
    /// The number of the variable of that name, added if it is new; a place where its value can be
    /// read is taken over.
    std::size_t add(const FunctionVariable& variable);
    std::size_t size() const { return list_.size(); }
    const FunctionVariable& operator[](std::size_t index) const { return list_[index]; }
    FunctionVariable& operator[](std::size_t index) { return list_[index]; }
    std::optional<std::size_t> find(std::string_view name) const;

  private:
    std::vector<FunctionVariable> list_;
};

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

/// An expression as a function of variables that have been added; nothing where
/// there are too many. `as_clocked`: an edge is its operand and not the same one
/// clock cycle before.
std::optional<TruthTable> function_of(const Grafcet& grafcet, const Expressions& pool, ExprId id,
                                      bool as_clocked, const FunctionVariables& variables);
/// Adds what an expression depends on.
void add_variables(const Grafcet& grafcet, const Expressions& pool, ExprId id, bool as_clocked,
                   FunctionVariables& variables);

/// `X1.a + X2./b`; `0` and `1` for constants.
std::string sum_text(const std::vector<Product>& sum, const FunctionVariables& variables);

}  // namespace grafwire
