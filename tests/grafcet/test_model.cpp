#include "parsing.h"

using namespace grafwire;
using namespace grafwire::testing;

TEST_CASE("nested expansions take the place of their macro-steps") {
    const Grafcet grafcet = parsed(R"(
input a
expansion inner { entry I1 exit I2 I1 -> I2 : a }
graph G {
  initial 1
  macro M1 = outer
  step 2
  macro M2 = other
  M1 -> 2 : a
  1 -> M1 : a
  2 -> M2 : a
  M2 -> 1 : a
}
expansion outer {
  entry O1
  macro N = inner
  exit O2
  O1 -> N : a
  N -> O2 : a
}
expansion other { entry P1 exit P2 P1 -> P2 : a }
)");
    std::string steps;
    for (const Step& step : grafcet.steps) steps += step.name + " ";
    CHECK(steps == "1 O1 I1 I2 O2 2 P1 P2 ");
    std::string transitions;
    for (const Transition& transition : grafcet.transitions) transitions += transition.name + " ";
    CHECK(transitions == "1 2 3 4 5 6 0 7 ");
    std::string macros;
    for (const Macro& macro : grafcet.macros)
        macros += macro.name + ":" + std::to_string(macro.steps.first) + "+" +
                  std::to_string(macro.steps.count) + " ";
    CHECK(macros == "M1:1+4 N:2+2 M2:6+2 ");
    CHECK(grafcet.blocks.items()[0].name == "inner");
    CHECK(grafcet.blocks.items()[0].graph == GraphId{0});
    CHECK(grafcet.graphs[GraphId{0}].block == BlockId{1});
    CHECK(grafcet.blocks.items()[1].nodes ==
          std::vector<Block::Node>{{false, 0}, {true, 0}, {false, 5}, {true, 2}});
    const Transition& first = grafcet.transitions[TransitionId{0}];
    CHECK(grafcet.steps[grafcet.preceding(first)[0]].name == "O2");
    CHECK(grafcet.blocks.items()[1].transitions.size() == 4);
}

TEST_CASE("every kind of action") {
    const Grafcet grafcet = parsed(R"(
input a
output c1, c2, s1, s2
var v
counter n : -2..7
graph G {
  initial 1 : c1, c2 if /(3s/X1), set s1, reset v on deactivation, s2 := a . v on ↑a
  step 2 : n := -n + 3 on activation, H{INIT}, H{6, 7}
  1 -> 2 : a do v := /v, n := 0, reset s1
  2 -> 1 : [n > 0]
}
graph H { initial 6 step 7 6 -> 7 : a 7 -> 6 : a }
)");
    REQUIRE(grafcet.actions.size() == 8);
    CHECK(grafcet.actions[0].kind == ActionKind::continuous);
    CHECK(grafcet.actions[0].expression == no_expr);
    CHECK(grafcet.actions[1].output == OutputId{1});
    CHECK(grafcet.actions[1].expression != no_expr);
    CHECK(grafcet.actions[2].trigger == Trigger::activation);
    CHECK(grafcet.actions[2].write.operation == WriteOperation::set);
    CHECK(grafcet.actions[3].trigger == Trigger::deactivation);
    CHECK(grafcet.actions[3].write.target == Variable{VariableKind::var, 0});
    CHECK(grafcet.actions[4].trigger == Trigger::event);
    CHECK(grafcet.expressions.kind(grafcet.actions[4].expression) == ExprKind::rise);
    CHECK(grafcet.expressions.kind(grafcet.actions[4].write.value) == ExprKind::conjunction);
    CHECK(grafcet.actions[5].write.target == Variable{VariableKind::counter, 0});
    CHECK(grafcet.sums[grafcet.actions[5].write.sum] ==
          Sum{{true, 0, 0}, {false, SumTerm::no_counter, 3}});
    CHECK(grafcet.orders.items()[0].kind == OrderKind::initial);
    CHECK(grafcet.orders.items()[1].steps.size() == 2);
    CHECK_FALSE(grafcet.outputs[OutputId{0}].stored);
    CHECK(grafcet.outputs[OutputId{2}].stored);
    CHECK(grafcet.counters[CounterId{0}].low == -2);
    CHECK(grafcet.clearing_actions_of(grafcet.transitions[TransitionId{0}]).size() == 3);
    CHECK(grafcet.clearing_actions_of(grafcet.transitions[TransitionId{1}]).empty());
}

TEST_CASE("transitions of every shape") {
    const Grafcet grafcet = parsed(R"(
input a
graph G {
  initial 1 step 2 step 3
  -> 1 : ↑a
  (end) 3 -> : a
  1 -> 2, 3 : =1
  2, 3 -> 1 := a
  1 -> 2 : = a
  1 -> 2 := 0 + 1
}
)");
    const auto shape = [&](std::uint32_t i) {
        const Transition& transition = grafcet.transitions[TransitionId{i}];
        return std::to_string(transition.preceding.count) + ">" +
               std::to_string(transition.following.count) + " " + transition.name;
    };
    CHECK(shape(0) == "0>1 0");
    CHECK(shape(1) == "1>0 end");
    CHECK(shape(2) == "1>2 2");
    CHECK(shape(3) == "2>1 3");
    CHECK(grafcet.expressions.kind(grafcet.transitions[TransitionId{2}].condition) ==
          ExprKind::constant);
    CHECK(grafcet.transitions[TransitionId{1}].labelled);
}

TEST_CASE("names in letters of any script, quoted names and numbers") {
    const Grafcet grafcet = parsed(
        "\xef\xbb\xbf"
        "input \"step\", été, V0, Ωμέγα, x_1, \"H+\"\r\n"
        "graph \"2\" { initial \"my step\" step 01 step 1 step 漢字\n"
        "(01) \"my step\" -> 01 : \"Xmy step\" . X01 . X漢字\n"
        "(1) -> 1 : été . \"V0\" . \"step\" . Ωμέγα . x_1 . \"H+\" }\n");
    CHECK(grafcet.name == "grafcet");
    CHECK(grafcet.inputs.items()[0].name == "step");
    CHECK(grafcet.inputs.items()[1].name == "été");
    CHECK(grafcet.inputs.items()[0].where.column == 7);
    CHECK(grafcet.inputs.items()[2].where.column == 20);
    CHECK(grafcet.graphs.items()[0].name == "2");
    CHECK(grafcet.steps.items()[0].name == "my step");
    CHECK(grafcet.steps.items()[1].name == "01");
    CHECK(grafcet.transitions.items()[0].name == "01");
    CHECK(variable_name(grafcet, {VariableKind::step, 0}) == "Xmy step");
    CHECK(variable_name(grafcet, {VariableKind::graph, 0}) == "X2");
    CHECK(variable_name(grafcet, {VariableKind::control, 1}) == "AUdur");
}

TEST_CASE("a quoted INIT in braces is a step") {
    const Grafcet grafcet = parsed(R"(
graph G { initial 1 : H{INIT} step 2 : H{"INIT"} 1 -> 2 : 1 2 -> 1 : 1 }
graph H { initial INIT INIT -> INIT : 1 }
)");
    CHECK(grafcet.orders.items()[0].kind == OrderKind::initial);
    CHECK(grafcet.orders.items()[1].kind == OrderKind::listed);
}

TEST_CASE("a file with nothing but a step") {
    for (const char* text :
         {"graph G{step 1}", "\xef\xbb\xbfgraph G{step 1}", "#\r\ngraph G{step 1}"}) {
        const Grafcet grafcet = parsed(text);
        CHECK(grafcet.graphs.size() == 1);
        CHECK(grafcet.name == "grafcet");
    }
}

TEST_CASE("assumptions") {
    Grafcet grafcet = parsed(R"(
input a, b
var m
assume /(a . b)
assume a + Init
graph G { initial 1 : set m 1 -> 1 : a }
)");
    REQUIRE(grafcet.assumptions.size() == 2);
    CHECK(write_expression(grafcet, grafcet.expressions, grafcet.assumptions[0].expression) ==
          "/(a.b)");
    const auto assume = [&grafcet](const std::string& text) {
        Diagnostics diagnostics;
        parse_assumption({"--assume", text}, grafcet, diagnostics);
        return messages_of(diagnostics);
    };
    CHECK(assume("a xor AUdur").empty());
    CHECK(grafcet.assumptions.size() == 3);
    CHECK(write_expression(grafcet, grafcet.expressions, grafcet.assumptions[2].expression) ==
          "a ⊕ AUdur");
    const std::size_t nodes = grafcet.expressions.size();
    CHECK(assume("↑b . XG + m + AUdux") ==
          "1:1 error: edge in 'assume'; an assumption is about the plant, so it is made of inputs "
          "and control inputs, without edges, times and comparisons\n"
          "1:6 error: 'XG' is no input in 'assume'; an assumption is about the plant, so it is "
          "made of inputs and control inputs, without edges, times and comparisons\n"
          "1:11 error: 'm' is no input in 'assume'; an assumption is about the plant, so it is "
          "made of inputs and control inputs, without edges, times and comparisons\n"
          "1:15 error: unknown variable 'AUdux'; did you mean 'AUdur'?\n");
    CHECK(assume("a b") ==
          "1:3 error: expected an operator or the end of the expression, got 'b'\n");
    CHECK(assume("") == "1:1 error: expected a condition, got the end of the file\n");
    CHECK(assume("\xff").find("not UTF-8") != std::string::npos);
    CHECK(grafcet.assumptions.size() == 3);
    CHECK(grafcet.expressions.size() == nodes);
}
