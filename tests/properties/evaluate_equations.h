#pragma once

#include <vector>

#include "equations/equations.h"
#include "evolution/evolution.h"

namespace grafwire::testing {

/// What an expression of the equations reads.
struct EquationValues {
    std::vector<bool> steps;
    const EvolutionState* state = nullptr;  ///< edges, time conditions, vars, counters, outputs
    const InputValues* inputs = nullptr;
};

/// The value of an expression of the equations; its edges and time conditions must be those of the
/// GRAFCET (every receptivity's are).
bool equation_value(const Equations& equations, ExprId id, const EquationValues& values);

}  // namespace grafwire::testing
