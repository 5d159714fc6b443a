#pragma once

#include <initializer_list>
#include <span>

#include "grafcet/expression.h"

namespace grafwire {

// Operators that build expressions without constant terms: they flatten nested operators of the
// same kind, drop neutral constants and repeated operands, and collapse to a constant where an
// operand decides. The order of the remaining operands is kept. A nested operator with more than
// flatten_limit operands stays whole: it is shared, where copying it into everything that uses it
// could cost the square of the size.

inline constexpr std::size_t flatten_limit = 256;

/// Of no operands: 1 for AND, 0 for OR and XOR. `a.(b.1).a` becomes `a.b`, `a ⊕ b ⊕ a ⊕ 1` `/b`.
ExprId and_of(Expressions& pool, std::span<const ExprId> operands);
ExprId or_of(Expressions& pool, std::span<const ExprId> operands);
ExprId xor_of(Expressions& pool, std::span<const ExprId> operands);
/// Of a negation its operand.
ExprId not_of(Expressions& pool, ExprId operand);

inline ExprId and_of(Expressions& pool, std::initializer_list<ExprId> operands) {
    return and_of(pool, std::span<const ExprId>(operands.begin(), operands.size()));
}
inline ExprId or_of(Expressions& pool, std::initializer_list<ExprId> operands) {
    return or_of(pool, std::span<const ExprId>(operands.begin(), operands.size()));
}

/// Whether it is this constant.
bool is_constant(const Expressions& pool, ExprId id, bool value);

}  // namespace grafwire
