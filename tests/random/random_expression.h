#pragma once

#include <string>
#include <vector>

#include "random/chart_names.h"

namespace grafwire::testing {

/// Writes random expressions, sums and stored writes over the names of a GRAFCET. Every choice is
/// in a statement of its own where two are made: operands and arguments are evaluated in an order
/// that is the compiler's, and a seed has to give the same text everywhere.
class ExpressionWriter {
  public:
    ExpressionWriter(RandomSource& random, const Features& features, const ChartNames& names)
        : random_(random),
          features_(features),
          names_(names),
          times_left_(features.time_conditions),
          edges_left_(features.edges) {}

    /// Of a transition, event or right-hand side.
    std::string expression() { return expression(features_.expression_depth, true, true); }
    /// Of a continuous action: no edge but within a time condition.
    std::string condition() { return expression(features_.expression_depth - 1, false, true); }
    /// Of `assume`: inputs only.
    std::string plant_expression(std::size_t depth);
    /// A condition that can change: an input or its edge is a factor.
    std::string receptivity();
    /// `set v`, `reset v`, `v := …`; of one of the targets, or of any.
    std::string write();
    std::string write(const std::string& target);
    bool has_targets() const {
        return !names_.stored_outputs.empty() || !names_.vars.empty() || !names_.counters.empty();
    }
    std::string duration();

  private:
    std::string expression(std::size_t depth, bool edges, bool times);
    std::string time_condition(std::size_t depth);
    std::string edge(const std::string& operand);
    std::string negated(const std::string& operand);
    std::string both(const std::string& a, const std::string& b);
    std::string joined(const std::string& a, const std::string& b);
    std::string leaf();
    std::string comparison();
    std::string sum();
    std::string sum_term();

    RandomSource& random_;
    const Features& features_;
    const ChartNames& names_;
    std::size_t times_left_;
    std::size_t edges_left_;
};

/// A random expression over these atoms alone, with operators of two to four operands.
std::string expression_of(RandomSource& random, const std::vector<std::string>& atoms,
                          std::size_t depth);

}  // namespace grafwire::testing
