#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "grafcet/grafcet.h"
#include "sat/sat_solver.h"

namespace grafwire {

/// The assumptions of a GRAFCET as clauses over its inputs (declared inputs, Init, AUdur, AUdoux).
class PlantConditions {
  public:
    explicit PlantConditions(const Grafcet& grafcet);

    SatSolver& solver() { return solver_; }
    const SatSolver& solver() const { return solver_; }
    /// The variable of the solver that stands for an input.
    int input(std::size_t index) const { return static_cast<int>(index) + 1; }
    /// The literals of the solver that stand for the assumptions: all are true where all hold.
    const std::vector<int>& assumptions() const { return assumptions_; }

  private:
    int literal(const Grafcet& grafcet, ExprId id);
    int all_of(std::span<const int> literals);
    int exclusive_or(int a, int b);

    SatSolver solver_;
    std::vector<int> literals_;  ///< per node of the expressions; 0: not yet made
    std::vector<int> assumptions_;
};

/// Assumptions that exclude each other, by their indices in order, none of them without need; empty
/// where some inputs satisfy all. A single one is never 1.
std::vector<std::size_t> contradicting_assumptions(const Grafcet& grafcet);

}  // namespace grafwire
