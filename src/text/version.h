#pragma once

#include <string>
#include <string_view>

namespace grafwire {

/// The version of the program and of the library, such as `0.2.0`.
std::string_view version();

/// What has written a file, as the file says it where its format has comments: `grafwire 0.2.0`.
std::string program_and_version();

}  // namespace grafwire
