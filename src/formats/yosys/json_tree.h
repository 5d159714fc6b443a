#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "text/diagnostics.h"

namespace grafwire {

struct JsonMember;

/// A JSON value with the members of its objects in the order of the file.
struct JsonValue {
    enum class Kind { null, boolean, number, string, array, object };
    Kind kind = Kind::null;
    /// string: its text; number: as written; boolean: `true` or `false`.
    std::string text;
    Location where;                   ///< of an object or array: its bracket
    std::vector<JsonMember> members;  ///< of an object
    std::vector<JsonValue> items;     ///< of an array

    /// The first member of that name; nullptr where there is none (or this is no object).
    const JsonValue* find(std::string_view name) const;
};

/// A member of an object. Names may occur twice; the first is what find() gives.
struct JsonMember {
    std::string name;
    JsonValue value;
};

/// Reads a JSON text (RFC 8259). Errors go into `diagnostics` with their place; values nested
/// deeper than a netlist can be (20) are one.
std::optional<JsonValue> parse_json(std::string_view text, Diagnostics& diagnostics);

}  // namespace grafwire
