#pragma once

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on netlists of other programs are about.
namespace code {
inline constexpr Code bad_netlist{"bad-netlist"};
}  // namespace code

}  // namespace grafwire
