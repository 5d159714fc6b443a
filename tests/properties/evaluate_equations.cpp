#include "properties/evaluate_equations.h"

#include "support/evaluate_expression.h"

namespace grafwire::testing {

namespace {

bool variable_value(Variable variable, const EquationValues& values) {
    switch (variable.kind) {
        case VariableKind::input:
            return (*values.inputs)[variable.index] != 0;
        case VariableKind::control:
            return (*values.inputs)[values.inputs->size() - control_input_count + variable.index] !=
                   0;
        case VariableKind::output:
            return values.state->stored_outputs.test(variable.index);
        case VariableKind::var:
            return values.state->vars.test(variable.index);
        case VariableKind::step:
            return values.steps[variable.index];
        default:
            return false;  // equations hold no counter, macro-step or graph as a variable
    }
}

}  // namespace

bool equation_value(const Equations& equations, ExprId id, const EquationValues& values) {
    const EvolutionState& state = *values.state;
    return value_of(equations.expressions, id,
                    {[&](Variable variable) { return variable_value(variable, values); },
                     [&](std::size_t edge) { return state.edges.test(edge); },
                     [&](std::size_t condition) { return state.time_values.test(condition); },
                     [&](std::uint32_t counter) { return state.counters[counter]; }});
}

}  // namespace grafwire::testing
