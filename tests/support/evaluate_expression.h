#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "grafcet/expression.h"

namespace grafwire::testing {

/// What an expression reads. Edges and time conditions are not worked out: each has a value, by its
/// ordinal.
struct ExpressionValues {
    std::function<bool(Variable)> variable;
    std::function<bool(std::size_t)> edge;
    std::function<bool(std::size_t)> time_condition;
    std::function<std::int64_t(std::uint32_t)> counter;
};

/// The value of an expression, and of the numbers in it, as plainly as the definition says.
bool value_of(const Expressions& pool, ExprId id, const ExpressionValues& values);
bool value_of(const Comparison& comparison,
              const std::function<std::int64_t(std::uint32_t)>& counter);
std::int64_t value_of(const Sum& sum, const std::function<std::int64_t(std::uint32_t)>& counter);

}  // namespace grafwire::testing
