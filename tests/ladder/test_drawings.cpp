// Drawings of ladder diagrams.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <regex>

#include "ladder/draw/cut_drawing.h"
#include "ladder/draw/layout.h"
#include "ladder/draw/write_drawings.h"
#include "ladder/ladder_from.h"
#include "random/random_cases.h"
#include "random/random_grafcet.h"
#include "random/read_text.h"
#include "support/chart_files.h"
#include "text/utf8.h"

namespace grafwire::testing {

namespace {

ladder::Ladder ladder_of(const std::string& chart, bool modes) {
    const auto grafcet = read_grafcet(chart);
    REQUIRE(grafcet);
    Diagnostics diagnostics;
    return ladder::ladder_from(*grafcet, program_from(*grafcet, {modes}), diagnostics);
}

/// A page of a picture, as a text.
std::vector<std::string> pages_of(const std::string& svg) {
    const std::string begin = "<g class=\"page\"";
    std::vector<std::string> pages;
    for (std::size_t at = svg.find(begin); at != std::string::npos;) {
        const std::size_t next = svg.find(begin, at + 1);
        pages.push_back(svg.substr(at, next - at));
        at = next;
    }
    return pages;
}

/// What a pattern with one group finds, in order.
std::vector<std::string> found(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    std::vector<std::string> matches;
    for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end;
         ++match) {
        matches.push_back((*match)[1]);
    }
    return matches;
}

/// The numbers of the rungs that begin or go on on a page.
std::vector<std::string> rung_numbers(const std::string& page) {
    return found(page, "class=\"number\" x=\"52\"[^>]*>(\\d+)<");
}

/// A chart whose transition has a condition of so many terms.
std::string chart_with_terms(int count) {
    std::string inputs;
    std::string condition;
    for (int i = 0; i < count; ++i) {
        inputs += fmt::format("{}a{}", i == 0 ? "" : ", ", i);
        condition += fmt::format("{}a{}", i == 0 ? "" : " + ", i);
    }
    return fmt::format("input {}\ngraph G {{ initial 0 step 1  0 -> 1 : {}  1 -> 0 : a0 }}", inputs,
                       condition);
}

/// All that is drawn stays within the margins of a page.
void check_within_page(const std::string& page) {
    for (const std::string& y : found(page, " y[12]?=\"([-0-9.]+)\"")) {
        CHECK(std::stod(y) >= 0);
        CHECK(std::stod(y) <= 1188 - 35);
    }
    for (const std::string& x : found(page, " x[12]?=\"([-0-9.]+)\"")) {
        CHECK(std::stod(x) >= 0);
        CHECK(std::stod(x) <= 840);
    }
}

}  // namespace

TEST_CASE("a small chart without modes, drawn in characters") {
    const ladder::Ladder ladder = ladder_of(R"(
        grafcet door "Porte"
        input open, shut
        output motor
        graph G {
          initial 0
          step 1 : motor
          0 -> 1 : open + shut
          1 -> 0 : 2s/X1 . /open
        })",
                                            false);
    CHECK(write_text(ladder, 60) ==
          R"(door: Porte

Executed from top to bottom, once a scan. The transitions
(T...) are worked out first; then every step (X...) is reset
by those out of it and set by those into it.

Inputs      open, shut
Outputs     motor
Bits        X0, X1, started, T0, 2s/X1, T1
Blocks      timer0

── First scan: the initial situation ───────────────────────

│  1  initial step 0                                       │
│  started                                           X0    │
├────┤/├─────────────────────────────────────────────(S)───┤
│                                                          │
│  2  the first scan is over                               │
│                                                  started │
├────────────────────────────────────────────────────(S)───┤
│                                                          │

── Transitions that are cleared ────────────────────────────

│  3  (0) 0 -> 1 : open + shut                             │
│   X0     open                                      T0    │
├───┤ ├──┬──┤ ├──┬───────────────────────────────────( )───┤
│        │ shut  │                                         │
│        └──┤ ├──┘                                         │
│                                                          │
│  4  (1) 1 -> 0 : 2s/X1./open                             │
│   X1    2s/X1  open                                T1    │
├───┤ ├────┤ ├────┤/├────────────────────────────────( )───┤
│                                                          │

── Steps: CDX resets, CAX sets ─────────────────────────────

│  5  step 0 is deactivated                                │
│   T0                                               X0    │
├───┤ ├──────────────────────────────────────────────(R)───┤
│                                                          │
│  6  step 0 is activated                                  │
│   T1                                               X0    │
├───┤ ├──────────────────────────────────────────────(S)───┤
│                                                          │
│  7  step 1 is deactivated                                │
│   T1                                               X1    │
├───┤ ├──────────────────────────────────────────────(R)───┤
│                                                          │
│  8  step 1 is activated                                  │
│   T0                                               X1    │
├───┤ ├──────────────────────────────────────────────(S)───┤
│                                                          │

── Time conditions ─────────────────────────────────────────

│  9  2s/X1                                                │
│           timer0                                         │
│   X1    ┌─TON─────┐                               2s/X1  │
├───┤ ├───┤ IN    Q ├────────────────────────────────( )───┤
│         │ PT T#2s │                                      │
│         └─────────┘                                      │
│                                                          │

── Outputs ─────────────────────────────────────────────────

│ 10  motor                                                │
│   X1                                              motor  │
├───┤ ├──────────────────────────────────────────────( )───┤
│                                                          │
)");
}

TEST_CASE("a rung too long for its line goes on in the next") {
    ladder::Ladder ladder;
    std::vector<ladder::Power> contacts;
    for (const char* name : {"first", "second", "third", "fourth", "fifth"}) {
        ladder::Variable variable;
        variable.name = name;
        contacts.push_back(ladder::contact(ladder.add(variable)));
    }
    ladder::Rung rung;
    rung.power = ladder::series(contacts);
    rung.coils.push_back({ladder::CoilKind::negated, ladder::VariableId{0}});
    CHECK(write_rung(ladder, rung, 40) ==
          R"(│  first  second   third               │
├───┤ ├─────┤ ├─────┤ ├────▶1          │
│      fourth   fifth           first  │
│ 1▶─────┤ ├─────┤ ├─────────────(/)───┤
)");
}

TEST_CASE("every line of a drawing fits its width, and names stand above their contacts") {
    const ladder::Ladder ladder = ladder_of(R"(
        input a, b, c, d, e, f
        output "a rather long name of an output"
        counter n : -3..9
        graph G {
          initial 0
          step 1 : "a rather long name of an output" if a . b . (c + d . e) . /f . a + b . (a ⊕ c)
          0 -> 1 : (a + b) . (c + d) . (e + f) . [n + n > 3] do n := n + 1
          1 -> 0 : (a . b . c . d . e . f + /a . /b . /c . /d . /e . /f) . (a + f) . (b + e)
        })",
                                            true);
    for (const int width : {50, 80, 120}) {
        for (const ladder::Rung& rung : ladder.rungs) {
            const ladder::Drawing drawing = draw(ladder, rung, width);
            const std::string text = write_rung(ladder, rung, width);
            std::size_t lines = 0;
            for (std::size_t at = 0; at < text.size(); ++lines) {
                const std::size_t end = text.find('\n', at);
                CHECK(static_cast<int>(count_code_points(text.substr(at, end - at))) ==
                      drawing.width);
                at = end + 1;
            }
            CHECK(static_cast<int>(lines) == drawing.height);
            if (width == 120) CHECK(drawing.width == width);
        }
    }
}

TEST_CASE("a picture escapes what is not text in XML") {
    const std::string svg = write_svg(ladder_of(R"(
        input "a<b", "c&d"
        graph G { initial 0 0 -> 0 : "a<b" . "c&d" })",
                                                true));
    CHECK(svg.find(">a&lt;b</text>") != std::string::npos);
    CHECK(svg.find(">c&amp;d</text>") != std::string::npos);
    CHECK(svg.find("prefers-color-scheme: dark") != std::string::npos);
    CHECK(svg.find("<b") == std::string::npos);
}

TEST_CASE("a picture is pages of A4, and each rung of the examples on one of them") {
    for (const ChartFiles& example : example_charts()) {
        INFO(example.name);
        const ladder::Ladder ladder = ladder_of(example.chart, true);
        const std::string svg = write_svg(ladder);
        const std::vector<std::string> pages = pages_of(svg);
        REQUIRE_FALSE(pages.empty());
        CHECK(svg.find(fmt::format("width=\"210mm\" height=\"{}mm\" viewBox=\"0 0 840 {}\"",
                                   297 * pages.size(), 1188 * pages.size())) != std::string::npos);
        std::vector<std::string> numbers;
        for (std::size_t i = 0; i < pages.size(); ++i) {
            CHECK(pages[i].find(fmt::format("translate(0 {})", 1188 * i)) != std::string::npos);
            CHECK(pages[i].find(fmt::format(">{}/{}</text>", i + 1, pages.size())) !=
                  std::string::npos);
            CHECK(found(pages[i], "class=\"title\"[^>]*>([^<]*)<").front().find(ladder.name) == 0);
            check_within_page(pages[i]);
            for (const std::string& number : rung_numbers(pages[i])) numbers.push_back(number);
        }
        std::vector<std::string> expected;
        for (const ladder::Rung& rung : ladder.rungs) {
            expected.push_back(fmt::format("{}", rung.number));
        }
        CHECK(numbers == expected);
    }
}

TEST_CASE("a rung taller than a page goes on on the next") {
    const std::string chart = chart_with_terms(120);
    const std::vector<std::string> pages = pages_of(write_svg(ladder_of(chart, false)));
    REQUIRE(pages.size() == 5);
    std::string all;
    for (std::size_t i = 0; i < pages.size(); ++i) {
        check_within_page(pages[i]);
        all += pages[i];
    }
    for (const std::string& page : {pages[1], pages[2], pages[3]}) {
        CHECK(page.find(">continued</text>") != std::string::npos);
        CHECK(rung_numbers(page).front() == rung_numbers(pages[1]).front());
    }
    for (int i = 1; i < 120; ++i) {
        CHECK(found(all, fmt::format("class=\"name\"[^>]*>(a{})<", i)).size() == 1);
    }
}

TEST_CASE("a comment longer than a page, and a name wider than one") {
    const std::vector<std::string> pages =
        pages_of(write_svg(ladder_of(chart_with_terms(1200), false)));
    for (const std::string& page : pages) check_within_page(page);
    const std::string wide(200, 'w');
    const std::string svg = write_svg(
        ladder_of("input " + wide + "\ngraph G { initial 0  0 -> 0 : " + wide + " }", false));
    const std::vector<std::string> sizes = found(svg, "viewBox=\"0 0 (\\d+ \\d+)\"");
    REQUIRE(sizes.size() == 1);
    const double width = std::stod(sizes.front());
    const double height = std::stod(sizes.front().substr(sizes.front().find(' ')));
    CHECK(width > 1600);
    CHECK(height * 210 == width * 297 * static_cast<double>(pages_of(svg).size()));
}

TEST_CASE("parts of a drawing hold all of it, each name with its contact") {
    for (std::uint64_t seed = 970'000; seed < 970'000 + case_count(20); ++seed) {
        INFO("seed " << seed);
        RandomSource random(seed);
        const Features features;
        const ladder::Ladder ladder = ladder_of(random_grafcet(random, features), true);
        for (const ladder::Rung& rung : ladder.rungs) {
            const ladder::Drawing whole = draw(ladder, rung, 50);
            const int most = static_cast<int>(random.between(9, 20));
            std::size_t symbols = 0;
            std::size_t labels = 0;
            std::size_t boxes = 0;
            for (int from = 0; from < whole.height;) {
                const int to = row_to_cut(whole, from, most);
                REQUIRE(to > from);
                CHECK(to - from <= most);
                const ladder::Drawing part = rows_of(whole, from, to);
                for (const ladder::Drawing::Symbol& symbol : part.symbols) {
                    CHECK((symbol.y >= 1 && symbol.y < part.height));
                }
                for (const ladder::Drawing::Box& box : part.boxes) {
                    CHECK((box.y >= 0 && box.y + box.height <= part.height));
                }
                for (const ladder::Drawing::Wire& wire : part.wires) {
                    CHECK((wire.y1 >= 0 && wire.y2 <= 2 * part.height));
                }
                symbols += part.symbols.size();
                labels += part.labels.size();
                boxes += part.boxes.size();
                from = to;
            }
            CHECK(symbols == whole.symbols.size());
            CHECK(labels == whole.labels.size());
            CHECK(boxes == whole.boxes.size());
        }
    }
}

TEST_CASE("integers are as wide as their sums need") {
    const auto bits = [](const std::string& range, const std::string& sum) {
        return ladder_of("counter n : " + range + " graph G { initial 0 0 -> 0 : [" + sum + "] }",
                         false)
            .integer_bits;
    };
    CHECK(bits("0..9", "n > 3") == 16);
    CHECK(bits("-32768..32767", "n > 3") == 16);
    CHECK(bits("0..32767", "n + 1 > 3") == 32);
    CHECK(bits("0..9", "n > 40000") == 32);
    CHECK(bits("0..9", "n - 5000000000 > 3") == 64);
}

TEST_CASE("text is cut at blanks where there are some") {
    CHECK(ladder::wrapped_text("one two three", 7) == std::vector<std::string>{"one two", "three"});
    CHECK(ladder::wrapped_text("ééééé", 2) == std::vector<std::string>{"éé", "éé", "é"});
    CHECK(ladder::wrapped_text("", 5) == std::vector<std::string>{""});
}

}  // namespace grafwire::testing
