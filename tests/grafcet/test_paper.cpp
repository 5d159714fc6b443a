// Charts as they are written on paper, in French or in other notations: what is read, and what is
// answered with the way it is written here.

#include <fmt/core.h>

#include "grafcet/messages.h"
#include "parsing.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

/// The condition of the one transition 0 -> 1, as it is written back.
std::string read_condition(const std::string& condition) {
    const Grafcet grafcet = parsed(
        "input a, b, c\ncounter n : 0..9\ntime T3 = 300ms\ngraph G {\n  initial 0\n  step 1\n  0 "
        "-> 1 : " +
        condition + "\n  1 -> 0 : a . b . c . [n = 1] . T3/X1\n}\n");
    return write_expression(grafcet, grafcet.expressions, grafcet.transitions.items()[0].condition);
}

/// The messages for that condition of 0 -> 1, which stands at 7:12.
std::string messages_for(const std::string& condition) {
    return messages_of(
        "input a, b, c, fc\noutput V\nvar m\ncounter n : 0..9\ngraph G {\n  initial 0 : V\n  0 -> "
        "0 : " +
        condition +
        "\n  0 -> 0 : a . b . c . fc . m . [n = 1]\n step 1 : set m, n := 2\n 0 -> 1 : a\n 1 -> 0 "
        ": b\n}\n");
}

/// The messages for those actions of step 1, which stand at 6:12.
std::string messages_for_action(const std::string& actions) {
    return messages_of(
        "input a, fc\noutput V\ncounter C : 0..9\ngraph GP {\n  initial 0\n  step 1 : " + actions +
        "\n  0 -> 1 : a\n  1 -> 0 : fc . [C = 1]\n  step 2 : V\n  1 -> 2 : a\n  2 -> 0 : a\n}\n");
}

bool has(const std::string& messages, const std::string& part) {
    return messages.find(part) != messages.npos;
}

}  // namespace

TEST_CASE("operators as on paper") {
    CHECK(read_condition("a·b") == "a.b");
    CHECK(read_condition("a ⋅ b") == "a.b");
    CHECK(read_condition("a ∧ b ∨ ¬c") == "a.b + /c");
    CHECK(read_condition("a et b") == "a.b");
    CHECK(read_condition("a ET b OU NON c") == "a.b + /c");
    CHECK(read_condition("a et b ou non c") == "a.b + /c");
    CHECK(read_condition("a AND b OR NOT c") == "a.b + /c");
    CHECK(read_condition("[n ≥ 5] + [n ≠ 7] + [n ≤ 2]") == "[n >= 5] + [n <> 7] + [n <= 2]");
    CHECK(read_condition("a\u0305") == "/a");
    CHECK(read_condition("a\u0305.b") == "/a.b");
    CHECK(read_condition("(a + b)\u0305 . c") == "/(a + b).c");
    CHECK(read_condition("T3/X0 . 1s/a/T3") == "300ms/X0 . 1s/a/300ms");
}

TEST_CASE("an overline over a part of a name") {
    const std::string text = "input ab\ngraph G {\n  initial 0\n  0 -> 0 : a\u0305b\n}\n";
    CHECK(has(messages_of(text), "4:12 error: the overline covers only a part of this name"));
    CHECK(has(messages_of("input a\u0305\ngraph G { initial 0 0 -> 0 : a }\n"),
              "1:7 error: expected an input; an overline negates a condition"));
}

TEST_CASE("words that are operators give way to names") {
    const Grafcet grafcet = parsed("input et, a\ngraph G {\n  initial 0\n  0 -> 0 : et . a\n}\n");
    CHECK(grafcet.inputs.items()[0].name == "et");
    CHECK(messages_of("input et, a\ngraph G {\n  initial 0\n  0 -> 0 : et . a\n}\n") ==
          "1:7 warning: 'et' is also read as the operator 'and'; here the declared name counts\n");
    // A step of that name begins a transition on a line of its own.
    CHECK(parsed("input a\ngraph G {\n  initial et\n  step non\n  et -> non : a\n  non -> et : a\n"
                 "  et -> et : non a et a\n}\n")
              .transitions.size() == 3);
}

TEST_CASE("accents composed and decomposed are one name") {
    const std::string composed = "pr\u00e9sence";
    const std::string decomposed = "pre\u0301sence";
    const Grafcet grafcet = parsed("input " + composed +
                                   "\ngraph G {\n  initial 0\n  0 -> 0 : " + decomposed + "\n}\n");
    CHECK(grafcet.inputs.items()[0].name == composed);
    CHECK(parsed("input \"" + decomposed + "\"\ngraph G { initial 0 0 -> 0 : " + composed + " }\n")
              .inputs.items()[0]
              .name == composed);
}

TEST_CASE("French keywords, with accents or without, in capitals too") {
    const std::string french = R"(
entrée a, dcy
sortie V, L
variable m
compteur n : 0..9
durée T3 = 300ms
définir prêt = a . dcy
suppose /(a . dcy) + a
graphe G1 {
  étape initiale 0
  étape 1 : V si a, set m sur désactivation
  initiale 2 englobe G2{20}
  macro M3 = cycle
  0 -> 1 : prêt . T3/X0 faire n := n + 1
  1, 2 -> M3, 2 : [n = 3] + m
  M3 -> 0 : a
}
expansion cycle {
  début E1
  fin S1 : L
  E1 → S1 : a
}
graphe G2 { initiale 20 }
)";
    const std::string english = R"(
input a, dcy
output V, L
var m
counter n : 0..9
time T3 = 300ms
define prêt = a . dcy
assume /(a . dcy) + a
graph G1 {
  initial step 0
  step 1 : V if a, set m on deactivation
  initial 2 encloses G2{20}
  macro M3 = cycle
  0 -> 1 : prêt . T3/X0 do n := n + 1
  1, 2 -> M3, 2 : [n = 3] + m
  M3 -> 0 : a
}
expansion cycle {
  entry E1
  exit S1 : L
  E1 -> S1 : a
}
graph G2 { initial 20 }
)";
    CHECK(write_grafcet(parsed(french)) == write_grafcet(parsed(english)));
    CHECK(
        write_grafcet(
            parsed("ENTREE a\nSORTIE V\nGRAPHE G {\n ETAPE INITIALE 0 : V SI a\n 0 -> 0 : a\n}")) ==
        write_grafcet(parsed("INPUT a\nOutput V\nGraph G {\n initial 0 : V if a\n 0 -> 0 : a\n}")));
    // Steps of those names are steps.
    CHECK(parsed(
              "input a\ngraph G {\n  initial si\n  step fin\n  si -> fin : a\n  fin -> si : a\n}\n")
              .steps.size() == 2);
}

TEST_CASE("a wrong first word does not hide the rest") {
    const std::string messages =
        messages_of("input a\ngraph G {\n  initial 0\n  etapes 1\n  0 -> 1 : b\n  0 -> 0 : c\n}\n");
    CHECK(has(messages, "4:10 error: expected ',' or '->', got '1'"));
    CHECK(has(messages, "unknown variable 'b'"));
    CHECK(has(messages, "unknown variable 'c'"));
}

TEST_CASE("a parenthesis behind a condition") {
    for (const char* condition :
         {"a (b)", "a (1)", "X0 (GP)", "a (une remarque)", "a . b (fin de course)"}) {
        CAPTURE(condition);
        const std::string messages = messages_for(condition);
        CHECK(has(messages, "error: a parenthesis cannot stand here: AND is written '.'"));
        CHECK(messages.find("error", messages.find("error") + 1) == messages.npos);
    }
    // At the head of a line, or behind a brace, it is a label.
    CHECK(parsed("input a\ngraph G { (t) 0 -> 0 : a initial 0 }").transitions.items()[0].name ==
          "t");
    CHECK(parsed("input a\ngraph G {\n initial 0 : G2{}\n (t) 0 -> 0 : a\n}\ngraph G2 { initial 5 "
                 ": G3{} (u) 5 -> 5 : a }\ngraph G3 { initial 6 }")
              .transitions.items()[1]
              .name == "u");
}

TEST_CASE("each remark in parentheses is told") {
    const std::string messages = messages_of(
        "input a, b\ngraph G {\n  initial 0\n  step 1\n  0 -> 1 : a (début)\n  1 -> 0 : b "
        "(fin)\n}\n");
    CHECK(has(messages, "5:14 error: a parenthesis cannot stand here"));
    CHECK(has(messages, "6:14 error: a parenthesis cannot stand here"));
}

TEST_CASE("durations of other notations") {
    CHECK(has(messages_for("0,5s/X1"),
              "7:12 error: the decimal mark of a duration is a point: 0.5s"));
    CHECK(has(messages_for("1,5s/X1"), "a point: 1.5s"));
    CHECK(has(messages_for("3 s/X1"), "no space stands between a number and its unit: 3s"));
    CHECK(has(messages_for("t1/X1/3s"), "the variable behind it: 3s/X1"));
    CHECK(has(messages_for("T/X1/5 d/"), "the variable behind it: 5s/X1"));
    CHECK(has(messages_for("X1/5s"), "the variable behind it: 5s/X1"));
    CHECK(has(messages_for("X1.t >= 5s"), "how long step 3 has been active is 5s/X3"));
}

TEST_CASE("conditions of other notations") {
    CHECK(has(messages_for("a . 1 . 2"),
              "7:20 error: the number '2' is no condition: the variable of step 2 is X2"));
    CHECK(has(messages_for("a'"), "NOT is written before what it negates: /a"));
    CHECK(has(messages_for("^a"), "a rising edge is written ↑a"));
    CHECK(has(messages_for("FM(a)"), "an edge is written ↑a or rise(a)"));
    CHECK(has(messages_for("fc = 1"), "a variable is written alone where it is to be 1"));
    CHECK(has(messages_for("a // départ"), "a remark begins with '#'"));
    CHECK(has(messages_of("// départ\ninput a\ngraph G { initial 0 0 -> 0 : a }"),
              "1:1 error: a remark begins with '#'"));
    CHECK(has(messages_of("input a\ngraph G {\n // départ\n initial 0\n 0 -> 0 : a\n}"),
              "3:2 error: a remark begins with '#'"));
}

TEST_CASE("a condition that is missing is missed where it should stand") {
    const std::string messages = messages_of(
        "input a\ngraph G {\n  initial 0\n  step 1\n  0 -> 1\n  1 -> 0 :\n  0 -> 1 : a\n}\n");
    CHECK(has(messages, "5:9 error: expected ',' or ':' and the transition condition"));
    CHECK(has(messages, "6:11 error: expected a condition"));
}

TEST_CASE("actions of other notations") {
    CHECK(has(messages_for_action("[C := C + 1]"),
              "6:12 error: actions stand without brackets: C := C + 1"));
    CHECK(has(messages_for_action("V = 1"), "a continuous action is the name alone, V"));
    CHECK(has(messages_for_action("S V"), "a stored action is written set V"));
    CHECK(has(messages_for_action("R V"), "a stored action is written reset V"));
    CHECK(has(messages_for_action("F/GP:{1}"),
              "a forcing order names the graph and its situation: GP{10}"));
    CHECK(has(messages_for_action("F/GP:(*)"), "GP{*} to freeze"));
    CHECK(messages_for_action("V si fc") == "");
}

TEST_CASE("a name that begins with a digit is told once") {
    CHECK(messages_of("input 1S1\ngraph G {\n  initial 0\n  0 -> 0 : 1S1\n  0 -> 0 : 1S1\n}\n") ==
          "1:7 error: '1S1' begins with a digit and is neither a number nor a duration; a name "
          "that begins with a digit stands between quotation marks: \"1S1\"\n");
}

TEST_CASE("a step called X1 has the variable XX1") {
    CHECK(messages_of("input a\ngraph G {\n  initial X1\n  X1 -> X1 : a\n}\n") ==
          "3:11 warning: the variable of step 'X1' is XX1; if XX1 is not what you mean, name the "
          "step without the X\n");
}

TEST_CASE("two graphs that both number their steps from 0 are one mistake") {
    const std::string messages = messages_of(
        "input a\ngraph G1 {\n  initial 0\n  step 1\n  0 -> 1 : a\n  1 -> 0 : a\n}\n"
        "graph G2 {\n  initial 0\n  step 1\n  0 -> 1 : a\n  1 -> 0 : a\n}\n");
    CHECK(messages ==
          "9:11 error: graph 'G2' and graph 'G1' both have steps 0, 1; step names are unique in "
          "the whole file, so number those of one graph otherwise, as in 10, 11, …\n"
          "  3:11 note: it is first declared here\n");
}
