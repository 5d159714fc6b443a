#pragma once

#include <string>

#include "text/message.h"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace grafwire {

/// A word that is no option of a command, and the one that may have been meant.
Localized unknown_option(const CLI::App& command, const std::string& word);
/// A word that is no command.
Localized unknown_command(const CLI::App& app, const std::string& word);

/// What is wrong with a command line: `app` is the whole, `command` the one that was written.
Localized problem_of(const CLI::App& app, const CLI::App& command, const CLI::ParseError& error);

/// The same, and where to find help on it.
Localized with_help(const CLI::App& app, const Localized& problem);

}  // namespace grafwire
