#pragma once

#include "grafcet/expression.h"

namespace grafwire {

/// A smallest sum of products (fewest products, then fewest operands) equal to the expression,
/// found by Quine–McCluskey over its variables, edges, time conditions and comparisons taken as
/// atoms; no_expr where they are more than 10. Where many products are interchangeable the search
/// for a cover is bounded, and the result is the smallest sum found.
ExprId minimised(Expressions& pool, ExprId id);

}  // namespace grafwire
