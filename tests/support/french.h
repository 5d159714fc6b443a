#pragma once

// What can be told by a program about a French text: that it has been translated at all, and that
// its marks stand as French printers set them. Quoted names and parts of programs are left out
// first, since they are the same in every language.

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>

namespace grafwire::testing {

inline bool is_one_of(std::string_view text, std::initializer_list<std::string_view> list) {
    for (const std::string_view item : list) {
        if (text == item) return true;
    }
    return false;
}

inline constexpr std::string_view no_break_space = "\u00a0";
inline constexpr std::string_view narrow_no_break_space = "\u202f";

inline bool ends_with_no_break_space(std::string_view text) {
    return text.ends_with(no_break_space) || text.ends_with(narrow_no_break_space);
}

/// The text without what stands between « and » or between "…".
inline std::string without_quotes(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t at = std::min(text.find("«"), text.find('"'));
        result += text.substr(0, at);
        if (at == text.npos) break;
        const std::string_view end = text[at] == '"' ? "\"" : "»";
        const std::size_t close = text.find(end, at + 1);
        text.remove_prefix(close == text.npos ? text.size() : close + end.size());
    }
    return result;
}

/// The first English word of the text outside of quotes, or nothing.
inline std::string english_word_in(std::string_view french) {
    const std::string text = without_quotes(french);
    std::string word;
    for (std::size_t i = 0; i <= text.size(); ++i) {
        const bool is_letter = i < text.size() && ((text[i] >= 'a' && text[i] <= 'z') ||
                                                   (text[i] >= 'A' && text[i] <= 'Z') ||
                                                   text[i] == '-' || (text[i] & 0x80) != 0);
        if (is_letter) {
            word += text[i];
            continue;
        }
        if (is_one_of(word, {"the",     "The",   "this",  "that",  "is",     "are",      "was",
                             "not",     "no",    "of",    "and",   "or",     "with",     "without",
                             "from",    "to",    "by",    "here",  "has",    "have",     "it",
                             "its",     "which", "only",  "must",  "cannot", "expected", "got",
                             "already", "step",  "steps", "graph", "output", "input",    "counter",
                             "edge",    "name",  "order", "error", "warning"}) &&
            // `graph G { … }` is the language of charts.
            !(word == "graph" && text.substr(i).starts_with(" G"))) {
            return word;
        }
        word.clear();
    }
    return {};
}

/// What is wrong with the marks of the text, or nothing.
inline std::string wrong_mark_in(std::string_view french) {
    for (std::size_t at = french.find("«"); at != french.npos; at = french.find("«", at + 1)) {
        const std::string_view after = french.substr(at + std::string_view("«").size());
        if (!after.starts_with(no_break_space) && !after.starts_with(narrow_no_break_space)) {
            return "no no-break space after «";
        }
    }
    for (std::size_t at = french.find("»"); at != french.npos; at = french.find("»", at + 1)) {
        if (!ends_with_no_break_space(french.substr(0, at))) return "no no-break space before »";
    }
    if (french.find("'{}'") != french.npos) return "a name between apostrophes";
    const std::string text = without_quotes(french);
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (std::string_view(":;?!").find(text[at]) == std::string_view::npos) continue;
        // A mark within a word belongs to a format: `file:3`, `c := 0`.
        const bool ends_word = at + 1 == text.size() || text[at + 1] == ' ' || text[at + 1] == '\n';
        if (ends_word && !ends_with_no_break_space(std::string_view(text).substr(0, at))) {
            return std::string("no no-break space before ") + text[at];
        }
    }
    return {};
}

}  // namespace grafwire::testing
