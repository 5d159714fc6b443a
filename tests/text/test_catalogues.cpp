// Every row of every catalogue.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>

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
}

}  // namespace

TEST_CASE("every row of every catalogue is whole, in English and in French") {
    std::size_t catalogues = 0;
    std::size_t rows = 0;
    const std::filesystem::path root = std::filesystem::path(GRAFWIRE_ROOT) / "src";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
        if (entry.path().filename() != "messages.h") continue;
        ++catalogues;
        for (const CatalogueRow& row : rows_of(entry.path())) {
            ++rows;
            CAPTURE(entry.path().string());
            CAPTURE(row.name);
            REQUIRE(row.texts.size() == (row.counts ? 4 : 2));
            for (std::size_t i = 0; i < row.texts.size(); i += 2) {
                check_pair(row, row.texts[i], row.texts[i + 1]);
            }
        }
    }
    CHECK(catalogues >= 5);
    CHECK(rows >= 200);
}

TEST_CASE("what is looked for in French texts is found") {
    CHECK(english_word_in("l'étape « step » is active") == "is");
    CHECK(english_word_in("l'étape « step » n'existe pas") == "");
    CHECK(wrong_mark_in("il manque :") == "no no-break space before :");
    CHECK(wrong_mark_in("il manque\u00a0: c := 0, f.txt:3 et « a ; »") != "");
    CHECK(wrong_mark_in("il manque\u00a0: c := 0, f.txt:3 et «\u00a0a ; b\u00a0»") == "");
    CHECK(wrong_mark_in("la ligne '{}'") == "a name between apostrophes");
}
