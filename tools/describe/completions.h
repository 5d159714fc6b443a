#pragma once

#include <string>
#include <vector>

#include "command/description.h"

namespace grafwire {

/// A command with what must be written to come to it, but for the name of the program: `s7 run`.
struct PlacedCommand {
    std::string path;  ///< of the program itself: nothing
    const CommandDescription* command = nullptr;
};

/// The program and all its commands, each before those below it.
std::vector<PlacedCommand> placed_commands(const CommandDescription& program);

/// Completions for bash, which shows no descriptions.
std::string bash_completion(const CommandDescription& program);

/// Completions for zsh, and for fish, with descriptions in the language of the user.
std::string zsh_completion(const CommandDescription& english, const CommandDescription& french);
std::string fish_completion(const CommandDescription& english, const CommandDescription& french);

/// The first line of the help of an option: what a shell has room for.
std::string first_line(const OptionDescription& option);

/// A word in single quotes, as sh, bash and zsh read it.
std::string shell_quoted(const std::string& text);

}  // namespace grafwire
