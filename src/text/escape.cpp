// CSV quotes a field, XML replaces characters. Neither changes what a reader gets back, apart from
// control characters, which XML 1.0 cannot hold in any spelling.

#include "text/escape.h"

namespace grafwire {

namespace {

/// A reader of XML makes a blank of a line feed in an attribute, unless it is written as a
/// reference (XML 1.0, section 3.3.3).
std::string escaped(std::string_view text, bool in_attribute) {
    std::string result;
    for (const char c : text) {
        if (c == '&') {
            result += "&amp;";
        } else if (c == '<') {
            result += "&lt;";
        } else if (c == '>') {
            result += "&gt;";
        } else if (in_attribute && c == '"') {
            result += "&quot;";
        } else if (in_attribute && c == '\n') {
            result += "&#10;";
        } else {
            const bool is_allowed = static_cast<unsigned char>(c) >= 0x20 || c == '\t' || c == '\n';
            result += is_allowed ? c : '?';
        }
    }
    return result;
}

}  // namespace

void append_csv_field(std::string& out, std::string_view field) {
    if (field.find_first_of(",\"\r\n") == std::string_view::npos) {
        out += field;
        return;
    }
    out += '"';
    for (const char c : field) out.append(c == '"' ? 2 : 1, c);
    out += '"';
}

std::string xml_text(std::string_view text) {
    return escaped(text, false);
}

std::string xml_attribute(std::string_view text) {
    return escaped(text, true);
}

}  // namespace grafwire
