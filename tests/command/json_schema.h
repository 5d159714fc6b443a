#pragma once

#include <string>

namespace grafwire::testing {

/// What a JSON text breaks of the schema of the reports of `check`, a line for each; empty where
/// nothing. Asks the JSON Schema validator of Python (python3-jsonschema).
std::string schema_problems(const std::string& json);
/// The same of another schema, by its path in the sources.
std::string schema_problems(const std::string& json, const std::string& schema);

}  // namespace grafwire::testing
