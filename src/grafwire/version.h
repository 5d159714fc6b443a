#pragma once

#include <string>

namespace grafwire::api {

/// The version of the library, such as `0.2.0`.
std::string version();

}  // namespace grafwire::api
