// A French reader meets no English sentence: every command on every example, and on examples with a
// line left out or written twice, which are wrong in as many ways. What the author of a chart wrote
// is his own language.

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "command/english_words.h"
#include "support/run_program.h"
#include "support/slow_build.h"

namespace grafwire::testing {

namespace {

using Request = std::vector<std::string>;

/// Of this many requests and wrong charts one is tried.
constexpr std::size_t sparser = is_slow_build ? 20 : 1;

/// The text without what stands in quotes, « » or "…".
std::string without_quoted(std::string text) {
    for (const auto& [begin, end] : {std::pair("«", "»"), std::pair("\"", "\"")}) {
        for (std::size_t at = text.find(begin); at != text.npos; at = text.find(begin, at)) {
            const std::size_t to = text.find(end, at + 1);
            text.erase(at, to == text.npos ? text.npos : to + std::string(end).size() - at);
        }
    }
    return text;
}

/// The messages alone, without the lines of the file that they show.
std::string messages_in(const std::string& shown) {
    std::istringstream lines(shown);
    std::string messages;
    for (std::string line; std::getline(lines, line);) {
        for (const char* kind : {": erreur\u00a0: ", ": avertissement\u00a0: ", ": note\u00a0: "}) {
            const std::size_t at = line.find(kind);
            if (at != line.npos) messages += line.substr(at) + "\n";
        }
    }
    return messages;
}

/// The English words of a text that the chart does not have.
std::string english_beside(const std::string& text, const std::string& chart) {
    std::string own = english_in(chart);
    for (const char c : {'{', '}', ',', ':'}) std::replace(own.begin(), own.end(), c, ' ');
    std::string left;
    std::istringstream words(english_in(without_quoted(text)));
    for (std::string word; words >> word;) {
        word = word.substr(0, word.find(','));
        const bool is_own = (" " + own + " ").find(" " + word + " ") != std::string::npos;
        if (!is_own && word != "nor") left += word + " ";  // the style
    }
    return left;
}

/// All that `request` shows in French.
Ran in_french(Request request) {
    request.insert(request.begin(), {"--lang", "fr"});
    return grafwire_with(request);
}

/// Requests about a chart whose results are for people.
std::vector<Request> reports_on(const std::string& name) {
    const std::string chart = example(name + ".grafcet");
    std::vector<Request> requests{{"info", chart}};
    for (const std::string form : {"text", "markdown"}) {
        for (const std::string modes : {"on", "off"}) {
            requests.push_back({"equations", chart, "--to", form, "--modes", modes});
        }
        requests.push_back({"equations", chart, "--to", form, "--karnaugh"});
    }
    for (const std::string& style : choices_of("netlist", "--style")) {
        requests.push_back({"check", chart, "--style", style, "--max-cases", "500"});
    }
    requests.push_back(
        {"check", chart, "--style", "clocked", "--scan", "10ms", "--max-cases", "500"});
    requests.push_back({"check", chart, "--style", "nand", "--max-cases", "1"});
    return requests;
}

/// A text with one line left out (the first: 0).
std::string without_line(const std::string& text, std::size_t number) {
    std::size_t begin = 0;
    for (; number > 0; --number) begin = text.find('\n', begin) + 1;
    return text.substr(0, begin) + text.substr(text.find('\n', begin) + 1);
}

/// A text with one line written twice.
std::string with_line_twice(const std::string& text, std::size_t number) {
    std::size_t begin = 0;
    for (; number > 0; --number) begin = text.find('\n', begin) + 1;
    const std::size_t end = text.find('\n', begin) + 1;
    return text.substr(0, end) + text.substr(begin);
}

}  // namespace

TEST_CASE("reports on every example are French throughout") {
    std::size_t reports = 0;
    for (const std::string& name : example_names()) {
        const std::string chart = example_text(name + ".grafcet");
        for (const Request& request : reports_on(name)) {
            if (reports++ % sparser != 0) continue;
            std::string told;
            for (const std::string& word : request) told += word + " ";
            CAPTURE(told);
            const Ran ran = in_french(request);
            CHECK(english_beside(ran.out, chart) == "");
            CHECK(english_beside(messages_in(ran.err), chart) == "");
        }
    }
    CHECK(reports >= 150);
}

TEST_CASE("what is said of wrong charts is French throughout") {
    const ScratchFolder folder;
    std::size_t messages = 0;
    for (const std::string& name : example_names()) {
        const std::string chart = example_text(name + ".grafcet");
        const auto lines = static_cast<std::size_t>(std::count(chart.begin(), chart.end(), '\n'));
        for (std::size_t i = 0; i < lines; i += sparser) {
            for (const std::string& wrong : {without_line(chart, i), with_line_twice(chart, i)}) {
                CAPTURE(wrong);
                const Ran ran = in_french({"info", folder.file("wrong.grafcet", wrong)});
                const std::string said = messages_in(ran.err);
                CHECK(said.empty() == ran.err.empty());
                CHECK(english_beside(said, chart) == "");
                if (!said.empty()) ++messages;
            }
        }
    }
    CHECK(messages >= 100 / sparser);
}

TEST_CASE("an explanation of a wrong listing is French throughout") {
    const std::string folder = "s7-200/";
    for (const std::string name : {"manipulator", "manipulator-modes", "positioning-axis"}) {
        const Ran ran = in_french({"check", example(name + ".grafcet"), "--against",
                                   example(folder + name + ".printed.awl"), "--io",
                                   example(folder + name + ".io")});
        CHECK(ran.status == 1);
        CHECK(english_beside(ran.out, "") == "");
        CHECK(english_beside(messages_in(ran.err), "") == "");
    }
}

}  // namespace grafwire::testing
