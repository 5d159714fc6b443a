#pragma once

#include <string>
#include <string_view>

namespace grafwire {

/// One of several JSON texts on a line of its own, with its end. `file` becomes its first member,
/// unless it says itself which file it is about.
std::string json_line(const std::string& json, std::string_view file = {});

}  // namespace grafwire
