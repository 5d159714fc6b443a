#pragma once

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on operands and tables of assignment are about.
namespace code {
inline constexpr Code bad_operand{"bad-operand"};
inline constexpr Code address_out_of_range{"address-out-of-range"};
inline constexpr Code bad_address{"bad-address"};
inline constexpr Code unassigned_name{"unassigned-name"};  ///< a warning
}  // namespace code

}  // namespace grafwire
