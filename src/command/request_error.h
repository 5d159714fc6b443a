#pragma once

#include "text/message.h"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace grafwire {

/// What is wrong with a command line that CLI11 has refused, with a suggestion and where to find
/// help.
Localized request_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace grafwire
