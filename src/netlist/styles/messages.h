#pragma once

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on the netlist styles are about.
namespace code {
inline constexpr Code unsupported_by_style{"unsupported-by-style"};
}  // namespace code

}  // namespace grafwire
