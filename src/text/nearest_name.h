#pragma once

#include <string_view>
#include <vector>

namespace grafwire {

/// The declared name nearest to a mistyped one, or empty where none is near enough to suggest: a
/// third of its characters may differ, or one of two. Of equally near names the first is taken.
/// `strat` gives `start` among `stop`, `start`, `stat`; names of one character give nothing, since
/// every other is as near.
std::string_view nearest_name(std::string_view mistyped,
                              const std::vector<std::string_view>& names);

}  // namespace grafwire
