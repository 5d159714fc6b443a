// Every row of every catalogue.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "support/catalogues.h"
#include "support/french.h"

using namespace grafwire::testing;

namespace {

/// Which arguments a text shows: {} {} counts as {0} {1}.
std::set<std::size_t> arguments_of(std::string_view text) {
    std::set<std::size_t> arguments;
    std::size_t next = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] != '{') continue;
        if (text.substr(at).starts_with("{{")) {
            ++at;
            continue;
        }
        std::size_t number = 0;
        bool is_numbered = false;
        for (++at; text[at] >= '0' && text[at] <= '9'; ++at) {
            number = 10 * number + static_cast<std::size_t>(text[at] - '0');
            is_numbered = true;
        }
        arguments.insert(is_numbered ? number : next++);
    }
    return arguments;
}

/// Whether it has words that could be translated.
bool has_words(std::string_view text) {
    std::size_t letters = 0;
    bool is_argument = false;
    for (const char c : text) {
        if (c == '{') is_argument = true;
        if (c == '}') is_argument = false;
        if (!is_argument && ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'))) ++letters;
    }
    return letters != 0;
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c & 0x80) != 0;
}

/// How often two blanks or more stand between words: a message laid out in columns has them.
std::size_t wide_gaps(std::string_view text) {
    std::size_t gaps = 0;
    for (std::size_t at = 1; at + 2 < text.size(); ++at) {
        if (text[at - 1] != ' ' && text[at - 1] != '\n' && text.substr(at, 2) == "  ") {
            gaps += text.find_first_not_of(' ', at) != text.npos;
        }
    }
    return gaps;
}

/// The blanks and line ends before the first word.
std::string_view beginning_of(std::string_view text) {
    return text.substr(0, std::min(text.find_first_not_of(" \n"), text.size()));
}

/// The mark and the line ends behind the last word.
std::string end_of(std::string_view text) {
    std::string end;
    for (; text.ends_with('\n'); text.remove_suffix(1)) end += '\n';
    if (!text.empty() && std::string_view(".:;?!").find(text.back()) != std::string_view::npos) {
        end += text.back();
    }
    return end;
}

/// A unit behind a blank at which a line may be broken, or nothing.
std::string loose_unit_in(std::string_view french) {
    for (const std::string_view unit : {"ps", "ns", "us", "ms", "s", "min", "h", "V", "%"}) {
        for (std::size_t at = french.find(' '); at != french.npos; at = french.find(' ', at + 1)) {
            const bool follows_number =
                at != 0 &&
                (french[at - 1] == '}' || (french[at - 1] >= '0' && french[at - 1] <= '9'));
            const std::string_view rest = french.substr(at + 1);
            const bool is_unit = rest.starts_with(unit) &&
                                 (rest.size() == unit.size() ||
                                  (!is_letter(rest[unit.size()]) && rest[unit.size()] != '\''));
            if (follows_number && is_unit) return std::string(unit);
        }
    }
    return {};
}

/// The types of the arguments of a row, `std::size_t`, `Localized`.
std::vector<std::string> argument_types(std::string_view row_type) {
    std::vector<std::string> types;
    const std::size_t begin = row_type.find('<');
    if (begin == row_type.npos) return types;
    std::string type;
    for (const char c : row_type.substr(begin + 1)) {
        if (c == ',' || c == '>') {
            if (!type.empty()) types.push_back(type);
            type.clear();
        } else if (c != ' ' && c != '\n') {
            type += c;
        }
    }
    return types;
}

/// The plural behind a number that nothing says is more than one: `{} steps`; or nothing.
std::string fixed_plural_in(const CatalogueRow& row, std::string_view english) {
    const std::vector<std::string> types = argument_types(row.type);
    if (row.counts || row.comment.find("more than one") != row.comment.npos) return {};
    std::size_t next = 0;
    for (std::size_t at = english.find('{'); at != english.npos; at = english.find('{', at + 1)) {
        if (english.substr(at).starts_with("{{")) {
            ++at;
            continue;
        }
        const std::size_t number = next++;
        const std::size_t close = english.find('}', at);
        if (number >= types.size() || close == english.npos) continue;
        const bool is_count =
            types[number].find("int") != std::string::npos || types[number] == "std::size_t";
        if (!is_count || english.substr(close + 1, 1) != " ") continue;
        std::size_t end = close + 2;
        while (end < english.size() && is_letter(english[end])) ++end;
        const std::string word(english.substr(close + 2, end - close - 2));
        const bool is_verb = is_one_of(word, {"is", "reads", "comes", "begins", "clears"});
        if (word.ends_with('s') && !is_verb) return word;
    }
    return {};
}

void check_pair(const CatalogueRow& row, const std::string& english, const std::string& french) {
    CHECK_FALSE(english.empty());
    CHECK_FALSE(french.empty());
    std::set<std::size_t> in_english = arguments_of(english);
    std::set<std::size_t> in_french = arguments_of(french);
    if (row.counts) {  // one may be said in words
        in_english.erase(0);
        in_french.erase(0);
    }
    CHECK(in_english == in_french);
    if (has_words(english)) CHECK((english == french) == row.is_same_on_purpose);
    if (!row.is_same_on_purpose) CHECK(english_word_in(french) == "");
    CHECK(wrong_mark_in(french) == "");
    CHECK(loose_unit_in(french) == "");
    CHECK(fixed_plural_in(row, english) == "");
    CHECK(wide_gaps(english) == wide_gaps(french));
    CHECK(beginning_of(english) == beginning_of(french));
    CHECK(end_of(english) == end_of(french));
    for (const std::string& text : {english, french}) CHECK(text.find("’") == text.npos);
}

}  // namespace

TEST_CASE("every row of every catalogue is whole, in English and in French") {
    const std::vector<Catalogue> catalogues = all_catalogues();
    std::size_t rows = 0;
    for (const Catalogue& catalogue : catalogues) {
        for (const CatalogueRow& row : catalogue.rows) {
            ++rows;
            CAPTURE(catalogue.path.string());
            CAPTURE(row.name);
            const std::size_t texts_of_one = row.counts ? 4 : 2;
            REQUIRE(row.texts.size() % texts_of_one == 0);
            REQUIRE((row.texts.size() == texts_of_one) == !row.name.ends_with("[]"));
            for (std::size_t i = 0; i < row.texts.size(); i += 2) {
                check_pair(row, row.texts[i], row.texts[i + 1]);
            }
        }
    }
    CHECK(catalogues.size() >= 28);
    CHECK(rows >= 800);
}

TEST_CASE("what is looked for in French texts is found") {
    CHECK(english_word_in("l'étape « step » is active") == "is");
    CHECK(english_word_in("l'étape « step » n'existe pas") == "");
    CHECK(wrong_mark_in("il manque :") == "no no-break space before :");
    CHECK(wrong_mark_in("il manque\u00a0: c := 0, f.txt:3 et « a ; »") != "");
    CHECK(wrong_mark_in("il manque\u00a0: c := 0, f.txt:3 et «\u00a0a ; b\u00a0»") == "");
    CHECK(wrong_mark_in("la ligne '{}'") == "a name between apostrophes");
    CHECK(loose_unit_in("à {} ms") == "ms");
    CHECK(loose_unit_in("à {}\u00a0ms, un Grafcet partiel 1 s'y trouve") == "");
    CHECK(loose_unit_in("1 sommet") == "");
    CHECK(end_of("Cause\u00a0:\n") == "\n:");
    CHECK(beginning_of("\n  a b") == "\n  ");
    CHECK(wide_gaps("  a  b\n  c   d") == 2);
    CatalogueRow row;
    row.type = "Message<std::size_t, Localized>";
    CHECK(fixed_plural_in(row, "{} steps of {}") == "steps");
    CHECK(fixed_plural_in(row, "{} of {} steps") == "");
    row.comment = "/// Of more than one.";
    CHECK(fixed_plural_in(row, "{} steps of {}") == "");
}
