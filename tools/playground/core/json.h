#pragma once

#include <nlohmann/json.hpp>

namespace grafwire::playground {

/// An object keeps its members in the order in which they were put in.
using Json = nlohmann::ordered_json;

}  // namespace grafwire::playground
