#pragma once

#include <string>
#include <string_view>

namespace grafwire {

/// Appends a field of a CSV row (RFC 4180): quoted only where it has to be.
inline void append_csv_field(std::string& out, std::string_view field) {
    if (field.find_first_of(",\"\r\n") == std::string_view::npos) {
        out += field;
        return;
    }
    out += '"';
    for (const char c : field) out.append(c == '"' ? 2 : 1, c);
    out += '"';
}

}  // namespace grafwire
