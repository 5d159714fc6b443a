#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace grafwire {

/// A comparison with every declared name costs time, and a text of nothing but wrong names must not
/// take for ever: after so many errors no name is suggested any more.
constexpr std::size_t most_suggestions = 100;

/// The declared name nearest to a mistyped one, or empty where none is near enough to suggest: a
/// third of its characters may differ, or one of two. Of equally near names the first is taken.
/// `strat` gives `start` among `stop`, `start`, `stat`; names of one character give nothing, since
/// every other is as near.
std::string_view nearest_name(std::string_view mistyped,
                              const std::vector<std::string_view>& names);

}  // namespace grafwire
