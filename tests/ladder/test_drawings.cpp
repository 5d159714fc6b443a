// Drawings of ladder diagrams.

#include <doctest/doctest.h>

#include "ladder/draw/layout.h"
#include "ladder/draw/write_drawings.h"
#include "ladder/ladder_from.h"
#include "random/read_text.h"
#include "text/utf8.h"

namespace grafwire::testing {

namespace {

ladder::Ladder ladder_of(const std::string& chart, bool modes) {
    const auto grafcet = read_grafcet(chart);
    REQUIRE(grafcet);
    Diagnostics diagnostics;
    return ladder::ladder_from(*grafcet, program_from(*grafcet, {modes}), diagnostics);
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
