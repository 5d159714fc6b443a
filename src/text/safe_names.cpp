// Names of charts may be any text; a language has letters, digits and underscores. They are
// transliterated, not numbered, because the engineer who commissions the program looks for the
// names of the chart in it; a number keeps apart what transliteration makes equal.

#include "text/safe_names.h"

#include <fmt/format.h>

#include "text/utf8.h"

namespace grafwire {

namespace {

struct Spelling {
    std::string_view ascii;
    std::string_view characters;  ///< all that are written so
};

/// The letters of the languages of Western Europe, and the signs met in names of equipment.
constexpr Spelling spellings[] = {
    {"_plus_", "+"}, {"_minus_", "-"}, {"_star_", "*"}, {"_percent_", "%"}, {"_deg_", "°"},
    {"_eq_", "="},   {"_lt_", "<"},    {"_gt_", ">"},   {"_and_", "&"},     {"rise_", "↑"},
    {"fall_", "↓"},  {"2", "²"},       {"3", "³"},      {"u", "µùúûü"},     {"A", "ÀÁÂÃÄÅ"},
    {"a", "àáâãäå"}, {"AE", "Æ"},      {"ae", "æ"},     {"C", "Ç"},         {"c", "ç"},
    {"E", "ÈÉÊË"},   {"e", "èéêë"},    {"I", "ÌÍÎÏ"},   {"i", "ìíîï"},      {"N", "Ñ"},
    {"n", "ñ"},      {"O", "ÒÓÔÕÖØ"},  {"o", "òóôõöø"}, {"OE", "Œ"},        {"oe", "œ"},
    {"U", "ÙÚÛÜ"},   {"Y", "ÝŸ"},      {"y", "ýÿ"},     {"ss", "ß"},
};

/// How a character is written; an underscore for other signs of ASCII.
std::string spelling_of(CodePoint point, std::string_view bytes) {
    if (point.value < 0x80 && (is_ascii_letter(static_cast<char>(point.value)) ||
                               is_digit(static_cast<char>(point.value)))) {
        return std::string(bytes);
    }
    for (const Spelling& spelling : spellings) {
        if (spelling.characters.find(bytes) != std::string_view::npos) {
            return std::string(spelling.ascii);
        }
    }
    if (point.value < 0x80) return "_";
    return fmt::format("u{:04X}", static_cast<std::uint32_t>(point.value));
}

}  // namespace

std::string ascii_word(std::string_view name) {
    std::string written;
    for (std::size_t at = 0; at < name.size();) {
        const CodePoint point = decode_utf8(name, at);
        const std::size_t length = point.length == 0 ? 1 : point.length;
        written += spelling_of(point, name.substr(at, length));
        at += length;
    }
    // Underscores stand between words only, and a digit does not begin one: `_plus_` of `V+` leaves
    // `V_plus`, `5s` becomes `n5s`.
    std::string word;
    for (const char c : written) {
        if (c == '_' && (word.empty() || word.back() == '_')) continue;
        if (word.empty() && is_digit(c)) word = "n";
        word.push_back(c);
    }
    while (!word.empty() && word.back() == '_') word.pop_back();
    return word.empty() ? "n" : word;
}

std::string SafeNames::folded(std::string name) const {
    if (case_matters_) return name;
    for (char& c : name) c = lower_case(c);
    return name;
}

bool SafeNames::keep(const std::string& name) {
    const std::string compared = folded(name);
    return !is_reserved_(compared) && taken_.try_emplace(compared, 1).second;
}

std::string SafeNames::claim_word(std::string word) {
    if (keep(word)) return word;
    // A reference into the table stays good while names are added.
    std::uint32_t& number = taken_.try_emplace(folded(word), 1).first->second;
    std::string name;
    do {
        name = fmt::format("{}_{}", word, ++number);
    } while (!keep(name));
    return name;
}

std::string SafeNames::claim(std::string_view wanted) {
    return claim_word(ascii_word(wanted));
}

}  // namespace grafwire
