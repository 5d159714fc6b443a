#include <doctest/doctest.h>

#include <string>
#include <utility>

#include "grafcet/messages.h"
#include "text/diagnostics.h"

using namespace grafwire;

namespace {

/// A message whose language does not matter here.
Localized sentence(std::string text) {
    return Localized::same_in_both(std::move(text));
}

}  // namespace

TEST_CASE("a message is shown with its line and a caret under the character") {
    const SourceFile source{"chart.grafcet", "graph G {\n  é -> ↑b : x\r\n}"};
    Diagnostics diagnostics;
    diagnostics.error(code::unknown_name, {2, 9}, sentence("unknown step 'b'"))
        .notes.push_back({{1, 7}, sentence("the graph is here")});
    CHECK(diagnostics.has_errors());
    CHECK(format_diagnostics(diagnostics, source) == R"(chart.grafcet:2:9: error: unknown step 'b'
  é -> ↑b : x
        ^
chart.grafcet:1:7: note: the graph is here
graph G {
      ^
)");
}

TEST_CASE("tabs stay tabs before the caret, and control characters are made visible") {
    const SourceFile source{"-", "\ta\x1b\tb"};
    Diagnostics diagnostics;
    diagnostics.warning(code::unused_name, {1, 5}, sentence("a \x1b"));
    CHECK_FALSE(diagnostics.has_errors());
    CHECK(format_diagnostics(diagnostics, source) ==
          "<stdin>:1:5: warning: a \xef\xbf\xbd\n\ta\xef\xbf\xbd\tb\n\t  \t^\n");
}

TEST_CASE("places at the end of a line and beyond the file are shown as far as they exist") {
    const SourceFile source{"f",
                            "\xef\xbb\xbf"
                            "ab\n"};
    Diagnostics diagnostics;
    diagnostics.error(code::unexpected_token, {1, 3}, sentence("end of line"));
    diagnostics.error(code::unexpected_token, {2, 1}, sentence("end of file"));
    diagnostics.error(code::unexpected_token, {9, 1}, sentence("nowhere"));
    diagnostics.error(code::unreadable_file, {}, sentence("no place"));
    CHECK(format_diagnostics(diagnostics, source) ==
          "f:1:3: error: end of line\nab\n  ^\nf:2:1: error: end of file\n\n^\nf:9:1: error: "
          "nowhere\nf: error: no place\n");
}

TEST_CASE("of a long line a part around the place is shown") {
    const SourceFile source{"f", std::string(200, 'a') + "é" + std::string(200, 'b')};
    Diagnostics diagnostics;
    diagnostics.error(code::unexpected_token, {1, 201}, sentence("m"));
    CHECK(format_diagnostics(diagnostics, source) ==
          "f:1:201: error: m\n…" + std::string(100, 'a') + "é" + std::string(59, 'b') + "…\n" +
              std::string(101, ' ') + "^\n");
}

TEST_CASE("errors and warnings beyond the limit are counted") {
    const SourceFile source{"f", ""};
    Diagnostics diagnostics;
    for (const char* text : {"one", "two", "three", "four"})
        diagnostics.error(code::unexpected_token, {}, sentence(text));
    diagnostics.warning(code::unused_name, {}, sentence("five"));
    CHECK(diagnostics.error_count() == 4);
    CHECK(format_diagnostics(diagnostics, source, Language::english, 2) ==
          "f: error: one\nf: error: two\nf: warning: five\nf: 2 more errors not shown\n");
    CHECK(format_diagnostics(diagnostics, source, Language::english, 3)
              .find("f: 1 more error not shown\n") != std::string::npos);
    CHECK(format_diagnostics(diagnostics, source, Language::english, 4).find("not shown") ==
          std::string::npos);
    CHECK(format_diagnostics(diagnostics, source, Language::english, 0).find("four") !=
          std::string::npos);
    diagnostics.warning(code::unused_name, {}, sentence("six"));
    diagnostics.warning(code::unused_name, {}, sentence("seven"));
    CHECK(format_diagnostics(diagnostics, source, Language::english, 1) ==
          "f: error: one\nf: warning: five\nf: 3 more errors not shown\n"
          "f: 2 more warnings not shown\n");
}

TEST_CASE("a message without end is cut") {
    const SourceFile source{"f", ""};
    Diagnostics diagnostics;
    std::string long_message;
    for (int i = 0; i < 1000; ++i) long_message += "é";
    diagnostics.error(code::unexpected_token, {}, sentence(long_message));
    diagnostics.error(code::unexpected_token, {}, sentence(long_message + "é"));
    CHECK(format_diagnostics(diagnostics, source) ==
          "f: error: " + long_message + "\nf: error: " + long_message + "…\n");
}

TEST_CASE("sorting goes by place and keeps the order of what stands in one place") {
    Diagnostics diagnostics;
    diagnostics.error(code::unexpected_token, {2, 1}, sentence("d"));
    diagnostics.warning(code::unused_name, {1, 5}, sentence("b"));
    diagnostics.error(code::unexpected_token, {1, 5}, sentence("c"));
    diagnostics.error(code::unreadable_file, {}, sentence("a"));
    diagnostics.sort_by_place();
    std::string order;
    for (const Diagnostic& item : diagnostics.items()) order += item.message.english;
    CHECK(order == "abcd");
}
