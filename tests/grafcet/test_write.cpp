#include "parsing.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

// One chart with every construct, in canonical layout.
constexpr std::string_view canonical = R"(grafcet "all of it" "Toute la langue # ü"

input a, b, "c d", "5", "step", été
output lamp, "H+", stored
var v, "w w"
counter n : -3..9
counter "k k" : 0..65535
assume /(a.b) + Init
assume "c d" ⊕ "step"

graph G {
  initial 0 : lamp, "H+" if "c d" + 3s/X1, set stored
  step 1 : reset stored on deactivation, v := a.X0 on ↑b + ↓"5", n := -n + 2 - "k k"
  step 01 encloses K{8, 9} : K{}, K{*}, K{INIT}, K{8, "INIT"}
  macro M2 = "exp 1"
  step "my step"
  macro M3 = exp2

  (first) 0 -> 1, 01 : [n + 1 >= -"k k"].a do "w w" := /"w w", set v
  1, 01 -> M2 : 1
  M2, "my step" -> M3 : 1.5s/(a + b)/2min
  ("#") M3 -> 0 : XM2./XG."Xmy step"
  -> "my step" : ↑a
  M3 -> : 0
}

expansion "exp 1" {
  entry E1 : lamp
  macro M4 = exp3
  exit S1 : set v

  E1 -> M4 : a
  M4 -> S1 : "Xmy step"
}

expansion exp3 {
  entry E3
  exit S3

  E3 -> S3 : été.AUdur.AUdoux
}

graph K {
  step 8
  step 9
  step INIT

  8, 9 -> INIT : a
  INIT -> 8, 9 : 1 . 5s/b
}

expansion exp2 {
  entry E2
  initial 22
  exit S2

  E2 -> 22 : a
  22 -> S2 : a
}
)";

// Whether two models are the same but for locations.
void check_same(const Grafcet& a, const Grafcet& b) {
    CHECK(a.name == b.name);
    CHECK(a.title == b.title);
    REQUIRE(a.steps.size() == b.steps.size());
    REQUIRE(a.transitions.size() == b.transitions.size());
    REQUIRE(a.blocks.size() == b.blocks.size());
    REQUIRE(a.actions.size() == b.actions.size());
    REQUIRE(a.orders.size() == b.orders.size());
    REQUIRE(a.macros.size() == b.macros.size());
    REQUIRE(a.expressions.size() == b.expressions.size());
    CHECK(a.links == b.links);
    CHECK(a.sums == b.sums);
    CHECK(a.expressions.edges() == b.expressions.edges());
    for (std::size_t i = 0; i < a.steps.size(); ++i) {
        const Step& s = a.steps.items()[i];
        const Step& t = b.steps.items()[i];
        CHECK(s.name == t.name);
        CHECK(s.block == t.block);
        CHECK(s.role == t.role);
        CHECK(s.initial == t.initial);
        CHECK(s.enclosure == t.enclosure);
        CHECK(s.actions.first == t.actions.first);
        CHECK(s.actions.count == t.actions.count);
    }
    for (std::size_t i = 0; i < a.transitions.size(); ++i) {
        const Transition& s = a.transitions.items()[i];
        const Transition& t = b.transitions.items()[i];
        CHECK(s.name == t.name);
        CHECK(s.labelled == t.labelled);
        CHECK(s.condition == t.condition);
        CHECK(s.following.first == t.following.first);
        CHECK(s.clearing.count == t.clearing.count);
    }
    for (std::size_t i = 0; i < a.blocks.size(); ++i) {
        CHECK(a.blocks.items()[i].nodes == b.blocks.items()[i].nodes);
        CHECK(a.blocks.items()[i].transitions == b.blocks.items()[i].transitions);
    }
    for (std::size_t i = 0; i < a.actions.size(); ++i) {
        CHECK(a.actions[i].kind == b.actions[i].kind);
        CHECK(a.actions[i].trigger == b.actions[i].trigger);
        CHECK(a.actions[i].expression == b.actions[i].expression);
        CHECK(a.actions[i].write.target == b.actions[i].write.target);
        CHECK(a.actions[i].write.value == b.actions[i].write.value);
        CHECK(a.actions[i].write.sum == b.actions[i].write.sum);
    }
    for (std::size_t i = 0; i < a.orders.size(); ++i) {
        CHECK(a.orders.items()[i].kind == b.orders.items()[i].kind);
        CHECK(a.orders.items()[i].steps == b.orders.items()[i].steps);
    }
}

}  // namespace

TEST_CASE("every construct is written as it was read") {
    CHECK(write_grafcet(parsed(canonical)) == canonical);
}

TEST_CASE("another layout of the same chart is written in the canonical one") {
    std::string crowded;
    for (const char c : canonical) crowded += c == '\n' ? std::string("  # x\n\t") : std::string{c};
    const Grafcet grafcet = parsed(crowded);
    CHECK(write_grafcet(grafcet) == canonical);
    check_same(grafcet, parsed(canonical));
}

TEST_CASE("a chart without header and declarations") {
    const std::string text = "graph G {\n  initial 1\n\n  1 -> 1 : Init\n}\n\ngraph H {\n}\n";
    CHECK(write_grafcet(parsed(text)) == text);
    const std::string titled = "grafcet \"grafcet\" \"t\"\n\n" + text;
    CHECK(write_grafcet(parsed(titled)) == titled);
}

TEST_CASE("ranks survive a layout in which steps and transitions are mixed") {
    const Grafcet grafcet = parsed(R"(
input a
graph G { 1 -> M : a initial 1 M -> 1 : a macro M = e }
expansion e { E -> S : a entry E exit S }
)");
    const Grafcet back = parsed(write_grafcet(grafcet));
    check_same(grafcet, back);
    CHECK(back.transitions.items()[1].name == "1");
}

TEST_CASE("long declarations are broken between names") {
    std::string text = "input ";
    for (int i = 0; i < 40; ++i) text += "input_" + std::to_string(i) + ", ";
    text += "last\ngraph G { initial 1 1 -> 1 : last }";
    const std::string written = write_grafcet(parsed(text));
    CHECK(written.substr(0, 206) ==
          "input input_0, input_1, input_2, input_3, input_4, input_5, input_6, input_7, input_8, "
          "input_9,\n      input_10, input_11, input_12, input_13, input_14, input_15, input_16, "
          "input_17, input_18,\n      input_19");
    CHECK(parsed(written).inputs.size() == 41);
}

TEST_CASE("names are quoted only where they have to be") {
    CHECK(quoted_where_needed("lamp") == "lamp");
    CHECK(quoted_where_needed("été_2") == "été_2");
    CHECK(quoted_where_needed("INIT") == "INIT");
    CHECK(quoted_where_needed("007") == "007");
    CHECK(quoted_where_needed("H+") == "\"H+\"");
    CHECK(quoted_where_needed("a b") == "\"a b\"");
    CHECK(quoted_where_needed("5s") == "\"5s\"");
    CHECK(quoted_where_needed("_a") == "\"_a\"");
    CHECK(quoted_where_needed("a→b") == "\"a→b\"");
    CHECK(quoted_where_needed("") == "\"\"");
    for (const char* word :
         {"activation", "and",   "assume",    "counter", "deactivation", "do",    "encloses",
          "entry",      "exit",  "expansion", "fall",    "grafcet",      "graph", "if",
          "initial",    "input", "macro",     "not",     "on",           "or",    "output",
          "reset",      "rise",  "set",       "step",    "var",          "xor"})
        CHECK(quoted_where_needed(word) == "\"" + std::string(word) + "\"");
    for (const char* word : {"ms", "min", "h", "s", "us", "Step", "ifs", "x"})
        CHECK(quoted_where_needed(word) == word);
}
