#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "explain/truth_table.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist.h"

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

/// The name of a variable one clock cycle before.
std::string name_before(std::string_view name);

/// An expression as a function of variables that have been added; nothing where there are too many.
/// `as_clocked`: an edge is its operand and not the same one clock cycle before.
std::optional<TruthTable> function_of(const Grafcet& grafcet, const Expressions& pool, ExprId id,
                                      bool as_clocked, const FunctionVariables& variables);
/// Adds what an expression depends on.
void add_variables(const Grafcet& grafcet, const Expressions& pool, ExprId id, bool as_clocked,
                   FunctionVariables& variables);

/// `X1.a + X2./b`; `0` and `1` for constants.
std::string sum_text(const std::vector<Product>& sum, const FunctionVariables& variables);

}  // namespace grafwire
