// Inputs of which some are unassigned, and what the plant allows of them.
//
// Every case asks whether its unassigned inputs can be given values under which all assumptions
// hold. Mostly evaluation in three values answers it (S. C. Kleene, "Introduction to
// Metamathematics", 1952, par. 64), or one of the solutions found before; where they do not, a SAT
// solver does, so assumptions may be as many and as entangled as they like.
//
// In fundamental mode one input changes at a time, as far as the plant allows it: where a change
// alone would break an assumption, the smallest change that contains it and keeps all assumptions
// is looked for among the pairs of inputs that assumptions mention. Larger ties, of three inputs
// and more that can only change together, are left out; the report names what they leave
// unexercised.

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

PartialInput opposite(PartialInput value) {
    if (value == PartialInput::unassigned) return value;
    return value == PartialInput::one ? PartialInput::zero : PartialInput::one;
}

Logic logic_of(PartialInput value) {
    if (value == PartialInput::unassigned) return Logic::unknown;
    return logic_of(value == PartialInput::one);
}

std::vector<Logic> logic_of(const PartialInputs& inputs) {
    std::vector<Logic> values(inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) values[i] = logic_of(inputs[i]);
    return values;
}

PartialInputs assigned_inputs(const InputValues& values) {
    PartialInputs inputs(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) inputs[i] = assigned(values[i] != 0);
    return inputs;
}

PartialInputs unassigned_inputs(const Grafcet& grafcet, bool has_modes) {
    PartialInputs inputs(grafcet.all_input_count(), PartialInput::unassigned);
    if (has_modes) return inputs;
    for (std::size_t i = grafcet.inputs.size(); i < inputs.size(); ++i) {
        inputs[i] = PartialInput::zero;
    }
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
            return logic_of(inputs[(is_control ? grafcet_.inputs.size() : 0) + variable.index]);
        }
        case ExprKind::negation:
            return ~evaluate(pool.operands(id)[0], inputs);
        case ExprKind::conjunction:
        case ExprKind::disjunction: {
            const bool is_and = pool.kind(id) == ExprKind::conjunction;
            Logic result = logic_of(is_and);
            for (const ExprId operand : pool.operands(id)) {
                const Logic value = evaluate(operand, inputs);
                result = is_and ? result & value : result | value;
            }
            return result;
        }
        case ExprKind::exclusive_or: {
            Logic result = Logic::zero;
            for (const ExprId operand : pool.operands(id)) {
                result = result ^ evaluate(operand, inputs);
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
        all = all & evaluate(assumption.expression, inputs);
        if (all == Logic::zero) break;
    }
    return all;
}

/// Whether a solution found earlier agrees with the inputs that are assigned.
bool Assumptions::is_known_to_hold(const PartialInputs& inputs) const {
    return std::any_of(solutions_.begin(), solutions_.end(), [&](const PartialInputs& some) {
        for (std::size_t i = 0; i < mentioned_.size(); ++i) {
            const PartialInput wanted = inputs[mentioned_[i]];
            if (wanted != PartialInput::unassigned && wanted != some[i]) return false;
        }
        return true;
    });
}

bool Assumptions::can_be_completed(const PartialInputs& inputs) const {
    std::vector<int> literals = plant_.assumptions();
    for (const std::uint32_t input : mentioned_) {
        if (inputs[input] == PartialInput::unassigned) continue;
        const int variable = plant_.input(input);
        literals.push_back(inputs[input] == PartialInput::one ? variable : -variable);
    }
    if (!plant_.solver().can_hold(literals)) return false;
    PartialInputs solution;
    for (const std::uint32_t input : mentioned_) {
        solution.push_back(assigned(plant_.solver().value(plant_.input(input))));
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
        if (trial[input] != PartialInput::unassigned) continue;
        trial[input] = assigned(preferred[input] != 0);
        if (!can_hold(trial)) trial[input] = opposite(trial[input]);
    }
    InputValues values(trial.size());
    for (std::size_t i = 0; i < trial.size(); ++i) {
        values[i] =
            trial[i] == PartialInput::unassigned ? preferred[i] : trial[i] == PartialInput::one;
    }
    return values;
}

std::vector<PartialInputs> single_changes(const Assumptions& assumptions,
                                          const PartialInputs& inputs, bool has_modes) {
    const std::size_t count = inputs.size() - (has_modes ? 0 : control_input_count);
    std::vector<PartialInputs> changes;
    std::vector<std::uint32_t> tied;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (inputs[i] == PartialInput::unassigned) continue;
        PartialInputs changed = inputs;
        changed[i] = opposite(changed[i]);
        if (assumptions.can_hold(changed)) {
            changes.push_back(std::move(changed));
        } else {
            tied.push_back(i);
        }
    }
    for (std::size_t i = 0; i < tied.size(); ++i) {
        for (std::size_t j = i + 1; j < tied.size(); ++j) {
            PartialInputs changed = inputs;
            for (const std::uint32_t input : {tied[i], tied[j]}) {
                changed[input] = opposite(changed[input]);
            }
            if (assumptions.can_hold(changed)) changes.push_back(std::move(changed));
        }
    }
    return changes;
}

std::optional<PartialInputs> inputs_before(const Assumptions& assumptions,
                                           const PartialInputs& left, const PartialInputs& inputs) {
    PartialInputs before = left;
    std::vector<std::uint32_t> assigned;
    for (std::uint32_t i = 0; i < inputs.size(); ++i) {
        if (left[i] != PartialInput::unassigned || inputs[i] == PartialInput::unassigned) continue;
        before[i] = inputs[i];
        assigned.push_back(i);
    }
    if (assumptions.can_hold(before)) return before;
    for (const std::uint32_t input : assigned) {
        before[input] = opposite(before[input]);
        if (assumptions.can_hold(before)) return before;
        before[input] = opposite(before[input]);
    }
    return std::nullopt;
}

}  // namespace grafwire
