#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "trace/trace.h"

namespace grafwire {

/// A value of a run; unknown behind its last row, for a run that does not settle ends early.
std::int64_t value_in(const Trace& trace, std::size_t row, std::size_t column);

/// The rows in which anything is other than in the row before, in one of two runs of the same
/// columns, and the first and the last: what a timing diagram has a place for. `other` may be null.
std::vector<std::size_t> moments_of(const Trace& trace, const Trace* other);

}  // namespace grafwire
