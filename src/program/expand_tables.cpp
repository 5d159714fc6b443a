// Operations on whole tables, step by step, for languages without words of bits.

#include "program/messages.h"
#include "program/program.h"

namespace grafwire {

namespace {

/// target = before . /off + on, for one step.
Condition formula(BitKind before, BitKind off, BitKind on, std::uint32_t step) {
    std::vector<Condition> kept;
    kept.push_back(bit_condition({before, step}));
    kept.push_back(not_condition(bit_condition({off, step})));
    std::vector<Condition> causes;
    causes.push_back(and_condition(std::move(kept)));
    causes.push_back(bit_condition({on, step}));
    return or_condition(std::move(causes));
}

Condition condition_for(TableOperation operation, std::uint32_t step) {
    switch (operation) {
        case TableOperation::remember:
            return bit_condition({BitKind::step, step});
        case TableOperation::evolve:
            return formula(BitKind::previous, BitKind::deactivate, BitKind::activate, step);
        case TableOperation::force:
            return formula(BitKind::step, BitKind::forced_off, BitKind::forced_on, step);
        case TableOperation::pulse: {
            std::vector<Condition> parts;
            parts.push_back(bit_condition({BitKind::step, step}));
            parts.push_back(not_condition(bit_condition({BitKind::previous, step})));
            return and_condition(std::move(parts));
        }
        case TableOperation::clear:
            break;
    }
    return constant_condition(false);
}

BitKind target_of(TableOperation operation) {
    switch (operation) {
        case TableOperation::remember:
            return BitKind::previous;
        case TableOperation::pulse:
            return BitKind::pulse;
        default:
            return BitKind::step;
    }
}

}  // namespace

std::vector<Statement> expand_tables(const Grafcet& grafcet, const Statement& statement) {
    if (statement.kind != Statement::Kind::table) return {statement};
    std::vector<Statement> expanded;
    const auto steps = static_cast<std::uint32_t>(grafcet.steps.size());
    if (statement.operation == TableOperation::clear) {
        Statement reset = statement;
        reset.kind = Statement::Kind::reset;
        reset.condition = constant_condition(true);
        for (const BitKind table :
             {BitKind::activate, BitKind::deactivate, BitKind::forced_on, BitKind::forced_off}) {
            for (std::uint32_t s = 0; s < steps; ++s) reset.targets.push_back({table, s});
        }
        expanded.push_back(std::move(reset));
        return expanded;
    }
    for (std::uint32_t s = 0; s < steps; ++s) {
        Statement assign = statement;
        assign.kind = Statement::Kind::assign;
        assign.targets = {{target_of(statement.operation), s}};
        assign.condition = condition_for(statement.operation, s);
        assign.comment =
            messages::program::for_step(statement.comment, grafcet.steps[StepId{s}].name);
        assign.origin = grafcet.steps[StepId{s}].where;
        expanded.push_back(std::move(assign));
    }
    return expanded;
}

}  // namespace grafwire
