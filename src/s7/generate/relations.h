#pragma once

#include "grafcet/expression.h"
#include "s7/listing.h"

namespace grafwire::s7 {

// The controllers compare with =, >= and <= only; <>, < and > are the complements of these.

constexpr bool is_complement(Relation relation) {
    return relation == Relation::not_equal || relation == Relation::less ||
           relation == Relation::greater;
}

/// Of a relation that is no complement.
constexpr Compare compare_of(Relation relation) {
    if (relation == Relation::equal) return Compare::equal;
    return relation == Relation::less_equal ? Compare::less_equal : Compare::greater_equal;
}

}  // namespace grafwire::s7
