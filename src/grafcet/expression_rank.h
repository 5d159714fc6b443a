#pragma once

#include <cstdint>

#include "grafcet/expression.h"

namespace grafwire {

/// How tightly an expression holds together, as in the grammar of the `.grafcet` language, the
/// loosest first. An operand that holds together no more tightly than its place asks for is put in
/// parentheses.
enum class Rank : std::uint8_t { sum, exclusive, product, unary };

constexpr Rank rank_of(ExprKind kind) {
    switch (kind) {
        case ExprKind::disjunction:
            return Rank::sum;
        case ExprKind::exclusive_or:
            return Rank::exclusive;
        case ExprKind::conjunction:
            return Rank::product;
        default:
            return Rank::unary;
    }
}

}  // namespace grafwire
