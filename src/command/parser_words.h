#pragma once

#include <string>

#include "command/command_line.h"
#include "command/description.h"
#include "text/message.h"

namespace grafwire {

/// A heading as CLI11 takes it, which puts the colon behind it.
std::string label(const Message<>& heading, Language language);

/// The option that shows help: every command has it.
inline constexpr const char* help_names = "-h,--help";
OptionDescription help_option(Language language);

/// Shows the kind of value in help. `described` is complete but for what an AddedOption adds.
AddedOption typed_option(CLI::Option* option, const Message<>& type, OptionDescription& described,
                         Language language);

}  // namespace grafwire
