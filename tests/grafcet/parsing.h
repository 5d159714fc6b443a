#pragma once

#include <doctest/doctest.h>

#include <string>
#include <string_view>

#include "grafcet/parse_grafcet.h"
#include "grafcet/write_grafcet.h"

namespace grafwire::testing {

/// Every message of a text: `line:column error: message`, notes behind `; note line:column: `, each
/// diagnostic on a line of its own.
inline std::string messages_of(const Diagnostics& diagnostics) {
    std::string result;
    const auto place = [](Location where) {
        return std::to_string(where.line) + ":" + std::to_string(where.column);
    };
    for (const Diagnostic& item : diagnostics.items()) {
        result += place(item.where);
        result += item.severity == Severity::error ? " error: " : " warning: ";
        result += item.message.english + "\n";
        for (const Diagnostic::Note& note : item.notes)
            result += "  " + place(note.where) + " note: " + note.message.english + "\n";
    }
    return result;
}

inline std::string messages_of(std::string_view text) {
    Diagnostics diagnostics;
    const auto grafcet = parse_grafcet({"test", std::string(text)}, diagnostics);
    CHECK(grafcet.has_value() != diagnostics.has_errors());
    return messages_of(diagnostics);
}

/// The model of a text without errors.
inline Grafcet parsed(std::string_view text) {
    Diagnostics diagnostics;
    auto grafcet = parse_grafcet({"test", std::string(text)}, diagnostics);
    REQUIRE_MESSAGE(grafcet.has_value(), messages_of(diagnostics));
    return std::move(*grafcet);
}

/// Whether a text gives exactly one message, of this code.
inline bool gives_only(std::string_view text, Code code) {
    Diagnostics diagnostics;
    parse_grafcet({"test", std::string(text)}, diagnostics);
    return diagnostics.items().size() == 1 && diagnostics.items()[0].code == code;
}

}  // namespace grafwire::testing
