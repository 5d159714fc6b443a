#pragma once

#include <span>

#include "command/command_line.h"

namespace grafwire {

/// All commands, in the order in which help shows them.
std::span<const Command> all_commands();

}  // namespace grafwire
