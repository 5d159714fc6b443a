// The operators do what can be done in one look at the operands. Anything deeper (absorption, say,
// or a + /a) would need a search, and would give equations in which the engineer no longer finds
// the transitions of the chart; minimised() does that where it is asked for.

#include "equations/logic.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace grafwire {

namespace {

/// The operands with nested operators of the same kind replaced by theirs, in order.
std::vector<ExprId> flattened(const Expressions& pool, ExprKind kind,
                              std::span<const ExprId> operands) {
    std::vector<ExprId> flat;
    std::vector<ExprId> pending(operands.rbegin(), operands.rend());
    while (!pending.empty()) {
        const ExprId id = pending.back();
        pending.pop_back();
        if (pool.kind(id) == kind && pool.operands(id).size() <= flatten_limit) {
            const std::span<const ExprId> inner = pool.operands(id);
            pending.insert(pending.end(), inner.rbegin(), inner.rend());
        } else {
            flat.push_back(id);
        }
    }
    return flat;
}

/// Of equal operands the first stays. A list is searched while it is short, which most are.
void drop_repeated(std::vector<ExprId>& ids) {
    constexpr std::size_t few = 16;
    if (ids.size() > few) {
        std::unordered_set<ExprId> seen;
        std::erase_if(ids, [&](ExprId id) { return !seen.insert(id).second; });
        return;
    }
    auto end = ids.begin();
    for (const ExprId id : ids) {
        if (std::find(ids.begin(), end, id) == end) *end++ = id;
    }
    ids.erase(end, ids.end());
}

/// Conjunction and disjunction: the constant `decisive` decides, the other one is neutral.
ExprId and_or_of(Expressions& pool, ExprKind kind, bool decisive,
                 std::span<const ExprId> operands) {
    if (operands.size() == 1) return operands.front();
    std::vector<ExprId> flat = flattened(pool, kind, operands);
    for (const ExprId id : flat) {
        if (is_constant(pool, id, decisive)) return id;
    }
    std::erase_if(flat, [&](ExprId id) { return is_constant(pool, id, !decisive); });
    drop_repeated(flat);
    if (flat.empty()) return pool.constant(!decisive);
    if (flat.size() == 1) return flat.front();
    return kind == ExprKind::conjunction ? pool.conjunction(flat) : pool.disjunction(flat);
}

}  // namespace

bool is_constant(const Expressions& pool, ExprId id, bool value) {
    return pool.kind(id) == ExprKind::constant && pool.constant_value(id) == value;
}

ExprId and_of(Expressions& pool, std::span<const ExprId> operands) {
    return and_or_of(pool, ExprKind::conjunction, false, operands);
}

ExprId or_of(Expressions& pool, std::span<const ExprId> operands) {
    return and_or_of(pool, ExprKind::disjunction, true, operands);
}

ExprId xor_of(Expressions& pool, std::span<const ExprId> operands) {
    std::vector<ExprId> flat = flattened(pool, ExprKind::exclusive_or, operands);
    bool inverted = false;
    std::erase_if(flat, [&](ExprId id) {
        if (is_constant(pool, id, true)) inverted = !inverted;
        return pool.kind(id) == ExprKind::constant;
    });
    // Of an operand that occurs several times, pairs cancel.
    std::unordered_map<ExprId, bool> odd;
    for (const ExprId id : flat) odd[id] = !odd[id];
    std::erase_if(flat, [&](ExprId id) { return !odd[id]; });
    drop_repeated(flat);
    if (flat.empty()) return pool.constant(inverted);
    const ExprId result = flat.size() == 1 ? flat.front() : pool.exclusive_or(flat);
    return inverted ? not_of(pool, result) : result;
}

ExprId not_of(Expressions& pool, ExprId operand) {
    if (pool.kind(operand) == ExprKind::constant) {
        return pool.constant(!pool.constant_value(operand));
    }
    if (pool.kind(operand) == ExprKind::negation) return pool.operands(operand).front();
    return pool.negation(operand);
}

}  // namespace grafwire
