// Conditions and actions as on paper.

#include <doctest/doctest.h>

#include "draw/paper_notation.h"
#include "random/read_text.h"

namespace grafwire::testing {

namespace {

/// A text with the runs that have a line over or under them in brackets: `a·[b]`, `<1>`.
std::string shown(const Text& text) {
    std::string out;
    for (const TextRun& run : text) {
        switch (run.rule) {
            case TextRun::Rule::plain:
                out += run.text;
                break;
            case TextRun::Rule::over:
                out += '[' + run.text + ']';
                break;
            case TextRun::Rule::under:
                out += '<' + run.text + '>';
                break;
        }
    }
    return out;
}

/// The chart of two steps whose first transition has this condition.
Grafcet with_condition(const std::string& condition) {
    auto read = read_grafcet(
        "input a, b, \"H+\"\ncounter C : 0..9\noutput o\ngraph G {\n initial 1\n step 2 : o\n"
        "1 -> 2 : " +
        condition + " do C := C + 1\n2 -> 1 : 1\n}\n");
    REQUIRE(read);
    return std::move(*read);
}

std::string on_paper(const std::string& condition, NotSign sign = NotSign::overline) {
    const Grafcet grafcet = with_condition(condition);
    return shown(condition_on_paper(grafcet, grafcet.transitions.items()[0].condition, sign));
}

}  // namespace

TEST_CASE("notation: conditions as a teacher writes them") {
    CHECK(on_paper("1") == "<1>");
    CHECK(on_paper("0") == "0");
    CHECK(on_paper("a . /b + \"H+\"") == "a·[b] + H+");
    CHECK(on_paper("a . /b", NotSign::slash) == "a·/b");
    CHECK(on_paper("↑a . ↓b") == "↑a·↓b");
    CHECK(on_paper("↑(a . b)") == "↑(a·b)");
    CHECK(on_paper("(a + b) . a") == "(a + b)·a");
    CHECK(on_paper("a xor b") == "a ⊕ b");
    CHECK(on_paper("[C >= 3] . [C <> 4]") == "[C ≥ 3]·[C ≠ 4]");
    CHECK(on_paper("[C - 1 <= 3]") == "[C − 1 ≤ 3]");
    CHECK(on_paper("3s/X1") == "3s/X1");
    CHECK(on_paper("3s/X1/500ms") == "3s/X1/500ms");
    CHECK(on_paper("3s/(a + b)") == "3s/(a + b)");
}

TEST_CASE("notation: a line stands over a whole product, and never over another line") {
    CHECK(on_paper("/(a . b)") == "[a·b]");
    CHECK(on_paper("/(3s/X1)") == "[3s/X1]");
    CHECK(on_paper("/(a + /b)") == "/(a + [b])");
    CHECK(on_paper("//a") == "/[a]");
    CHECK(on_paper("/(3s//a)") == "/3s/[a]");
}

TEST_CASE("notation: long conditions are broken behind operators, never within an overline") {
    const Grafcet grafcet = with_condition(
        "/(a . b . a . b . a . b . a . b . a . b) + a . \"H+\" + b . /a . a + \"H+\"");
    const ExprId condition = grafcet.transitions.items()[0].condition;
    const std::vector<Text> lines = condition_on_paper(grafcet, condition, NotSign::overline, 3);
    std::string whole;
    for (const Text& line : lines) {
        whole += shown(line);
        CHECK((&line == &lines.front() || width_of(line) <= 3));
    }
    CHECK(lines.size() > 2);
    CHECK(whole == shown(condition_on_paper(grafcet, condition, NotSign::overline)));
}

TEST_CASE("notation: actions") {
    const Grafcet grafcet = with_condition("a");
    CHECK(shown(write_on_paper(grafcet, grafcet.clearing_actions[0].write, NotSign::overline)) ==
          "C := C + 1");
    const auto orders = read_grafcet(
        "var v\ninput a\ngraph G {\n initial 1 : H{}, set v on ↑a\n step 2 : H{*}, v := /a\n"
        "step 3 : H{INIT}, reset v\n step 4 : H{10, 11}\n"
        "1 -> 2 : a\n2 -> 3 : a\n3 -> 4 : a\n4 -> 1 : v\n}\n"
        "graph H {\n initial 10\n step 11\n10 -> 11 : a\n11 -> 10 : a\n}\n");
    REQUIRE(orders);
    std::string all;
    for (const Order& order : orders->orders) all += order_on_paper(*orders, order) + " ";
    CHECK(all == "H{} H{*} H{INIT} H{10,11} ");
    std::string writes;
    for (const Action& action : orders->actions) {
        if (action.kind != ActionKind::stored) continue;
        writes += shown(write_on_paper(*orders, action.write, NotSign::overline)) + "; ";
    }
    CHECK(writes == "v := 1; v := [a]; v := 0; ");
}

}  // namespace grafwire::testing
