#pragma once

#include <string>

namespace grafwire::testing {

/// The chart with some of what the language has two ways for written the other way: a condition or
/// a duration under a name of its own, French keywords and operators. With `held` also a var that a
/// step holds, which a condition reads. What is changed depends on the text alone, so that a random
/// chart remains that of its seed.
std::string with_named_parts(const std::string& chart, bool held);

}  // namespace grafwire::testing
