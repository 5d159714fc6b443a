#pragma once

#include <string>

#include "evolution/bit_table.h"

namespace grafwire {

/// Appends the bits of a table to a key, all of them. States are compared by such keys, which hold
/// the whole of them, never by a digest: a collision would be a wrong verdict.
void append_key(std::string& key, const BitTable& bits);

}  // namespace grafwire
