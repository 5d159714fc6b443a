#pragma once

#include <span>

#include "grafcet/expression.h"

namespace grafwire {

// Operators that build expressions without constant terms: they flatten nested operators of the
// same kind, drop neutral constants and repeated operands, and collapse to a constant where an
// operand decides. The order of the remaining operands is kept.

ExprId and_of(Expressions& pool, std::span<const ExprId> operands);
ExprId or_of(Expressions& pool, std::span<const ExprId> operands);
ExprId xor_of(Expressions& pool, std::span<const ExprId> operands);
ExprId not_of(Expressions& pool, ExprId operand);

bool is_constant(const Expressions& pool, ExprId id, bool value);

}  // namespace grafwire
