// Every node is found again by a hash of its kind and contents (hash-consing), so that equal
// expressions are one node. Operands are interned before the node that uses them: comparing two
// nodes compares ids, never trees.
//
// A chart is worked through from step to step, so that what is built next resembles what was built
// before, with ids a little larger. The hash puts such expressions side by side, where one line of
// the cache holds the places of several: see hash_of.

#include "grafcet/expression.h"

#include <algorithm>
#include <cassert>
#include <functional>

namespace grafwire {

namespace {

/// One round of the splitmix64 generator: spreads the bits of small numbers over the whole word.
std::uint64_t mix(std::uint64_t seed, std::uint64_t value) {
    std::uint64_t z = seed + 0x9e3779b97f4a7c15U + value;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
}

constexpr std::size_t smallest_table = 64;

std::uint64_t hash_of(const Sum& sum) {
    std::uint64_t hash = sum.size();
    for (const SumTerm& term : sum) {
        hash = mix(hash, (std::uint64_t{term.counter} << 1U) | (term.negative ? 1U : 0U));
        hash = mix(hash, static_cast<std::uint64_t>(term.value));
    }
    return hash;
}

/// The last bits are those of the first operand, the others come from the rest of it and from how
/// far the other operands are from it: expressions of one shape over neighbouring variables are
/// neighbours. An operand that is far away (an input among steps) counts as it is.
std::uint64_t hash_of(ExprKind kind, std::span<const ExprId> operands) {
    constexpr unsigned neighbour_bits = 6;
    constexpr std::int64_t far = 64;
    const auto first = static_cast<std::int64_t>(operands.front());
    std::uint64_t hash = mix(static_cast<std::uint64_t>(kind), operands.size());
    hash = mix(hash, static_cast<std::uint64_t>(first >> neighbour_bits));
    for (const ExprId operand : operands.subspan(1)) {
        const std::int64_t distance = static_cast<std::int64_t>(operand) - first;
        const bool is_near = -far < distance && distance < far;
        hash = mix(hash, is_near ? ~static_cast<std::uint64_t>(distance)
                                 : static_cast<std::uint64_t>(operand));
    }
    return hash << neighbour_bits |
           (static_cast<std::uint64_t>(first) & ((1U << neighbour_bits) - 1));
}

/// Where the search for a hash begins. Two neighbours begin at one place: at least one id in two is
/// that of something else, a variable above all.
std::size_t place_of(std::uint32_t hash) {
    return hash >> 1U;
}

}  // namespace

template <typename Same>
/// The node with that hash that is the same; open addressing with linear probing.
ExprId Expressions::find(std::uint64_t hash, const Same& same) const {
    if (slots_.empty()) return no_expr;
    const std::size_t mask = slots_.size() - 1;
    const auto short_hash = static_cast<std::uint32_t>(hash);
    for (std::size_t i = place_of(short_hash) & mask; slots_[i].id != no_expr; i = (i + 1) & mask) {
        if (slots_[i].hash == short_hash && same(node(slots_[i].id))) return slots_[i].id;
    }
    return no_expr;
}

void Expressions::insert(const Slot& slot) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = place_of(slot.hash) & mask;
    while (slots_[i].id != no_expr) i = (i + 1) & mask;
    slots_[i] = slot;
}

void Expressions::grow(std::size_t slots) {
    std::vector<Slot> old(slots);
    old.swap(slots_);
    for (const Slot& slot : old) {
        if (slot.id != no_expr) insert(slot);
    }
}

ExprId Expressions::add(const Node& new_node, std::uint64_t hash) {
    const auto id = static_cast<ExprId>(nodes_.size());
    nodes_.push_back(new_node);
    if (2 * ++hashed_ > slots_.size()) grow(std::max(2 * slots_.size(), smallest_table));
    insert({static_cast<std::uint32_t>(hash), id});
    return id;
}

void Expressions::reserve(std::size_t nodes, std::size_t hashed, std::size_t operands) {
    nodes_.reserve(nodes);
    operands_.reserve(operands);
    std::size_t slots = smallest_table;
    while (slots < hashed * 2) slots *= 2;
    if (slots > slots_.size()) grow(slots);
}

/// Leaves the pool empty but with its memory: pools that are filled again for every step of a check
/// must not ask for memory each time.
void Expressions::clear() {
    for (const Node& node : nodes_) {
        if (node.kind != ExprKind::variable) continue;
        variables_[node.detail][node.first] = no_expr;
    }
    // A table that has grown is thrown away rather than wiped each time.
    if (slots_.size() > smallest_table) {
        slots_.clear();
    } else {
        std::fill(slots_.begin(), slots_.end(), Slot());
    }
    hashed_ = 0;
    nodes_.clear();
    operands_.clear();
    times_.clear();
    comparisons_.clear();
    edges_.clear();
    time_condition_ids_.clear();
}

/// Operators and edges: the same operands in the same order are the same expression.
ExprId Expressions::with_operands(ExprKind kind, std::span<const ExprId> operands) {
    const std::uint64_t hash = hash_of(kind, operands);
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
    // The operands given may lie in operands_ itself, which moves as it grows.
    const ExprId* const own = operands_.data();
    const bool is_own = !std::less<>()(operands.data(), own) &&
                        std::less<>()(operands.data(), own + operands_.size());
    const std::ptrdiff_t place = is_own ? operands.data() - own : 0;
    operands_.resize(operands_.size() + operands.size());
    std::copy_n(is_own ? operands_.data() + place : operands.data(), operands.size(),
                operands_.data() + node.first);
    return add(node, hash);
}

ExprId Expressions::constant(bool value) {
    const auto detail = static_cast<std::uint8_t>(value ? 1 : 0);
    const std::uint64_t hash = mix(static_cast<std::uint64_t>(ExprKind::constant), detail);
    const ExprId found = find(hash, [&](const Node& other) {
        return other.kind == ExprKind::constant && other.detail == detail;
    });
    return found != no_expr ? found : add({ExprKind::constant, detail, 0, 0}, hash);
}

/// Variables are found by their number, without hashing.
ExprId Expressions::variable(Variable variable) {
    std::vector<ExprId>& known = variables_[static_cast<std::size_t>(variable.kind)];
    if (known.size() <= variable.index) known.resize(variable.index + std::size_t{1}, no_expr);
    ExprId& id = known[variable.index];
    if (id == no_expr) {
        id = static_cast<ExprId>(nodes_.size());
        nodes_.push_back(
            {ExprKind::variable, static_cast<std::uint8_t>(variable.kind), variable.index, 0});
    }
    return id;
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

/// Edges and time conditions get larger ids as they are made, so their lists are in order.
std::size_t Expressions::ordinal(ExprId id) const {
    const std::vector<ExprId>& list =
        kind(id) == ExprKind::time_condition ? time_condition_ids_ : edges_;
    const auto place = std::lower_bound(list.begin(), list.end(), id);
    assert(place != list.end() && *place == id);
    return static_cast<std::size_t>(place - list.begin());
}

}  // namespace grafwire
