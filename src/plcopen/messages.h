#pragma once

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on PLCopen projects are about.
namespace code {
inline constexpr Code bad_ladder{"bad-ladder"};
}  // namespace code

}  // namespace grafwire
