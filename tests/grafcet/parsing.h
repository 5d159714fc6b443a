#pragma once

#include <doctest/doctest.h>

#include <string>
#include <string_view>

#include "grafcet/parse_grafcet.h"
#include "grafcet/write_grafcet.h"
#include "support/french.h"

namespace grafwire::testing {

/// That a message has been translated. Every chart that a test breaks comes by here.
inline void check_french(const Localized& message) {
    CAPTURE(message.english);
    CHECK(message.french != message.english);
    CHECK_MESSAGE(english_word_in(message.french) == "", message.french);
    CHECK_MESSAGE(wrong_mark_in(message.french) == "", message.french);
}

/// Every message of a text in English: `line:column error: message`, notes behind `; note
/// line:column: `, each diagnostic on a line of its own. The French is checked on the way.
inline std::string messages_of(const Diagnostics& diagnostics) {
    std::string result;
    const auto place = [](Location where) {
        return std::to_string(where.line) + ":" + std::to_string(where.column);
    };
    for (const Diagnostic& item : diagnostics.items()) {
        result += place(item.where);
        result += item.severity == Severity::error ? " error: " : " warning: ";
        result += item.message.english + "\n";
        check_french(item.message);
        for (const Diagnostic::Note& note : item.notes) {
            result += "  " + place(note.where) + " note: " + note.message.english + "\n";
            check_french(note.message);
        }
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
