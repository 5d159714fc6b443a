#pragma once

#include <string>

#include "core/call.h"
#include "core/json.h"

namespace grafwire::testing {

using playground::Json;

/// A core, and a record of what it is asked (asked.cpp).
class AskedCore {
  public:
    AskedCore();
    Json ask(const std::string& name, const Json& args = Json::object(),
             const playground::CheckProgress& progress = {});
    /// A request as it is written.
    std::string call(const std::string& request);

  private:
    playground::Core core_;
    int number_;
};

/// The answer of a core to a request.
Json ask(AskedCore& core, const std::string& name, const Json& args = Json::object(),
         const playground::CheckProgress& progress = {});
/// The same of a core of its own.
Json ask(const std::string& name, const Json& args = Json::object());

/// The text of an example.
std::string chart_text(const std::string& name);

}  // namespace grafwire::testing
