// Each invariant of the model is broken by hand, and fault_of says which.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "grafcet/grafcet_builder.h"
#include "parsing.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

constexpr std::string_view text = R"(input a, b
output lamp, kept
var v
counter n : 0..9
assume /(a.b)
graph G {
  initial 0 : lamp if a, set kept on ↑a, K{2}
  macro M = x
  step 1 encloses E{4} : K{}, v := a
  0 -> M : 5s/a
  M -> 1 : [n > 3] do n := n + 1
  (last) 1 -> 0 : 1
}
expansion x { entry I macro N = y exit O   I -> N : a   N -> O : b }
expansion y { entry P exit Q   P -> Q : 1 }
graph K { step 2 step 3   2 -> 3 : a }
graph E { step 4   4 -> 4 : b }
)";

/// The fault of the chart above after a change.
template <typename Change>
std::string fault_after(const Change& change) {
    Grafcet grafcet = parsed(text);
    change(grafcet);
    return fault_of(grafcet);
}

template <typename Id, typename Item>
Item& last(Table<Id, Item>& table) {
    return table.items().back();
}

}  // namespace

TEST_CASE("the chart has no fault before it is changed") {
    CHECK(fault_after([](Grafcet&) {}) == "");
    CHECK(fault_of(Grafcet()) == "");
}

TEST_CASE("no example has a fault") {
    std::size_t examples = 0;
    for (const auto& entry : std::filesystem::directory_iterator(GRAFWIRE_ROOT "/examples")) {
        if (entry.path().extension() != ".grafcet") continue;
        std::ostringstream example;
        example << std::ifstream(entry.path()).rdbuf();
        CHECK_MESSAGE(fault_of(parsed(example.str())) == "", entry.path().string());
        ++examples;
    }
    CHECK(examples >= 13);
}

TEST_CASE("faults of sums, expressions and declarations") {
    CHECK(fault_after([](Grafcet& g) { last(g.sums).clear(); }) ==
          "a sum has no terms, a negative number or no such counter");
    CHECK(fault_after([](Grafcet& g) { last(g.sums)[0].counter = 1; }) ==
          "a sum has no terms, a negative number or no such counter");
    CHECK(fault_after([](Grafcet& g) { last(g.sums)[1].value = -1; }) ==
          "a sum has no terms, a negative number or no such counter");
    CHECK(fault_after([](Grafcet& g) {
              g.expressions.variable({VariableKind::input, 2});
          }).starts_with("expression "));
    CHECK(fault_after([](Grafcet& g) { last(g.counters).low = 10; }) ==
          "the range of counter n is empty");
    CHECK(fault_after([](Grafcet& g) {
              g.assumptions[0].expression = g.expressions.rise(g.assumptions[0].expression);
          }) == "an assumption is not over inputs");
    CHECK(fault_after([](Grafcet& g) { g.assumptions[0].expression = no_expr; }) ==
          "an assumption is not over inputs");
}

TEST_CASE("faults of blocks, steps and macro-steps") {
    CHECK(fault_after([](Grafcet& g) { last(g.blocks).graph = GraphId{3}; }) ==
          "block E lists what there is not");
    CHECK(fault_after([](Grafcet& g) { last(g.blocks).nodes[0].index = 99; }) ==
          "block E lists what there is not");
    CHECK(fault_after([](Grafcet& g) { last(g.steps).graph = GraphId{0}; }) ==
          "step 4 is in no graph or no block of it");
    CHECK(fault_after([](Grafcet& g) { last(g.steps).role = StepRole::entry; }) ==
          "step 4 is the entry or exit of a graph");
    CHECK(fault_after([](Grafcet& g) { g.steps[StepId{1}].initial = true; }) ==
          "step I is an entry or exit, and is initial or encloses");
    CHECK(fault_after([](Grafcet& g) { last(g.steps).enclosure = EnclosureId{1}; }) ==
          "step 4 has no such enclosure");
    CHECK(fault_after([](Grafcet& g) { ++last(g.steps).actions.first; }) ==
          "the actions of step 4 are out of order");
    CHECK(fault_after([](Grafcet& g) { g.actions.push_back(g.actions.back()); }) ==
          "an action belongs to no step");
    CHECK(fault_after([](Grafcet& g) { last(g.macros).expansion = BlockId{0}; }) ==
          "macro-step N has no place or no expansion");
    CHECK(fault_after([](Grafcet& g) { last(g.macros).expansion = BlockId{1}; }) ==
          "two macro-steps have one expansion");
    CHECK(fault_after([](Grafcet& g) { last(g.macros).entry = last(g.macros).exit; }) ==
          "macro-step N has no entry or exit step");
    CHECK(fault_after([](Grafcet& g) { g.macros.items().pop_back(); }) ==
          "block x lists what there is not");
    CHECK(fault_after([](Grafcet& g) {
              g.blocks.add({"z", true, GraphId{0}, {}, {}, {}});
          }) == "no macro-step uses expansion z");
}

TEST_CASE("faults of the order of steps") {
    CHECK(fault_after([](Grafcet& g) { g.graphs.items().pop_back(); }) ==
          "block E lists what there is not");
    CHECK(fault_after([](Grafcet& g) { last(g.graphs).block = BlockId{1}; }) ==
          "graph E has no block");
    CHECK(fault_after([](Grafcet& g) { ++last(g.graphs).steps.first; }) ==
          "the steps of graph E are out of order");
    CHECK(fault_after([](Grafcet& g) { ++last(g.graphs).transitions.first; }) ==
          "the transitions of graph E are out of order");
    CHECK(fault_after([](Grafcet& g) { g.graphs[GraphId{1}].enclosed_by = EnclosureId{1}; }) ==
          "graph K is enclosed by what there is not");
    CHECK(fault_after([](Grafcet& g) { ++last(g.graphs).steps.count; }) == "a step is in no graph");
    CHECK(fault_after([](Grafcet& g) { ++last(g.graphs).transitions.count; }) ==
          "a transition is in no graph");
    CHECK(fault_after([](Grafcet& g) {
              std::swap(g.blocks[BlockId{3}].nodes[0], g.blocks[BlockId{3}].nodes[1]);
          }) == "the steps of block K are out of order");
    CHECK(fault_after([](Grafcet& g) { last(g.steps).block = BlockId{3}; }) ==
          "step 4 is in no graph or no block of it");
    CHECK(fault_after([](Grafcet& g) { ++g.macros[MacroId{0}].steps.first; }) ==
          "macro-step M has not the steps of its expansion");
    CHECK(fault_after([](Grafcet& g) { --g.macros[MacroId{0}].steps.count; }) ==
          "macro-step M has not the steps of its expansion");
    CHECK(fault_after([](Grafcet& g) {
              --g.graphs[GraphId{1}].steps.count;
              --last(g.graphs).steps.first;
              ++last(g.graphs).steps.count;
          }) == "graph K has not the steps of its block");
}

TEST_CASE("faults of enclosures") {
    CHECK(fault_after([](Grafcet& g) { last(g.enclosures).step = StepId{0}; }) ==
          "enclosure 0 is not that of its step and graph");
    CHECK(fault_after([](Grafcet& g) { last(g.enclosures).graph = GraphId{1}; }) ==
          "enclosure 0 is not that of its step and graph");
    CHECK(fault_after([](Grafcet& g) { last(g.enclosures).links.clear(); }) ==
          "enclosure 0 links to no step of its graph");
    CHECK(fault_after([](Grafcet& g) { last(g.enclosures).links[0] = StepId{0}; }) ==
          "enclosure 0 links to no step of its graph");
    CHECK(fault_after([](Grafcet& g) { g.graphs[GraphId{1}].enclosed_by = EnclosureId{0}; }) ==
          "a step or graph has the enclosure of another");
    CHECK(fault_after([](Grafcet& g) { last(g.steps).enclosure = EnclosureId{0}; }) ==
          "a step or graph has the enclosure of another");
    CHECK(fault_after([](Grafcet& g) {
              Enclosure second = last(g.enclosures);
              second.step = StepId{0};
              second.graph = GraphId{1};
              second.links = {StepId{g.graphs[GraphId{1}].steps.first}};
              g.steps[StepId{0}].enclosure = g.enclosures.add(second);
              g.graphs[GraphId{1}].enclosed_by = EnclosureId{1};
          }) == "enclosure 1 is out of order");
}

TEST_CASE("faults of actions and orders") {
    // lamp if a, set kept, K{2} of step 0; K{}, v := a of step 1
    CHECK(fault_after([](Grafcet& g) { g.actions[0].step = StepId{1}; }) ==
          "an action of step 0 is another's");
    CHECK(fault_after([](Grafcet& g) { g.actions[0].output = OutputId{2}; }) ==
          "an action of step 0 is not of its kind");
    CHECK(fault_after([](Grafcet& g) { g.actions[0].order = OrderId{0}; }) ==
          "an action of step 0 is not of its kind");
    CHECK(fault_after([](Grafcet& g) { g.actions[1].expression = no_expr; }) ==
          "an action of step 0 is not of its kind");
    CHECK(fault_after([](Grafcet& g) {
              g.actions[1].write.target = {VariableKind::input, 0};
          }) == "an action of step 0 is not of its kind");
    CHECK(fault_after([](Grafcet& g) { g.actions[1].write.value = g.actions[1].expression; }) ==
          "an action of step 0 is not of its kind");
    CHECK(fault_after([](Grafcet& g) { g.actions[4].write.sum = SumId{0}; }) ==
          "an action of step 1 is not of its kind");
    CHECK(fault_after([](Grafcet& g) { g.actions[2].order = OrderId{2}; }) ==
          "an action of step 0 is not of its kind");
    CHECK(fault_after([](Grafcet& g) { g.actions[2].order = OrderId{1}; }) ==
          "an action of step 0 is not of its kind");
    CHECK(fault_after([](Grafcet& g) { g.orders.add(last(g.orders)); }) ==
          "an order belongs to no step");
    CHECK(fault_after([](Grafcet& g) {
              g.orders.items().insert(g.orders.begin(), last(g.orders));
              g.orders.items()[0].step = StepId{0};
              g.actions[2].order = OrderId{1};
              g.orders.items()[1].step = StepId{0};
          }) == "the orders of step 0 are out of order");
    CHECK(fault_after([](Grafcet& g) { last(g.orders).graph = GraphId{3}; }) ==
          "an order of step 1 is to no graph");
    CHECK(fault_after([](Grafcet& g) { last(g.orders).steps = {StepId{0}}; }) ==
          "an order of step 1 lists what it cannot force");
    CHECK(fault_after([](Grafcet& g) { g.orders[OrderId{0}].steps.clear(); }) ==
          "an order of step 0 lists what it cannot force");
    CHECK(fault_after([](Grafcet& g) { g.orders[OrderId{0}].steps = {StepId{0}}; }) ==
          "an order of step 0 lists what it cannot force");
}

TEST_CASE("faults of transitions") {
    const auto named = [](Grafcet& g, std::string_view name) -> Transition& {
        return *std::find_if(g.transitions.begin(), g.transitions.end(),
                             [&](const Transition& t) { return t.name == name; });
    };
    CHECK(fault_after([&](Grafcet& g) { named(g, "last").block = BlockId{3}; }) ==
          "transition last is in no block or another graph");
    CHECK(fault_after([&](Grafcet& g) { named(g, "last").condition = no_expr; }) ==
          "transition last has no condition");
    CHECK(fault_after([&](Grafcet& g) { ++named(g, "last").preceding.first; }) ==
          "the links of transition last are out of order");
    CHECK(fault_after([&](Grafcet& g) { ++named(g, "last").following.first; }) ==
          "the links of transition last are out of order");
    CHECK(fault_after([](Grafcet& g) { last(g.transitions).following.count = 99; }) ==
          "the links of transition " + parsed(text).transitions.items().back().name +
              " are out of order");
    CHECK(fault_after([](Grafcet& g) { g.links.push_back(StepId{0}); }) ==
          "a link belongs to no transition");
    CHECK(fault_after([](Grafcet& g) { g.links[0] = StepId{2}; }) ==
          "transition 0 links a step of another block");
    CHECK(fault_after([](Grafcet& g) { ++g.transitions[TransitionId{0}].clearing.first; }) ==
          "the actions of transition 0 are out of order");
    CHECK(fault_after([](Grafcet& g) { g.clearing_actions[0].transition = TransitionId{0}; }) ==
          "an action of transition 1 is another's or no write");
    CHECK(fault_after([](Grafcet& g) { g.clearing_actions[0].write.sum = none; }) ==
          "an action of transition 1 is another's or no write");
    CHECK(fault_after([](Grafcet& g) { g.clearing_actions.push_back(g.clearing_actions[0]); }) ==
          "an action on clearing belongs to no transition");
    CHECK(fault_after([](Grafcet& g) {
              auto& transitions = g.blocks[BlockId{0}].transitions;
              std::swap(transitions[0], transitions[1]);
          }) == "the transitions of block G are out of order");
    CHECK(fault_after([](Grafcet& g) {
              --g.graphs[GraphId{1}].transitions.count;
              --last(g.graphs).transitions.first;
              ++last(g.graphs).transitions.count;
          }) == "graph K has not the transitions of its block");
    CHECK(fault_after([](Grafcet& g) {
              Transition empty = g.transitions[TransitionId{0}];
              empty.name = "none";
              empty.preceding = {static_cast<std::uint32_t>(g.links.size()), 0};
              empty.following = empty.preceding;
              empty.clearing = {1, 0};
              g.transitions.add(empty);
              ++last(g.graphs).transitions.count;
          }) == "transition none has no steps");
}

TEST_CASE("faults of outputs") {
    CHECK(fault_after([](Grafcet& g) { g.outputs[OutputId{0}].stored = true; }) ==
          "output lamp is stored, or is not");
    CHECK(fault_after([](Grafcet& g) { g.outputs[OutputId{1}].stored = false; }) ==
          "output kept is stored, or is not");
    CHECK(fault_after([](Grafcet& g) { g.actions[0].output = OutputId{1}; }) ==
          "output kept is driven by both kinds of action");
}
