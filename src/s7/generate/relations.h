#pragma once

#include <cstdint>

#include "grafcet/expression.h"
#include "s7/listing.h"

namespace grafwire::s7 {

// The controllers compare with =, >= and <= only; <>, < and > are the complements of these.

bool is_complement(Relation relation);
/// Of a relation that is no complement.
Compare compare_of(Relation relation);
/// The relation that holds with left and right exchanged.
Relation mirrored(Relation relation);
bool holds(std::int64_t left, Relation relation, std::int64_t right);

}  // namespace grafwire::s7
