#pragma once

#include <optional>
#include <vector>

#include "explain/explain.h"
#include "explain/net_reader.h"

namespace grafwire {

/// A step or output as the equations and as the gates have it.
struct FunctionComparison {
    Explanation::Fault fault = Explanation::Fault::no_fault;
    /// Of both sides; each function is the value that X (the output) takes next.
    FunctionVariables variables;
    std::optional<TruthTable> expected;
    std::optional<TruthTable> got;
    std::optional<TruthTable> cax;  ///< as they should be; of a step alone
    std::optional<TruthTable> cdx;
    std::vector<Explanation::EquationPair> equations;  ///< operands without values
    std::vector<NetId> gates;                          ///< that make it in the netlist
    std::vector<std::string> reads;                    ///< what these depend on, by name
};

/// The value of a variable, given those of all nets; unknown where the netlist does not have it.
Logic value_of(const FunctionVariable& variable, const std::vector<Logic>& nets);

/// The row of the truth tables that these values of the nets make; nothing where a variable is
/// unknown on which one of the tables depends.
std::optional<std::size_t> row_of(const FunctionVariables& variables,
                                  const std::vector<const TruthTable*>& tables,
                                  const std::vector<Logic>& nets);

/// A step of the netlist against its equations. What cannot be compared (too many variables,
/// memories without a name) is a fault of the kind `unread`.
FunctionComparison compare_step(const NetReader& reader, const Equations& equations, StepId step);
/// Likewise a continuous output; of a stored output nothing but its gates.
FunctionComparison compare_output(const NetReader& reader, const Equations& equations,
                                  OutputId output);

}  // namespace grafwire
