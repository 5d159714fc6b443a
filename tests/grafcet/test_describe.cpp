#include "grafcet/describe_grafcet.h"
#include "parsing.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

constexpr std::string_view chart = R"(
grafcet plant "Tri de caisses"
input a, b
output lamp
var v
counter n : 0..9
graph Top {
  initial 0 : Low{}, Mid{}
  step 1 encloses In{30} : Low{20, "a b"}, Mid{*}
  step 2 : Low{*}
  0 -> 1 : ↑a
  1 -> 2 : 5s/X1
  2 -> 0 : b . v
}
graph Mid { initial 10 : Low{INIT} macro M = cycle 10 -> M : a M -> 10 : a do n := n + 1 }
graph Low { initial 20 step "a b" : lamp 20 -> "a b" : b
(back) "a b" -> 20 : b }
graph In { step 30 : set v 30 -> : a }
expansion cycle { entry E exit S E -> S : b }
)";

}  // namespace

TEST_CASE("a description in English") {
    CHECK(describe_grafcet(parsed(chart), Language::english) == R"(GRAFCET plant "Tri de caisses"
  4 graphs, 9 steps, 3 initial steps, 9 transitions, 1 macro-step
  2 inputs, 1 output, 1 var, 1 counter
  1 edge, 1 time condition

Graphs
  Top: 3 steps, 3 transitions
    steps: 0 (initial), 1, 2
    transitions: 0, 1, 2
  Mid: 3 steps, 3 transitions
    steps: 10 (initial), E, S
    transitions: 3, 4, 8
  Low: 2 steps, 2 transitions
    steps: 20 (initial), "a b"
    transitions: 5, back
  In: 1 step, 1 transition
    steps: 30
    transitions: 7

Macro-steps
  M of Mid: expansion cycle, entry E, exit S, 2 steps

Enclosing steps
  1 of Top encloses In, activation links: 30

Hierarchy of forcing orders and enclosures
  Top
    Mid: forced by 0 {}; frozen by 1
      Low: forced by 10 {INIT}
    Low: forced by 0 {}, 1 {20, "a b"}; frozen by 2
    In: enclosed by 1
)");
}

TEST_CASE("a description in French") {
    CHECK(describe_grafcet(parsed(chart), Language::french) == R"(GRAFCET plant "Tri de caisses"
  4 grafcets partiels, 9 étapes, 3 étapes initiales, 9 transitions, 1 macro-étape
  2 entrées, 1 sortie, 1 variable interne, 1 compteur
  1 front, 1 temporisation

Grafcets partiels
  Top : 3 étapes, 3 transitions
    étapes : 0 (initiale), 1, 2
    transitions : 0, 1, 2
  Mid : 3 étapes, 3 transitions
    étapes : 10 (initiale), E, S
    transitions : 3, 4, 8
  Low : 2 étapes, 2 transitions
    étapes : 20 (initiale), "a b"
    transitions : 5, back
  In : 1 étape, 1 transition
    étapes : 30
    transitions : 7

Macro-étapes
  M de Mid : expansion cycle, entrée E, sortie S, 2 étapes

Étapes encapsulantes
  1 de Top encapsule In, liens d'activation : 30

Hiérarchie des ordres de forçage et des encapsulations
  Top
    Mid : forçage par 0 {} ; figeage par 1
      Low : forçage par 10 {INIT}
    Low : forçage par 0 {}, 1 {20, "a b"} ; figeage par 2
    In : encapsulation par 1
)");
}

TEST_CASE("long lists are cut, and a graph below two others is shown once") {
    std::string text =
        "input a\ngraph A { initial s : C{} s -> s : a }\n"
        "graph B { initial t : C{} t -> t : a }\n"
        "graph C { initial u : D{} u -> u : a }\ngraph D {\n";
    for (int i = 0; i < 30; ++i) text += "initial " + std::to_string(i) + "\n";
    text += "-> 0 : ↑a }\n";
    const std::string description = describe_grafcet(parsed(text), Language::english);
    CHECK(description.find("22 (initial), 23 (initial), … and 6 more\n") != std::string::npos);
    CHECK(description.find(R"(
  A
    C: forced by s {}
      D: forced by u {}
  B
    C: forced by t {} (shown above)
)") != std::string::npos);
}
