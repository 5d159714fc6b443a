// A ladder diagram for people leaves out what the table method writes for every chart alike.
//
// Three things are known before any scan. A graph that no order freezes may always evolve, so its
// Tfig is 1. A transition whose condition of clearing folds to 0 is never cleared. And a bit that
// no condition reads need not be written. The values that are known are put into all conditions,
// which are folded as they are built (program/condition.cpp); what is left decides what is read.

#include "ladder/simplified_scan.h"

#include <algorithm>

namespace grafwire::ladder {

namespace {

Condition exclusive_or_condition(std::vector<Condition> operands) {
    bool odd = false;
    std::vector<Condition> kept;
    for (Condition& operand : operands) {
        if (operand.kind == Condition::Kind::constant) {
            odd = odd != operand.value;
        } else {
            kept.push_back(std::move(operand));
        }
    }
    Condition result;
    if (kept.empty()) return constant_condition(odd);
    if (kept.size() == 1) {
        result = std::move(kept.front());
    } else {
        result.kind = Condition::Kind::exclusive_or;
        result.operands = std::move(kept);
    }
    return odd ? not_condition(std::move(result)) : result;
}

void collect_reads(const Condition& condition, std::set<Bit>& bits) {
    if (condition.kind == Condition::Kind::bit) bits.insert(condition.bit);
    for (const Condition& operand : condition.operands) collect_reads(operand, bits);
}

bool writes_bit_of(const Statement& statement, BitKind kind) {
    return std::any_of(statement.targets.begin(), statement.targets.end(),
                       [&](Bit bit) { return bit.kind == kind; });
}

}  // namespace

SimplifiedScan::SimplifiedScan(const Grafcet& grafcet, const ScanProgram& program) {
    note_graphs(grafcet, program);
    note_transitions(grafcet, program);
    for (std::size_t s = 0; s < section_count; ++s) {
        for (Statement statement : program.sections[s]) {
            statement.condition = simplified(statement.condition);
            for (const Bit bit : statement.targets) comments_.emplace(bit, statement.comment);
            // The steps before a transition are read by its rung, which has `cleared`.
            if (!writes_bit_of(statement, BitKind::deactivate) &&
                !writes_bit_of(statement, BitKind::activate)) {
                collect_reads(statement.condition, read_);
            }
            sections_[s].push_back(std::move(statement));
        }
    }
    for (const Condition& condition : cleared_) collect_reads(condition, read_);
    for (std::uint32_t s = 0; s < grafcet.steps.size(); ++s) {
        if (is_read({BitKind::pulse, s})) read_.insert({BitKind::previous, s});
    }
}

Localized SimplifiedScan::comment_of(Bit bit) const {
    const auto found = comments_.find(bit);
    return found == comments_.end() ? Localized() : found->second;
}

void SimplifiedScan::note_graphs(const Grafcet& grafcet, const ScanProgram& program) {
    std::set<Bit> frozen;
    for (const Statement& statement : program.section(SectionKind::outputs)) {
        for (const Bit bit : statement.targets) frozen.insert(bit);
    }
    for (std::uint32_t g = 0; g < grafcet.graphs.size(); ++g) {
        const Bit bit{BitKind::may_evolve, g};
        if (frozen.count(bit) == 0) constants_.emplace(bit, true);
    }
}

/// A transition is cleared where its preceding steps are active and its transition condition is 1:
/// SBR 3 and the conditions of SBR 4 in one.
void SimplifiedScan::note_transitions(const Grafcet& grafcet, const ScanProgram& program) {
    std::vector<Condition> conditions(grafcet.transitions.size());
    cleared_.resize(grafcet.transitions.size());
    before_.resize(grafcet.transitions.size());
    for (const Statement& statement : program.section(SectionKind::conditions)) {
        conditions[statement.targets.front().index] = statement.condition;
    }
    for (const Statement& statement : program.section(SectionKind::evolution)) {
        std::vector<Condition> parts;
        std::uint32_t transition = none;
        const auto add = [&](const Condition& part) {
            const bool is_transition =
                part.kind == Condition::Kind::bit && part.bit.kind == BitKind::transition;
            if (is_transition) transition = part.bit.index;
            parts.push_back(is_transition ? conditions[transition] : part);
        };
        if (statement.condition.kind == Condition::Kind::conjunction) {
            for (const Condition& part : statement.condition.operands) add(part);
        } else {
            add(statement.condition);
        }
        if (transition == none) continue;
        cleared_[transition] = and_condition(std::move(parts));
        collect_reads(statement.condition, before_[transition]);
        before_[transition].erase({BitKind::transition, transition});
    }
    for (std::uint32_t t = 0; t < cleared_.size(); ++t) {
        cleared_[t] = simplified(cleared_[t]);
        if (cleared_[t].is_constant(false)) constants_.emplace(Bit{BitKind::transition, t}, false);
    }
}

Condition SimplifiedScan::simplified(const Condition& condition) const {
    std::vector<Condition> operands;
    std::set<Bit> implied;
    if (condition.kind == Condition::Kind::conjunction) {
        for (const Condition& operand : condition.operands) {
            if (operand.kind != Condition::Kind::bit) continue;
            if (operand.bit.kind == BitKind::transition) implied = before_[operand.bit.index];
        }
    }
    for (const Condition& operand : condition.operands) {
        const bool is_implied = operand.kind == Condition::Kind::bit &&
                                operand.bit.kind == BitKind::previous &&
                                implied.count({BitKind::step, operand.bit.index}) > 0;
        if (!is_implied) operands.push_back(simplified(operand));
    }
    switch (condition.kind) {
        case Condition::Kind::bit: {
            const auto constant = constants_.find(condition.bit);
            return constant == constants_.end() ? condition : constant_condition(constant->second);
        }
        case Condition::Kind::negation:
            return not_condition(std::move(operands.front()));
        case Condition::Kind::conjunction:
            return and_condition(std::move(operands));
        case Condition::Kind::disjunction:
            return or_condition(std::move(operands));
        case Condition::Kind::exclusive_or:
            return exclusive_or_condition(std::move(operands));
        default:
            return condition;
    }
}

}  // namespace grafwire::ladder
