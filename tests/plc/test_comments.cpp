// Comments and headings of programs in French: no word of the English ones is left in them.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "plc/formats.h"
#include "plc/shared/source_text.h"
#include "random/read_text.h"
#include "support/catalogues.h"
#include "support/files.h"
#include "text/utf8.h"

namespace grafwire::testing {

namespace {

/// Its words of three letters or more, `edge_memory0` being none.
std::set<std::string> words_of(std::string_view text) {
    std::set<std::string> words;
    std::string word;
    for (std::size_t at = 0; at <= text.size(); ++at) {
        const char c = at < text.size() ? text[at] : ' ';
        const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c & 0x80) != 0;
        if (is_letter || c == '_' || (c >= '0' && c <= '9')) {
            word += c;
            continue;
        }
        if (word.size() >= 3 && word.find_first_of("_0123456789") == word.npos) words.insert(word);
        word.clear();
    }
    return words;
}

/// The words that programs use in English comments and in no French one.
std::set<std::string> english_words() {
    std::set<std::string> english;
    std::set<std::string> french;
    const std::filesystem::path source = std::filesystem::path(GRAFWIRE_ROOT) / "src";
    for (const char* folder :
         {"program", "plc/shared", "plc/computer", "plc/iec", "plc/pl7", "plc/step7", "ladder",
          "ladder/draw", "plcopen", "s7/generate", "sfc"}) {
        const std::vector<CatalogueRow> rows = rows_of(source / folder / "messages.h");
        CHECK_FALSE(rows.empty());
        for (const CatalogueRow& row : rows) {
            for (std::size_t i = 0; i < row.texts.size(); ++i) {
                (i % 2 == 0 ? english : french).merge(words_of(row.texts[i]));
            }
        }
    }
    for (const std::string& word : french) english.erase(word);
    return english;
}

/// What stands between two marks, wherever it does; to the end of the line where there is no end.
std::string between(const std::string& text, std::string_view begin, std::string_view end) {
    std::string found;
    for (std::size_t at = text.find(begin); at != text.npos; at = text.find(begin, at)) {
        at += begin.size();
        const std::size_t to = std::min(text.find(end, at), text.size());
        found += text.substr(at, to - at) + "\n";
        at = std::min(to + end.size(), text.size());
    }
    return found;
}

/// The comments and headings of a program in a language.
std::string comments_of(const std::string& language, const std::string& text) {
    if (language == "st" || language == "il") return between(text, "(*", "*)");
    if (language == "python") return between(text, "#", "\n") + between(text, "\"\"\"", "\"\"\"");
    if (language == "text") return between(text, "  # ", "\n");
    if (language == "ladder-svg") {
        const std::string texts =
            between(text, "\"comment\"", "</text>") + between(text, "\"heading\"", "</text>");
        return between(texts, ">", "\n");
    }
    if (language == "ladder") return between(text, "── ", " ──");
    if (language == "plcopen" || language == "sfc") return between(text, "<xhtml:p>", "</xhtml:p>");
    if (language == "pl7-2") return text;
    return between(text, "//", "\n") + between(text, "TITLE = ", "\n");
}

std::string french_program(const PlcFormat& format, const Grafcet& grafcet) {
    PlcOptions options;
    options.language = Language::french;
    Diagnostics diagnostics;
    return format.write(grafcet, program_from(grafcet, {}), options, diagnostics);
}

/// The English words in the comments of a chart's programs, each with its language.
std::string english_left(const std::string& chart, const std::set<std::string>& english,
                         std::size_t& programs) {
    const auto grafcet = read_grafcet(chart);
    REQUIRE(grafcet);
    const std::set<std::string> own = words_of(chart);  // what the author of the chart wrote
    std::string left;
    for (const PlcFormat& format : plc_formats()) {
        const std::string text = french_program(format, *grafcet);
        if (text.empty()) continue;  // refused
        ++programs;
        for (const std::string& word : words_of(comments_of(std::string(format.name), text))) {
            if (english.count(word) != 0 && own.count(word) == 0) {
                left += std::string(format.name) + ": " + word + "\n";
            }
        }
    }
    return left;
}

/// With everything that comments speak of.
constexpr const char* rich_chart = R"(
grafcet g "Tout"
input a, b
output O, P, Q, R
var v
counter n : 0..5
counter m : -3..9
graph S {
  initial 0
  step 1 : T{20}, U{*}
  step 2 : T{INIT}, V{}
  step 3 encloses W{40}
  0 -> 1 : a xor ↑(b . a)
  1 -> 2 : b do v := /v . a
  2 -> 3 : [n + n > n + 3]
  3 -> 0 : X40
}
graph T {
  initial 10 : O, set R on ↓v
  step 20 : P if a, set Q on ↑b, reset Q on deactivation
  10 -> 20 : 1s/a/2s
  20 -> 10 : 2s/X20 do n := n + 1, m := -n - 1
}
graph U {
  initial 30
  30 -> 30 : 5ms/(↑a)/7s
}
graph V {
  step 50
  -> 50 : a
  50 -> : b
}
graph W {
  step 40
  step 41
  40 -> 41 : b
}
)";

}  // namespace

TEST_CASE("a program in French has no English comment") {
    const std::set<std::string> english = english_words();
    CHECK(english.contains("before"));
    CHECK_FALSE(english.contains("outputs"));  // a name in the lines on how to use a program
    std::size_t programs = 0;
    for (const std::string& name : example_names()) {
        CAPTURE(name);
        CHECK(english_left(example_text(name + ".grafcet"), english, programs) == "");
    }
    CHECK(programs >= 150);
    programs = 0;
    CHECK(english_left(rich_chart, english, programs) == "");
    CHECK(programs >= 11);
}

TEST_CASE("the titles of STL networks are no longer than SIMATIC allows") {
    for (std::size_t s = 0; s < section_count; ++s) {
        const Localized title = section_title(static_cast<SectionKind>(s));
        CHECK(count_code_points(title.english) <= 64);
        CHECK(count_code_points(title.french) <= 64);
    }
}

}  // namespace grafwire::testing
