#pragma once

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on programs in other languages are about.
namespace code {
inline constexpr Code beyond_limit{"beyond-limit"};
inline constexpr Code unsupported_by_language{"unsupported-by-language"};
}  // namespace code

}  // namespace grafwire
