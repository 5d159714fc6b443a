// Every node is found again by a hash of its kind and contents (hash-consing), so that equal
// expressions are one node. Operands are interned before the node that uses them: comparing two
// nodes compares ids, never trees.

#include "grafcet/expression.h"

#include <algorithm>
#include <cassert>

namespace grafwire {

namespace {

// One round of the splitmix64 generator: spreads the bits of small numbers over the whole word.
std::uint64_t mix(std::uint64_t seed, std::uint64_t value) {
    std::uint64_t z = seed + 0x9e3779b97f4a7c15U + value;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
}

std::uint64_t hash_of(const Sum& sum) {
    std::uint64_t hash = sum.size();
    for (const SumTerm& term : sum) {
        hash = mix(hash, (std::uint64_t{term.counter} << 1U) | (term.negative ? 1U : 0U));
        hash = mix(hash, static_cast<std::uint64_t>(term.value));
    }
    return hash;
}

}  // namespace

template <typename Same>
ExprId Expressions::find(std::uint64_t hash, const Same& same) const {
    if (slots_.empty()) return no_expr;
    const std::size_t mask = slots_.size() - 1;
    const auto short_hash = static_cast<std::uint32_t>(hash);
    for (std::size_t i = short_hash & mask; slots_[i].id != no_expr; i = (i + 1) & mask)
        if (slots_[i].hash == short_hash && same(node(slots_[i].id))) return slots_[i].id;
    return no_expr;
}

void Expressions::insert(const Slot& slot) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = slot.hash & mask;
    while (slots_[i].id != no_expr) i = (i + 1) & mask;
    slots_[i] = slot;
}

ExprId Expressions::add(const Node& new_node, std::uint64_t hash) {
    constexpr std::size_t smallest_table = 64;
    const auto id = static_cast<ExprId>(nodes_.size());
    nodes_.push_back(new_node);
    if (2 * nodes_.size() > slots_.size()) {
        std::vector<Slot> old(std::max(2 * slots_.size(), smallest_table));
        old.swap(slots_);
        for (const Slot& slot : old)
            if (slot.id != no_expr) insert(slot);
    }
    insert({static_cast<std::uint32_t>(hash), id});
    return id;
}

ExprId Expressions::leaf(const Node& node) {
    const std::uint64_t hash =
        mix(mix(static_cast<std::uint64_t>(node.kind), node.detail), node.first);
    const ExprId found = find(hash, [&](const Node& other) {
        return other.kind == node.kind && other.detail == node.detail && other.first == node.first;
    });
    return found != no_expr ? found : add(node, hash);
}

ExprId Expressions::with_operands(ExprKind kind, std::span<const ExprId> operands) {
    std::uint64_t hash = mix(static_cast<std::uint64_t>(kind), operands.size());
    for (const ExprId operand : operands) hash = mix(hash, static_cast<std::uint64_t>(operand));
    const ExprId found = find(hash, [&](const Node& other) {
        return other.kind == kind && other.count == operands.size() &&
               std::equal(operands.begin(), operands.end(),
                          operands_.begin() + static_cast<std::ptrdiff_t>(other.first));
    });
    if (found != no_expr) return found;
    Node node;
    node.kind = kind;
    node.first = static_cast<std::uint32_t>(operands_.size());
    node.count = static_cast<std::uint32_t>(operands.size());
    // Through a copy: the operands may lie in operands_ itself, which grows here.
    const std::vector<ExprId> copy(operands.begin(), operands.end());
    operands_.insert(operands_.end(), copy.begin(), copy.end());
    return add(node, hash);
}

ExprId Expressions::constant(bool value) {
    return leaf({ExprKind::constant, static_cast<std::uint8_t>(value ? 1 : 0), 0, 0});
}

ExprId Expressions::variable(Variable variable) {
    return leaf({ExprKind::variable, static_cast<std::uint8_t>(variable.kind), variable.index, 0});
}

ExprId Expressions::negation(ExprId operand) {
    return with_operands(ExprKind::negation, {&operand, 1});
}

ExprId Expressions::conjunction(std::span<const ExprId> operands) {
    assert(operands.size() >= 2);
    return with_operands(ExprKind::conjunction, operands);
}

ExprId Expressions::disjunction(std::span<const ExprId> operands) {
    assert(operands.size() >= 2);
    return with_operands(ExprKind::disjunction, operands);
}

ExprId Expressions::exclusive_or(std::span<const ExprId> operands) {
    assert(operands.size() >= 2);
    return with_operands(ExprKind::exclusive_or, operands);
}

ExprId Expressions::rise(ExprId operand) {
    const ExprId id = with_operands(ExprKind::rise, {&operand, 1});
    if (edges_.empty() || edges_.back() < id) edges_.push_back(id);
    return id;
}

ExprId Expressions::fall(ExprId operand) {
    const ExprId id = with_operands(ExprKind::fall, {&operand, 1});
    if (edges_.empty() || edges_.back() < id) edges_.push_back(id);
    return id;
}

ExprId Expressions::time_condition(const TimeCondition& condition) {
    std::uint64_t hash = static_cast<std::uint64_t>(ExprKind::time_condition);
    hash = mix(hash, static_cast<std::uint64_t>(condition.on_delay));
    hash = mix(hash, static_cast<std::uint64_t>(condition.operand));
    hash = mix(hash, static_cast<std::uint64_t>(condition.off_delay));
    const ExprId found = find(hash, [&](const Node& other) {
        return other.kind == ExprKind::time_condition && times_[other.first] == condition;
    });
    if (found != no_expr) return found;
    Node node;
    node.kind = ExprKind::time_condition;
    node.first = static_cast<std::uint32_t>(times_.size());
    times_.push_back(condition);
    const ExprId id = add(node, hash);
    time_condition_ids_.push_back(id);
    return id;
}

ExprId Expressions::comparison(const Comparison& comparison) {
    std::uint64_t hash = static_cast<std::uint64_t>(ExprKind::comparison);
    hash = mix(hash, static_cast<std::uint64_t>(comparison.relation));
    hash = mix(hash, hash_of(comparison.left));
    hash = mix(hash, hash_of(comparison.right));
    const ExprId found = find(hash, [&](const Node& other) {
        return other.kind == ExprKind::comparison && comparisons_[other.first] == comparison;
    });
    if (found != no_expr) return found;
    Node node;
    node.kind = ExprKind::comparison;
    node.first = static_cast<std::uint32_t>(comparisons_.size());
    comparisons_.push_back(comparison);
    return add(node, hash);
}

std::size_t Expressions::ordinal(ExprId id) const {
    const std::vector<ExprId>& list =
        kind(id) == ExprKind::time_condition ? time_condition_ids_ : edges_;
    const auto place = std::lower_bound(list.begin(), list.end(), id);
    assert(place != list.end() && *place == id);
    return static_cast<std::size_t>(place - list.begin());
}

}  // namespace grafwire
