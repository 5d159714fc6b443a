#pragma once

#include <string_view>

namespace grafwire {

/// The version of the program and of the library, such as `0.2.0`.
std::string_view version();

}  // namespace grafwire
