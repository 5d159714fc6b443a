#include "text/xml.h"

namespace grafwire {

namespace {

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

std::string xml_text(std::string_view text) {
    return escaped(text, false);
}

std::string xml_attribute(std::string_view text) {
    return escaped(text, true);
}

}  // namespace grafwire
