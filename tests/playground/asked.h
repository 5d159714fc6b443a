#pragma once

#include <string>

#include "core/call.h"
#include "core/json.h"

namespace grafwire::testing {

using playground::Json;

/// The answer of a core to a request.
Json ask(playground::Core& core, const std::string& name, const Json& args = Json::object(),
         const playground::CheckProgress& progress = {});
/// The same of a core of its own.
Json ask(const std::string& name, const Json& args = Json::object());

/// The text of an example.
std::string chart_text(const std::string& name);

}  // namespace grafwire::testing
