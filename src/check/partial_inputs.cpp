// Whether open inputs can be given values under which every assumption holds is asked for every
// case. Mostly three-valued evaluation answers it, or one of the solutions found before; a SAT
// solver does where they do not, so that assumptions may be as many and as entangled as they like.

#include "check/partial_inputs.h"

#include <algorithm>

namespace grafwire {

namespace {

constexpr std::size_t most_solutions = 16;

void collect_inputs(const Grafcet& grafcet, ExprId id, std::vector<std::uint32_t>& inputs) {
    const Expressions& pool = grafcet.expressions;
    if (pool.kind(id) == ExprKind::variable) {
        const Variable variable = pool.variable_of(id);
        const bool is_control = variable.kind == VariableKind::control;
        inputs.push_back(is_control
                             ? static_cast<std::uint32_t>(grafcet.inputs.size()) + variable.index
                             : variable.index);
    }
    for (const ExprId operand : pool.operands(id)) collect_inputs(grafcet, operand, inputs);
}

}  // namespace

PartialInputs open_inputs(const Grafcet& grafcet, bool has_modes) {
    PartialInputs inputs(grafcet.all_input_count(), Logic::unknown);
    if (has_modes) return inputs;
    for (std::size_t i = grafcet.inputs.size(); i < inputs.size(); ++i) inputs[i] = Logic::zero;
    return inputs;
}

Assumptions::Assumptions(const Grafcet& grafcet) : grafcet_(grafcet), plant_(grafcet) {
    for (const Assumption& assumption : grafcet.assumptions) {
        collect_inputs(grafcet, assumption.expression, mentioned_);
    }
    std::sort(mentioned_.begin(), mentioned_.end());
    mentioned_.erase(std::unique(mentioned_.begin(), mentioned_.end()), mentioned_.end());
}

Logic Assumptions::evaluate(ExprId id, const PartialInputs& inputs) const {
    const Expressions& pool = grafcet_.expressions;
    switch (pool.kind(id)) {
        case ExprKind::constant:
            return logic_of(pool.constant_value(id));
        case ExprKind::variable: {
            const Variable variable = pool.variable_of(id);
            const bool is_control = variable.kind == VariableKind::control;
            return inputs[(is_control ? grafcet_.inputs.size() : 0) + variable.index];
        }
        case ExprKind::negation:
            return ~evaluate(pool.operands(id)[0], inputs);
        case ExprKind::conjunction:
        case ExprKind::disjunction: {
            const bool is_and = pool.kind(id) == ExprKind::conjunction;
            const Logic deciding = is_and ? Logic::zero : Logic::one;
            Logic result = ~deciding;
            for (const ExprId operand : pool.operands(id)) {
                const Logic value = evaluate(operand, inputs);
                if (value == deciding) return deciding;
                if (value == Logic::unknown) result = Logic::unknown;
            }
            return result;
        }
        case ExprKind::exclusive_or: {
            Logic result = Logic::zero;
            for (const ExprId operand : pool.operands(id)) {
                const Logic value = evaluate(operand, inputs);
                if (value == Logic::unknown) return value;
                result = result ^ value;
            }
            return result;
        }
        default:
            return Logic::unknown;  // the parser lets no other kind into an assumption
    }
}

Logic Assumptions::evaluate_all(const PartialInputs& inputs) const {
    Logic all = Logic::one;
    for (const Assumption& assumption : grafcet_.assumptions) {
        const Logic value = evaluate(assumption.expression, inputs);
        if (value == Logic::zero) return value;
        if (value == Logic::unknown) all = value;
    }
    return all;
}

/// Whether a solution found earlier agrees with the inputs that are not open.
bool Assumptions::is_known_to_hold(const PartialInputs& inputs) const {
    return std::any_of(solutions_.begin(), solutions_.end(), [&](const std::vector<Logic>& some) {
        for (std::size_t i = 0; i < mentioned_.size(); ++i) {
            const Logic wanted = inputs[mentioned_[i]];
            if (wanted != Logic::unknown && wanted != some[i]) return false;
        }
        return true;
    });
}

bool Assumptions::can_be_completed(const PartialInputs& inputs) const {
    std::vector<int> literals = plant_.assumptions();
    for (const std::uint32_t input : mentioned_) {
        if (inputs[input] == Logic::unknown) continue;
        const int variable = plant_.input(input);
        literals.push_back(inputs[input] == Logic::one ? variable : -variable);
    }
    if (!plant_.solver().can_hold(literals)) return false;
    std::vector<Logic> solution;
    for (const std::uint32_t input : mentioned_) {
        solution.push_back(logic_of(plant_.solver().value(plant_.input(input))));
    }
    if (solutions_.size() < most_solutions) {
        solutions_.push_back(std::move(solution));
    } else {
        solutions_[oldest_++ % most_solutions] = std::move(solution);
    }
    return true;
}

bool Assumptions::can_hold(const PartialInputs& inputs) const {
    if (grafcet_.assumptions.empty()) return true;
    const Logic all = evaluate_all(inputs);
    if (all != Logic::unknown) return all == Logic::one;
    return is_known_to_hold(inputs) || can_be_completed(inputs);
}

std::optional<InputValues> Assumptions::complete(const PartialInputs& inputs,
                                                 const InputValues& preferred) const {
    if (!can_hold(inputs)) return std::nullopt;
    PartialInputs trial = inputs;
    for (const std::uint32_t input : mentioned_) {
        if (trial[input] != Logic::unknown) continue;
        trial[input] = logic_of(preferred[input] != 0);
        if (!can_hold(trial)) trial[input] = ~trial[input];
    }
    InputValues values(trial.size());
    for (std::size_t i = 0; i < trial.size(); ++i) {
        values[i] = trial[i] == Logic::unknown ? preferred[i] : trial[i] == Logic::one;
    }
    return values;
}

}  // namespace grafwire
