// The two charts of the language's own description.

#include <fstream>
#include <sstream>

#include "parsing.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

constexpr std::string_view manipulator = R"(grafcet manipulator "Manipulateur en L"

input  v0, v1, h0, h1, dcy, au
output "V+", "H-", "H+"

graph G0 {
  initial 0 : G1{}              # forcing order: G1 to the empty situation
  step 1    : G1{10}            # forcing order: exactly step 10 active
  step 2
  step 3    : G1{*}             # freezing order: G1 keeps its situation

  (0) 0 -> 1 : ↑dcy . /au
  (1) 1 -> 2 : 1
  (2) 2 -> 3 : au
  (3) 3 -> 0 : /au
}

graph G1 {
  initial 10 : "H+"
  step 11    : "V+"
  step 12    : "H-" if v0
  step 13

  (10) 10 -> 11 : h1
  (11) 11 -> 12 : v1
  (12) 12 -> 13 : h0
  (13) 13 -> 10 : 5s/X13        # true once step 13 has been active for 5 s
}
)";

constexpr std::string_view press = R"(grafcet press "Hierarchy"
input start, stop, part, up, down
output "press", lamp
counter pieces : 0..9

graph G1 {
  initial 1
  macro M2 = cycle                     # macro-step, expanded by `cycle`
  step 3
  1 -> M2 : start
  M2 -> 3 : part do pieces := pieces + 1   # stored action on clearing
  3 -> 1 : /start
}

expansion cycle {                      # belongs to the graph of its macro-step
  entry E2
  step 21 : "press"
  exit S2
  E2 -> 21 : up
  21 -> S2 : down
}

graph G2 {
  initial 50 encloses G3{60}           # activation link to step 60
  step 51
  50 -> 51 : stop
  51 -> 50 : /stop
}

graph G3 {
  initial 60
  step 61 : lamp
  60 -> 61 : part
  61 -> 60 : /part
}
)";

}  // namespace

TEST_CASE("the manipulator") {
    CHECK(messages_of(manipulator).empty());
    const Grafcet grafcet = parsed(manipulator);
    CHECK(grafcet.name == "manipulator");
    CHECK(grafcet.title == "Manipulateur en L");
    CHECK(grafcet.inputs.size() == 6);
    CHECK(input_name(grafcet, 4) == "dcy");
    CHECK(input_name(grafcet, 6) == "Init");
    CHECK(input_name(grafcet, 8) == "AUdoux");
    CHECK(grafcet.graphs.size() == 2);
    CHECK(grafcet.steps.size() == 8);
    CHECK(grafcet.transitions.size() == 8);
    REQUIRE(grafcet.orders.size() == 3);
    CHECK(grafcet.orders.items()[0].kind == OrderKind::empty);
    CHECK(grafcet.orders.items()[1].kind == OrderKind::listed);
    CHECK(grafcet.orders.items()[1].steps == std::vector<StepId>{StepId{4}});
    CHECK(grafcet.orders.items()[2].kind == OrderKind::freeze);
    CHECK(grafcet.expressions.edges().size() == 1);
    REQUIRE(grafcet.expressions.time_conditions().size() == 1);
    const ExprId time = grafcet.expressions.time_conditions()[0];
    CHECK(grafcet.expressions.time_condition_of(time).on_delay == 5 * second);
    CHECK(grafcet.steps[StepId{3}].where.line == 10);
    CHECK(grafcet.steps[StepId{3}].where.column == 8);
}

TEST_CASE("the press") {
    CHECK(messages_of(press).empty());
    const Grafcet grafcet = parsed(press);
    std::string steps;
    for (const Step& step : grafcet.steps) steps += step.name + " ";
    CHECK(steps == "1 E2 21 S2 3 50 51 60 61 ");
    REQUIRE(grafcet.macros.size() == 1);
    const Macro& macro = grafcet.macros[MacroId{0}];
    CHECK(macro.entry == StepId{1});
    CHECK(macro.exit == StepId{3});
    CHECK(macro.steps.first == 1);
    CHECK(macro.steps.count == 3);
    CHECK(grafcet.steps[StepId{2}].graph == GraphId{0});
    CHECK(grafcet.following(grafcet.transitions[TransitionId{0}])[0] == macro.entry);
    CHECK(grafcet.preceding(grafcet.transitions[TransitionId{1}])[0] == macro.exit);
    REQUIRE(grafcet.enclosures.size() == 1);
    CHECK(grafcet.enclosures.items()[0].step == StepId{5});
    CHECK(grafcet.enclosures.items()[0].links == std::vector<StepId>{StepId{7}});
    CHECK(grafcet.graphs[GraphId{2}].enclosed_by == EnclosureId{0});
    REQUIRE(grafcet.clearing_actions.size() == 1);
    CHECK(grafcet.clearing_actions[0].write.target == Variable{VariableKind::counter, 0});
    CHECK(grafcet.sums[grafcet.clearing_actions[0].write.sum] ==
          Sum{{false, 0, 0}, {false, SumTerm::no_counter, 1}});
}

TEST_CASE("written and read back, the charts stay the same") {
    for (const std::string_view text : {manipulator, press}) {
        const std::string once = write_grafcet(parsed(text));
        CHECK(messages_of(once).empty());
        CHECK(write_grafcet(parsed(once)) == once);
    }
    CHECK(write_grafcet(parsed(press)).find(R"(grafcet press "Hierarchy"

input start, stop, part, up, down
output press, lamp
counter pieces : 0..9

graph G1 {
  initial 1
  macro M2 = cycle
  step 3

  1 -> M2 : start
  M2 -> 3 : part do pieces := pieces + 1
  3 -> 1 : /start
}

expansion cycle {
  entry E2
  step 21 : press
  exit S2

)") == 0);
}

TEST_CASE("the worked example of the language's description is accepted without a word") {
    std::ifstream file(GRAFWIRE_ROOT "/src/grafcet/README.md");
    std::ostringstream text;
    text << file.rdbuf();
    const std::string readme = text.str();
    const std::string opening = "```grafcet\n";
    const std::size_t begin = readme.find(opening);
    REQUIRE(begin != std::string::npos);
    const std::size_t start = begin + opening.size();
    const std::string chart = readme.substr(start, readme.find("```", start) - start);
    CHECK(messages_of(chart) == "");
    CHECK(parsed(chart).steps.size() == 9);
}
