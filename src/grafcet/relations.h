#pragma once

#include <array>
#include <string_view>

#include "grafcet/expression.h"

namespace grafwire {

inline constexpr std::array<Relation, 6> all_relations = {
    Relation::equal,      Relation::not_equal, Relation::less,
    Relation::less_equal, Relation::greater,   Relation::greater_equal};

/// A relation as the language of charts, IEC 61131-3 and Pascal write it.
constexpr std::string_view text_of(Relation relation) {
    constexpr std::string_view texts[] = {"=", "<>", "<", "<=", ">", ">="};
    return texts[static_cast<std::size_t>(relation)];
}

/// Whether `left relation right` is true. The sides are numbers, or anything in an order.
template <typename Number>
constexpr bool holds(const Number& left, Relation relation, const Number& right) {
    switch (relation) {
        case Relation::equal:
            return left == right;
        case Relation::not_equal:
            return left != right;
        case Relation::less:
            return left < right;
        case Relation::less_equal:
            return left <= right;
        case Relation::greater:
            return left > right;
        case Relation::greater_equal:
            return left >= right;
    }
    return false;
}

/// The relation that holds exactly where the given one does not.
constexpr Relation complement(Relation relation) {
    switch (relation) {
        case Relation::equal:
            return Relation::not_equal;
        case Relation::not_equal:
            return Relation::equal;
        case Relation::less:
            return Relation::greater_equal;
        case Relation::less_equal:
            return Relation::greater;
        case Relation::greater:
            return Relation::less_equal;
        case Relation::greater_equal:
            return Relation::less;
    }
    return relation;
}

/// The relation with its sides exchanged: `a < b` is `b > a`.
constexpr Relation mirrored(Relation relation) {
    switch (relation) {
        case Relation::less:
            return Relation::greater;
        case Relation::less_equal:
            return Relation::greater_equal;
        case Relation::greater:
            return Relation::less;
        case Relation::greater_equal:
            return Relation::less_equal;
        case Relation::equal:
        case Relation::not_equal:
            break;
    }
    return relation;
}

}  // namespace grafwire
