// Assumptions are few and small, so their satisfiability is decided by trying the inputs they
// mention one after the other, with three-valued evaluation to give up early.

#include "check/partial_inputs.h"

#include <algorithm>

namespace grafwire {

namespace {

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

Logic invert(Logic value) {
    if (value == Logic::unknown) return value;
    return value == Logic::one ? Logic::zero : Logic::one;
}

}  // namespace

PartialInputs open_inputs(const Grafcet& grafcet, bool has_modes) {
    PartialInputs inputs(grafcet.all_input_count(), Logic::unknown);
    if (has_modes) return inputs;
    for (std::size_t i = grafcet.inputs.size(); i < inputs.size(); ++i) inputs[i] = Logic::zero;
    return inputs;
}

Assumptions::Assumptions(const Grafcet& grafcet) : grafcet_(grafcet) {
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
            return pool.constant_value(id) ? Logic::one : Logic::zero;
        case ExprKind::variable: {
            const Variable variable = pool.variable_of(id);
            const bool is_control = variable.kind == VariableKind::control;
            return inputs[(is_control ? grafcet_.inputs.size() : 0) + variable.index];
        }
        case ExprKind::negation:
            return invert(evaluate(pool.operands(id)[0], inputs));
        case ExprKind::conjunction:
        case ExprKind::disjunction: {
            const bool is_and = pool.kind(id) == ExprKind::conjunction;
            const Logic deciding = is_and ? Logic::zero : Logic::one;
            Logic result = invert(deciding);
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
                if (value == Logic::one) result = invert(result);
            }
            return result;
        }
        default:
            return Logic::unknown;  // the parser lets no other kind into an assumption
    }
}

bool Assumptions::is_broken(const PartialInputs& inputs) const {
    for (const Assumption& assumption : grafcet_.assumptions) {
        if (evaluate(assumption.expression, inputs) == Logic::zero) return true;
    }
    return false;
}

bool Assumptions::search(PartialInputs& inputs, std::size_t next,
                         const InputValues& preferred) const {
    if (is_broken(inputs)) return false;
    while (next < mentioned_.size() && inputs[mentioned_[next]] != Logic::unknown) ++next;
    if (next == mentioned_.size()) return true;
    const std::uint32_t input = mentioned_[next];
    const Logic first = preferred[input] != 0 ? Logic::one : Logic::zero;
    for (const Logic value : {first, invert(first)}) {
        inputs[input] = value;
        if (search(inputs, next + 1, preferred)) return true;
    }
    inputs[input] = Logic::unknown;
    return false;
}

bool Assumptions::can_hold(const PartialInputs& inputs) const {
    if (mentioned_.empty()) return true;
    PartialInputs trial = inputs;
    return search(trial, 0, InputValues(inputs.size(), 0));
}

std::optional<InputValues> Assumptions::complete(const PartialInputs& inputs,
                                                 const InputValues& preferred) const {
    PartialInputs trial = inputs;
    if (!search(trial, 0, preferred)) return std::nullopt;
    InputValues values(trial.size());
    for (std::size_t i = 0; i < trial.size(); ++i) {
        values[i] = trial[i] == Logic::unknown ? preferred[i] : trial[i] == Logic::one;
    }
    return values;
}

}  // namespace grafwire
