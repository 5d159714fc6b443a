#pragma once

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on the equations are about.
namespace code {
inline constexpr Code wiring_hazard{"wiring-hazard"};
}  // namespace code

}  // namespace grafwire
