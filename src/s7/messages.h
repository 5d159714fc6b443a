#pragma once

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on S7-200 listings are about.
namespace code {
inline constexpr Code unknown_instruction{"unknown-instruction"};
inline constexpr Code bad_network{"bad-network"};
inline constexpr Code bad_control_flow{"bad-control-flow"};
inline constexpr Code bad_stack{"bad-stack"};
inline constexpr Code bad_offset{"bad-offset"};
inline constexpr Code program_too_long{"program-too-long"};
inline constexpr Code read_leniently{"read-leniently"};
}  // namespace code

}  // namespace grafwire
