// The canonical layout of a text is the same chart with the same comments, and stays as it is: for
// every chart of the project, for random ones, and for those with comments and line ends strewn in.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "grafcet/describe_grafcet.h"
#include "grafcet/format_grafcet.h"
#include "grafcet/lexer.h"
#include "grafcet/write_grafcet.h"
#include "properties/same_model.h"
#include "random/random_cases.h"
#include "random/random_source.h"
#include "random/read_text.h"
#include "support/files.h"

namespace grafwire::testing {

namespace {

constexpr Language languages[] = {Language::english, Language::french};

std::string formatted(const std::string& text, Language language) {
    Diagnostics diagnostics;
    return format_grafcet({"test", text}, language, diagnostics).value_or("refused");
}

/// The texts of comments, as they are told from quoted texts.
std::vector<std::string> comments_of(const std::string& text) {
    std::vector<std::string> comments;
    bool is_quoted = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '"') is_quoted = !is_quoted;
        if (text[at] != '#' || is_quoted) continue;
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string comment = text.substr(at, end - at);
        comment.erase(comment.find_last_not_of(" \t\r") + 1);
        comments.push_back(comment);
        at = end;
    }
    return comments;
}

/// Whether lines are as they have to be whatever is in them.
std::string fault_of_lines(const std::string& text) {
    if (text.empty() || text.back() != '\n') return "no line feed at the end";
    if (text.front() == '\n') return "a blank line at the beginning";
    if (text.ends_with("\n\n")) return "a blank line at the end";
    if (text.find("\n\n\n") != text.npos) return "two blank lines";
    if (text.find(" \n") != text.npos) return "blanks at the end of a line";
    if (text.find_first_of("\r\t") != text.npos) return "a tab or carriage return";
    return {};
}

/// What is wrong with the layouts of a chart without errors.
std::string fault_of_format(const std::string& text) {
    const auto grafcet = read_grafcet(text);
    for (const Language language : languages) {
        const std::string result = formatted(text, language);
        std::string messages;
        const auto again = read_grafcet(result, &messages);
        if (!again) return "the layout cannot be read:\n" + messages + result;
        const std::string difference = model_difference(*grafcet, *again);
        if (!difference.empty()) return "not the same model in " + difference + ":\n" + result;
        if (write_grafcet(*grafcet) != write_grafcet(*again)) return "another chart:\n" + result;
        if (describe_grafcet(*grafcet, language) != describe_grafcet(*again, language)) {
            return "described differently:\n" + result;
        }
        if (formatted(result, language) != result) return "laid out otherwise again:\n" + result;
        if (comments_of(text) != comments_of(result)) return "other comments:\n" + result;
        if (const std::string fault = fault_of_lines(result); !fault.empty()) {
            return fault + ":\n" + result;
        }
    }
    if (formatted(formatted(text, Language::french), Language::english) !=
        formatted(text, Language::english)) {
        return "English after French is another layout:\n" + formatted(text, Language::english);
    }
    return {};
}

std::string fault_of_case(const RandomCase& item) {
    return fault_of_format(item.chart);
}

/// The text with comments, line ends and blanks strewn in between its tokens. Some of what comes
/// out is no chart any more: a label in the midst of a line, say.
std::string strewn(RandomSource& random, const std::string& text) {
    Lexer lexer(text);
    std::string result;
    std::size_t at = 0;
    int comments = 0;
    for (Token token = lexer.next(nullptr); token.kind != TokenKind::end;
         token = lexer.next(nullptr)) {
        const std::size_t begin = token.offset - (token.kind == TokenKind::quoted ? 1U : 0U);
        std::string gap = text.substr(at, begin - at);
        switch (random.below(12)) {
            case 0:
                gap += "\n";
                break;
            case 1:
                gap += "  # comment " + std::to_string(++comments) + "  \n";
                break;
            case 2:
                gap += "\n\n\n\t# \"comment " + std::to_string(++comments) + "\"\r\n\n\n";
                break;
            case 3:
                if (gap == "\n") gap = " ";
                break;
            case 4:
                gap += "\u00a0 ";
                break;
            default:
                break;
        }
        result += gap;
        at = begin;
    }
    return result + text.substr(at);
}

/// The charts that stand in the tests as raw strings.
std::vector<std::string> charts_in_tests() {
    std::vector<std::string> charts;
    const std::filesystem::path folder = std::filesystem::path(GRAFWIRE_ROOT) / "tests";
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder)) {
        if (file.path().extension() != ".cpp") continue;
        const std::string text = text_of(file.path().string());
        for (std::size_t at = text.find("R\"("); at != text.npos; at = text.find("R\"(", at)) {
            const std::size_t end = text.find(")\"", at + 3);
            const std::string chart = text.substr(at + 3, end - at - 3);
            at += 3;
            if (read_grafcet(chart)) charts.push_back(chart);
        }
    }
    return charts;
}

}  // namespace

TEST_CASE("the layout of every chart in files and tests is the same chart") {
    std::size_t files = 0;
    for (const char* folder : {"examples", "tests/golden"}) {
        const std::filesystem::path path = std::filesystem::path(GRAFWIRE_ROOT) / folder;
        for (const auto& file : std::filesystem::recursive_directory_iterator(path)) {
            if (file.path().extension() != ".grafcet") continue;
            CHECK_MESSAGE(fault_of_format(text_of(file.path().string())) == "", file.path());
            ++files;
        }
    }
    CHECK(files >= 14);
    const std::vector<std::string> charts = charts_in_tests();
    for (const std::string& chart : charts) CHECK_MESSAGE(fault_of_format(chart) == "", chart);
    CHECK(charts.size() > 50);
}

TEST_CASE("the layout of a random GRAFCET is the same chart") {
    check_property(fault_of_case, Features(), 900'000, 600, 1);
    Features large;
    large.steps = 60;
    large.graphs = 8;
    large.expression_depth = 5;
    check_property(fault_of_case, large, 910'000, 30, 1);
}

TEST_CASE("comments and line ends between any two tokens") {
    const std::size_t count = case_count(600);
    std::size_t charts = 0;
    for (std::uint64_t seed = 920'000; seed < 920'000 + count; ++seed) {
        RandomSource random(seed);
        const std::string text = strewn(random, random_case(seed, Features(), 1).chart);
        if (!read_grafcet(text)) continue;
        ++charts;
        const std::string fault = fault_of_format(text);
        if (!fault.empty()) FAIL("seed " << seed << ": " << fault << "\n" << text);
    }
    CHECK(charts > count / 4);
}

}  // namespace grafwire::testing
