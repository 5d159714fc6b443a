#pragma once

#include <string>
#include <string_view>

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on the netlist styles are about.
namespace code {
inline constexpr Code unsupported_by_style{"unsupported-by-style"};
}  // namespace code

namespace messages::netlist_styles {

inline constexpr Message<std::string_view, std::string> no_registers{
    "the {} style has no registers for the counter '{}'; use --style clocked",
    "le style {} n'a pas de registre pour le compteur « {} » ; utilisez --style clocked"};

}  // namespace messages::netlist_styles

}  // namespace grafwire
