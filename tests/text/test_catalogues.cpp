// Every row of every catalogue: src/**/messages.h are read as text, so that a row is looked at even
// where no test makes the program say it.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "support/french.h"

using namespace grafwire::testing;

namespace {

struct Row {
    std::string name;
    std::vector<std::string> texts;  ///< English, French; twice that where the row counts
    bool counts = false;
    bool is_same_on_purpose = false;
};

/// Reads the literal that begins at `at`, which ends behind it.
std::string read_literal(std::string_view text, std::size_t& at) {
    std::string result;
    for (++at; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] != '\\') {
            result += text[at];
            continue;
        }
        ++at;
        result += text[at] == 'n' ? '\n' : text[at] == 't' ? '\t' : text[at];
    }
    ++at;
    return result;
}

/// Literals that stand side by side are one text, as for the compiler.
Row read_row(std::string_view text, std::size_t& at) {
    Row row;
    const std::size_t arguments = at;
    at = text.find('{', at);
    const std::size_t name = text.rfind('>', at) + 2;
    row.name = std::string(text.substr(name, at - name));
    row.counts = text.substr(arguments).starts_with("CountedMessage<");
    bool goes_on = false;
    while (at < text.size() && text[at] != ';') {
        if (text[at] == '"') {
            if (!goes_on) row.texts.emplace_back();
            row.texts.back() += read_literal(text, at);
            goes_on = true;
            continue;
        }
        if (text[at] == ',' || text[at] == '{' || text[at] == '}') goes_on = false;
        ++at;
    }
    return row;
}

std::vector<Row> rows_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    constexpr std::string_view beginning = "inline constexpr ";
    std::vector<Row> rows;
    for (std::size_t at = text.find(beginning); at != text.npos; at = text.find(beginning, at)) {
        const std::size_t comment = text.rfind("\n/// ", at);
        const bool is_commented = comment != text.npos && text.find('\n', comment + 1) + 1 == at;
        at += beginning.size();
        const std::string_view rest = std::string_view(text).substr(at);
        if (!rest.starts_with("Message<") && !rest.starts_with("CountedMessage<")) continue;
        Row row = read_row(text, at);
        row.is_same_on_purpose =
            is_commented &&
            text.substr(comment, text.find('\n', comment + 1) - comment).find("same in both") !=
                text.npos;
        rows.push_back(std::move(row));
    }
    return rows;
}

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

/// Reports on a terminal are set with plain spaces before : and ;.
bool is_plainly_set(std::string_view folder) {
    return is_one_of(folder, {"check", "explain", "laddercheck", "s7check"});
}

void check_pair(const Row& row, std::string_view folder, const std::string& english,
                const std::string& french) {
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
    if (!is_plainly_set(folder)) CHECK(wrong_mark_in(french) == "");
}

}  // namespace

TEST_CASE("every row of every catalogue is whole, in English and in French") {
    std::size_t catalogues = 0;
    std::size_t rows = 0;
    const std::filesystem::path root = std::filesystem::path(GRAFWIRE_ROOT) / "src";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
        if (entry.path().filename() != "messages.h") continue;
        ++catalogues;
        const std::string folder = entry.path().parent_path().filename().string();
        for (const Row& row : rows_of(entry.path())) {
            ++rows;
            CAPTURE(entry.path().string());
            CAPTURE(row.name);
            REQUIRE(row.texts.size() == (row.counts ? 4 : 2));
            for (std::size_t i = 0; i < row.texts.size(); i += 2) {
                check_pair(row, folder, row.texts[i], row.texts[i + 1]);
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
