#pragma once

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on stimuli are about.
namespace code {
inline constexpr Code bad_time{"bad-time"};
inline constexpr Code time_order{"time-order"};
inline constexpr Code bad_value{"bad-value"};
}  // namespace code

}  // namespace grafwire
