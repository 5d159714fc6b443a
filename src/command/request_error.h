#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace grafwire {

/// What is wrong with a command line that could not be read, with a suggestion where a mistyped
/// command or option is near a known one, and where to find help.
std::string explain(const CLI::App& app, const CLI::ParseError& error);

}  // namespace grafwire
