// GrafcetBuilder without any text: a chart told part by part is the one that is read, and whatever
// is wrong is reported with the places given.

#include <array>

#include "grafcet/grafcet_builder.h"
#include "grafcet/messages.h"
#include "parsing.h"
#include "properties/same_model.h"
#include "text/utf8.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

NamedExpression variable(std::string_view name) {
    NamedExpression expression;
    expression.variable({name, {}});
    return expression;
}

NamedExpression always() {
    NamedExpression expression;
    expression.constant(true);
    return expression;
}

NamedWrite write(WriteOperation operation, std::string_view target, Location where = {}) {
    NamedWrite result;
    result.operation = operation;
    result.target = {target, where};
    result.where = where;
    return result;
}

NamedTerm counter(std::string_view name) {
    return {false, Name{name, {}}};
}

NamedTerm number(std::int64_t value) {
    return {false, std::nullopt, value};
}

NamedTransition transition(std::vector<Name> preceding, std::vector<Name> following,
                           NamedExpression condition, Location where = {}) {
    NamedTransition result;
    result.preceding = std::move(preceding);
    result.following = std::move(following);
    result.condition = std::move(condition);
    result.where = where;
    return result;
}

/// A graph G with an initial step 0, to which a test adds what it is about.
struct SmallChart {
    Diagnostics diagnostics;
    GrafcetBuilder builder{diagnostics};
    BlockId graph;
    GrafcetBuilder::StepKey step;

    SmallChart() {
        builder.add_input({"a", {1, 7}});
        builder.add_output({"l", {2, 8}});
        builder.add_var({"v", {3, 5}});
        builder.add_counter({"c", {4, 9}}, 0, 9);
        graph = builder.add_graph({"G", {5, 7}});
        step = builder.add_step(graph, {"0", {6, 11}}, true);
    }

    /// The errors of the finished chart; warnings are left out.
    std::string errors() {
        const auto grafcet = builder.finish();
        CHECK(grafcet.has_value() != diagnostics.has_errors());
        if (grafcet) CHECK(fault_of(*grafcet) == "");
        Diagnostics only;
        for (const Diagnostic& item : diagnostics.items()) {
            if (item.severity != Severity::error) continue;
            only.error(item.code, item.where, item.message).notes = item.notes;
        }
        return messages_of(only);
    }
};

}  // namespace

TEST_CASE("a chart told part by part is the one that is read") {
    const Grafcet read = parsed(R"(grafcet lift "Crate lift"
input crate, bottom, stop
output up, lamp
var m
counter n : -1..10
assume /(crate . stop)
graph Safety {
  initial 0
  step 1 : Work{}
  step 2 : Work{10, 11}
  step 3 : Work{INIT}, Work{*}
  0 -> 1 : stop
  1 -> 2 : ↑crate . /stop
  2, 3 -> 0 : 1
}
graph Work {
  step 10 encloses Lamp{20, 21}
  step 11 : up if /bottom, set m, reset m on deactivation, m := crate ⊕ bottom on ↓(stop + m)
  macro M = unload
  10 -> 11 : crate . bottom
  (full) 11 -> M : 1.5s/bottom/2s do n := n + 1 - 3, m := X11
  M -> 10 : [n >= 5] + XM . /XWork
}
expansion unload { entry E   step 30   exit S   E -> 30 : 1   30 -> S : Init }
graph Lamp { step 20 : lamp   step 21   20 -> : 1   -> 21 : stop }
)");

    Diagnostics diagnostics;
    GrafcetBuilder builder(diagnostics);
    builder.set_name("lift", "Crate lift");
    for (const char* name : {"crate", "bottom", "stop"}) builder.add_input({name, {}});
    for (const char* name : {"up", "lamp"}) builder.add_output({name, {}});
    builder.add_var({"m", {}});
    builder.add_counter({"n", {}}, -1, 10);
    NamedExpression expression;
    expression.variable({"crate", {}}).variable({"stop", {}});
    expression.join(ExprKind::conjunction, 2).join(ExprKind::negation, 1);
    builder.add_assumption(expression, {});

    // The blocks one after the other, their contents by turns.
    const BlockId safety = builder.add_graph({"Safety", {}});
    const BlockId work = builder.add_graph({"Work", {}});
    const BlockId unload = builder.add_expansion({"unload", {}});
    const BlockId lamp = builder.add_graph({"Lamp", {}});
    const auto step_10 = builder.add_step(work, {"10", {}});
    builder.add_step(safety, {"0", {}}, true);
    builder.add_entry(unload, {"E", {}});
    const auto step_1 = builder.add_step(safety, {"1", {}});
    const auto step_11 = builder.add_step(work, {"11", {}});
    const auto step_20 = builder.add_step(lamp, {"20", {}});
    const auto step_2 = builder.add_step(safety, {"2", {}});
    const auto step_3 = builder.add_step(safety, {"3", {}});
    builder.add_macro(work, {"M", {}}, Name{"unload", {}});
    builder.add_step(unload, {"30", {}});
    builder.add_exit(unload, {"S", {}});
    builder.add_step(lamp, {"21", {}});

    builder.add_order(step_3, {"Work", {}}, OrderKind::initial, {}, {});
    builder.add_continuous(step_20, {"lamp", {}}, {}, {});
    expression.clear();
    builder.add_continuous(step_11, {"up", {}},
                           expression.variable({"bottom", {}}).join(ExprKind::negation, 1), {});
    builder.add_order(step_1, {"Work", {}}, OrderKind::listed, {}, {});  // lists nothing: empties
    builder.add_stored(step_11, write(WriteOperation::set, "m"), Trigger::activation);
    builder.add_stored(step_11, write(WriteOperation::reset, "m"), Trigger::deactivation);
    NamedWrite assigned = write(WriteOperation::assign, "m");
    assigned.value.variable({"crate", {}}).variable({"bottom", {}});
    assigned.value.join(ExprKind::exclusive_or, 2);
    expression.clear();
    expression.variable({"stop", {}}).variable({"m", {}}).join(ExprKind::disjunction, 2);
    builder.add_stored(step_11, assigned, Trigger::event, expression.join(ExprKind::fall, 1));
    builder.add_order(step_3, {"Work", {}}, OrderKind::freeze, {}, {});
    builder.add_order(step_2, {"Work", {}}, OrderKind::listed,
                      std::array{Name{"10", {}}, Name{"11", {}}}, {});
    builder.add_enclosure(step_10, {"Lamp", {}}, std::array{Name{"20", {}}, Name{"21", {}}});

    // A transition without a label is named by its rank, so these come as the text has them.
    builder.add_transition(safety, transition({{"0", {}}}, {{"1", {}}}, variable("stop")));
    expression.clear();
    expression.variable({"crate", {}}).join(ExprKind::rise, 1);
    expression.variable({"stop", {}}).join(ExprKind::negation, 1).join(ExprKind::conjunction, 2);
    builder.add_transition(safety, transition({{"1", {}}}, {{"2", {}}}, expression));
    builder.add_transition(safety, transition({{"2", {}}, {"3", {}}}, {{"0", {}}}, always()));
    expression.clear();
    expression.variable({"crate", {}}).variable({"bottom", {}}).join(ExprKind::conjunction, 2);
    builder.add_transition(work, transition({{"10", {}}}, {{"11", {}}}, expression));
    expression.clear();
    expression.variable({"bottom", {}}).time_condition(1500 * millisecond, 2 * second);
    NamedTransition full = transition({{"11", {}}}, {{"M", {}}}, expression);
    full.label = Name{"full", {}};
    full.writes.push_back(write(WriteOperation::assign, "n"));
    full.writes.back().sum = {counter("n"), number(1), number(-3)};
    full.writes.push_back(write(WriteOperation::assign, "m"));
    full.writes.back().value = variable("X11");
    builder.add_transition(work, full);
    expression.clear();
    expression.comparison({counter("n")}, Relation::greater_equal, {number(5)});
    expression.variable({"XM", {}}).variable({"XWork", {}}).join(ExprKind::negation, 1);
    expression.join(ExprKind::conjunction, 2).join(ExprKind::disjunction, 2);
    builder.add_transition(work, transition({{"M", {}}}, {{"10", {}}}, expression));
    builder.add_transition(unload, transition({{"E", {}}}, {{"30", {}}}, always()));
    builder.add_transition(unload, transition({{"30", {}}}, {{"S", {}}}, variable("Init")));
    builder.add_transition(lamp, transition({{"20", {}}}, {}, always()));
    builder.add_transition(lamp, transition({}, {{"21", {}}}, variable("stop")));

    const std::optional<Grafcet> built = builder.finish();
    REQUIRE_MESSAGE(built.has_value(), messages_of(diagnostics));
    CHECK(write_grafcet(*built) == write_grafcet(read));
    CHECK(model_difference(*built, read) == "");
    CHECK(fault_of(*built) == "");
    CHECK(fault_of(read) == "");
}

TEST_CASE("the names given to the builder need not live on") {
    Diagnostics diagnostics;
    GrafcetBuilder builder(diagnostics);
    {
        std::string name = "initially";
        builder.add_step(builder.add_graph({name, {}}), {name + "2", {}}, true);
        name.assign(100, '?');
    }
    const auto grafcet = builder.finish();
    REQUIRE(grafcet.has_value());
    CHECK(grafcet->graphs.items()[0].name == "initially");
    CHECK(grafcet->steps.items()[0].name == "initially2");
}

TEST_CASE("names declared twice") {
    SmallChart chart;
    chart.builder.add_var({"a", {10, 1}});
    chart.builder.add_input({"Init", {11, 1}});
    chart.builder.add_graph({"G", {12, 1}});
    chart.builder.add_step(chart.graph, {"0", {13, 1}});
    chart.builder.add_output({"X0", {14, 1}});
    NamedTransition labelled = transition({{"0", {15, 2}}}, {}, always(), {15, 1});
    labelled.label = Name{"1", {15, 1}};
    chart.builder.add_transition(chart.graph, labelled);
    chart.builder.add_transition(chart.graph, transition({{"0", {16, 2}}}, {}, always(), {16, 1}));
    CHECK(chart.errors() ==
          R"(10:1 error: the variable 'a' exists already; rename one of the two
  1:7 note: it is first declared here
11:1 error: 'Init' is a control input, which every GRAFCET has without declaring it; remove this declaration or choose another name
12:1 error: the graph 'G' exists already; rename one of the two
  5:7 note: it is first declared here
13:1 error: the step '0' exists already; step names are unique in the whole file, so rename one of the two
  6:11 note: it is first declared here
14:1 error: step '0' and output 'X0' both have the variable 'X0'; rename one of them
  6:11 note: step '0' is declared here
15:1 error: the label '1' is also the rank of a transition without a label; label that one too, or choose another label
  16:1 note: this transition has rank 1: it is named '1'
)");
}

TEST_CASE("unknown names, with the nearest that there is") {
    SmallChart chart;
    auto& builder = chart.builder;
    builder.add_var({"motor", {}});
    builder.add_continuous(chart.step, {"lamp", {10, 1}}, variable("motr"), {10, 1});
    builder.add_stored(chart.step, write(WriteOperation::set, "moter", {11, 1}),
                       Trigger::activation);
    builder.add_order(chart.step, {"H", {12, 1}}, OrderKind::freeze, {}, {12, 1});
    builder.add_macro(chart.graph, {"M", {13, 1}}, Name{"nowhere", {13, 5}});
    NamedExpression compared;
    compared.comparison({{false, Name{"d", {14, 3}}}}, Relation::less, {number(3)});
    builder.add_transition(chart.graph, transition({{"00", {14, 1}}}, {}, compared, {14, 1}));
    CHECK(chart.errors() == R"(0:0 error: unknown variable 'motr'; did you mean 'motor'?
10:1 error: unknown output 'lamp'
11:1 error: unknown output 'moter'; did you mean 'motor'?
12:1 error: unknown graph 'H'
13:5 error: unknown expansion 'nowhere'
14:1 error: unknown step '00'; did you mean '0'?
14:3 error: unknown counter 'd'
)");
}

TEST_CASE("writes that do not fit their target") {
    SmallChart chart;
    NamedWrite condition = write(WriteOperation::assign, "c", {10, 1});
    condition.value = variable("a");
    chart.builder.add_stored(chart.step, condition, Trigger::activation);
    NamedWrite sum = write(WriteOperation::assign, "v", {11, 1});
    sum.sum = {number(1)};
    chart.builder.add_stored(chart.step, sum, Trigger::activation);
    chart.builder.add_stored(chart.step, write(WriteOperation::set, "c", {12, 1}),
                             Trigger::activation);
    chart.builder.add_stored(chart.step, write(WriteOperation::set, "a", {13, 1}),
                             Trigger::activation);
    CHECK(chart.errors() == R"(10:1 error: 'c' is a counter; assign a sum of counters and numbers
11:1 error: 'v' is not a counter; assign a condition
12:1 error: 'c' is a counter, which is neither set nor reset; write a value, as in c := 0
13:1 error: 'a' is an input, which the GRAFCET reads and never writes; name an output, a var or a counter
)");
}

TEST_CASE("an output driven both ways is refused where nothing has a place") {
    SmallChart chart;
    chart.builder.add_continuous(chart.step, {"l", {}}, {}, {});
    chart.builder.add_stored(chart.step, write(WriteOperation::set, "l"), Trigger::activation);
    CHECK(chart.errors() ==
          R"(0:0 error: output 'l' is driven by continuous and by stored actions; use one kind only
  0:0 note: a stored action drives it here
)");
}

TEST_CASE("ranges, numbers and durations out of bounds") {
    SmallChart chart;
    constexpr std::int64_t huge = 1'000'000'000'001;
    chart.builder.add_counter({"empty", {10, 1}}, 3, 2);
    chart.builder.add_counter({"wide", {11, 1}}, 0, 65'536);
    chart.builder.add_counter({"far", {12, 1}}, INT64_MIN, INT64_MAX);
    CHECK(chart.errors() ==
          R"(10:1 error: the range 3..2 of counter 'empty' is empty; write the lowest value first
11:1 error: the range 0..65536 of counter 'wide' spans 65537 values; a counter has 65536 at most
12:1 error: the number -9223372036854775808 is too large; numbers go up to 1000000000000
)");

    SmallChart sums;
    NamedExpression condition;
    condition.comparison({{false, std::nullopt, huge, {10, 1}}}, Relation::less,
                         {{false, std::nullopt, -huge, {10, 5}}});
    condition.variable({"a", {}}).time_condition(-1, 0, {10, 9}).join(ExprKind::conjunction, 2);
    condition.comparison({}, Relation::equal, {number(0)}, {10, 13});
    condition.join(ExprKind::conjunction, 2);
    sums.builder.add_transition(sums.graph, transition({{"0", {}}}, {}, condition, {10, 1}));
    CHECK(sums.errors() ==
          R"(10:1 error: the number 1000000000001 is too large; numbers go up to 1000000000000
10:5 error: the number 1000000000001 is too large; numbers go up to 1000000000000
10:9 error: a duration is negative or too long; durations go up to 106 days
10:13 error: a side of the comparison is empty
)");
}

TEST_CASE("names that cannot be written") {
    SmallChart chart;
    chart.builder.set_name("", "a\nb");
    chart.builder.add_input({"", {10, 1}});
    chart.builder.add_step(chart.graph, {"5\"", {11, 1}});
    CHECK(chart.errors() == "0:0 error: the GRAFCET has no name\n0:0 error: " +
                                control_in_name_message("a\nb").english +
                                R"(
10:1 error: a variable has no name
11:1 error: the name '5"' holds a quotation mark, and no name may
)");
}

TEST_CASE("parts that are missing") {
    SmallChart chart;
    auto& builder = chart.builder;
    builder.add_macro(chart.graph, {"M", {10, 1}}, std::nullopt);
    builder.add_stored(chart.step, write(WriteOperation::assign, "v", {11, 1}),
                       Trigger::activation);
    builder.add_stored(chart.step, write(WriteOperation::set, "v", {12, 1}), Trigger::event);
    builder.add_transition(chart.graph, transition({{"0", {}}}, {}, {}, {13, 1}));
    builder.add_assumption({}, {14, 1});
    builder.add_graph({"K", {15, 1}});
    builder.add_enclosure(chart.step, {"H", {16, 1}}, {});
    builder.add_step(builder.add_graph({"H", {17, 1}}), {"1", {17, 5}}, true);
    CHECK(chart.errors() == R"(10:1 error: macro-step 'M' has no expansion
11:1 error: the assignment has no condition
12:1 error: the event has no condition
13:1 error: this transition has no condition
14:1 error: this assumption has no condition
16:1 error: step '0' encloses 'H' without a step to activate
)");
}

TEST_CASE("what a reader has refused itself is not refused again") {
    SmallChart chart;
    chart.diagnostics.error(code::unexpected_token, {9, 9}, {"not understood", "non compris"});
    chart.builder.add_transition(chart.graph, transition({{"0", {}}}, {}, {}, {10, 1}));
    chart.builder.add_graph({"", {11, 1}});
    chart.builder.add_macro(chart.graph, {"M", {12, 1}}, std::nullopt);
    CHECK(chart.errors() == "9:9 error: not understood\n");
}

TEST_CASE("errors from before the builder are none of its own") {
    Diagnostics diagnostics;
    diagnostics.error(code::unreadable_file, {}, {"another file", "un autre fichier"});
    GrafcetBuilder builder(diagnostics);
    builder.add_step(builder.add_graph({"G", {}}), {"0", {}}, true);
    CHECK(builder.finish().has_value());
}

TEST_CASE("entry and exit steps") {
    SmallChart chart;
    chart.builder.add_entry(chart.graph, {"E", {10, 1}});
    chart.builder.add_exit(chart.graph, {"S", {11, 1}});
    const BlockId expansion = chart.builder.add_expansion({"x", {12, 1}});
    chart.builder.add_entry(expansion, {"E1", {13, 1}});
    chart.builder.add_entry(expansion, {"E2", {14, 1}});
    CHECK(chart.errors() ==
          R"(10:1 error: 'entry' stands in an expansion only; in a graph write 'step'
11:1 error: 'exit' stands in an expansion only; in a graph write 'step'
12:1 error: expansion 'x' has no exit step; declare it with 'exit S1'
12:1 error: no macro-step uses expansion 'x'; declare one with 'macro M = x', or remove the expansion
14:1 error: expansion 'x' has a second entry step; an expansion has exactly one
  13:1 note: the first one is here
)");
}

TEST_CASE("enclosures: one a step, one a graph, none of an entry step") {
    SmallChart chart;
    auto& builder = chart.builder;
    const BlockId other = builder.add_graph({"H", {10, 1}});
    builder.add_step(other, {"1", {11, 1}}, true);
    const std::array links{Name{"1", {}}};
    builder.add_enclosure(chart.step, {"H", {12, 1}}, links);
    builder.add_enclosure(chart.step, {"H", {13, 1}}, links);
    builder.add_enclosure(builder.add_step(chart.graph, {"2", {14, 1}}, true), {"H", {15, 1}},
                          links);
    CHECK(chart.errors() ==
          R"(13:1 error: step '0' encloses a graph already; a step encloses one graph at most
15:1 error: graph 'H' is enclosed by step '0' already; a graph is enclosed by one step at most
  6:11 note: it is first enclosed here
)");

    SmallChart entry;
    entry.builder.add_macro(entry.graph, {"M", {}}, Name{"x", {}});
    const BlockId expansion = entry.builder.add_expansion({"x", {}});
    const auto first = entry.builder.add_entry(expansion, {"E", {}});
    entry.builder.add_exit(expansion, {"S", {}});
    entry.builder.add_step(entry.builder.add_graph({"H", {}}), {"1", {}});
    entry.builder.add_enclosure(first, {"H", {12, 1}}, links);
    CHECK(entry.errors() ==
          "12:1 error: step 'E' is the entry or exit of an expansion, which "
          "encloses nothing\n");
}

TEST_CASE("a graph that forces itself, a transition without steps, a chart without steps") {
    SmallChart chart;
    chart.builder.add_order(chart.step, {"G", {10, 1}}, OrderKind::empty, {}, {10, 1});
    chart.builder.add_transition(chart.graph, transition({}, {}, always(), {11, 1}));
    CHECK(
        chart.errors() ==
        R"(10:1 error: step '0' forces its own graph 'G'; only another graph can be forced or enclosed
11:1 error: this transition has no step before it and none after it; name at least one, as in 1 -> 2
)");

    Diagnostics diagnostics;
    GrafcetBuilder builder(diagnostics);
    builder.add_graph({"G", {1, 1}});
    CHECK_FALSE(builder.finish().has_value());
    CHECK(diagnostics.items()[0].code == code::no_steps);
}

TEST_CASE("edges and outputs where they cannot be read") {
    SmallChart chart;
    NamedExpression edge;
    edge.variable({"a", {10, 5}}).join(ExprKind::rise, 1, {10, 4});
    chart.builder.add_continuous(chart.step, {"l", {10, 1}}, edge, {10, 1});
    chart.builder.add_assumption(edge, {11, 1});
    NamedExpression output;
    output.variable({"l", {12, 5}});
    chart.builder.add_transition(chart.graph, transition({{"0", {}}}, {}, output, {12, 1}));
    const std::string errors = chart.errors();
    CHECK(errors.find("10:4 error: edge in the condition of a continuous action") != errors.npos);
    CHECK(errors.find("10:4 error: edge in 'assume'") != errors.npos);
    CHECK(errors.find("12:5 error: 'l' is a continuous output") != errors.npos);

    // Inside a time condition an edge lasts, wherever it stands in there.
    SmallChart timed;
    NamedExpression lasting;
    lasting.variable({"v", {}}).variable({"a", {}}).join(ExprKind::rise, 1);
    lasting.variable({"a", {}}).join(ExprKind::conjunction, 2).time_condition(second, 0);
    timed.builder.add_continuous(timed.step, {"l", {}}, lasting.join(ExprKind::disjunction, 2), {});
    CHECK(timed.errors() == "");

    // Beside one it does not.
    SmallChart beside;
    NamedExpression both;
    both.variable({"a", {}}).join(ExprKind::rise, 1, {10, 1});
    both.variable({"a", {}}).time_condition(second, 0).join(ExprKind::conjunction, 2);
    beside.builder.add_continuous(beside.step, {"l", {}}, both, {});
    CHECK(beside.errors().find("10:1 error: edge in the condition") == 0);
}

TEST_CASE("the depth of expressions is counted as they are written") {
    const auto errors_of = [](int negations, bool is_of_sum) {
        SmallChart chart;
        NamedExpression condition;
        condition.variable({"a", {}});
        if (is_of_sum) condition.variable({"v", {}}).join(ExprKind::disjunction, 2);
        for (int i = 0; i < negations; ++i) condition.join(ExprKind::negation, 1);
        chart.builder.add_transition(chart.graph, transition({{"0", {}}}, {}, condition));
        const std::string errors = chart.errors();
        if (errors.empty()) return false;
        CHECK(errors.find("0:0 error: this expression is nested more than 500 levels deep") == 0);
        return true;
    };
    const auto is_refused_as_text = [](int negations, std::string_view inner) {
        return messages_of("input a\nvar v\ngraph G { initial 0 0 -> : " +
                           std::string(static_cast<std::size_t>(negations), '/') +
                           std::string(inner) + " }")
                   .find("nested more than 500") != std::string::npos;
    };
    for (const int negations : {497, 498, 499, 500, 501}) {
        CHECK(errors_of(negations, false) == is_refused_as_text(negations, "a"));
        CHECK(errors_of(negations, true) == is_refused_as_text(negations, "(a + v)"));
    }
}

TEST_CASE("an assumption is added to a finished chart") {
    Grafcet grafcet = parsed("input a, b\ngraph G { initial 1 1 -> 1 : a.b }");
    Diagnostics diagnostics;
    add_assumption(grafcet, variable("c"), {1, 1}, diagnostics);
    CHECK(messages_of(diagnostics) == "0:0 error: unknown variable 'c'\n");
    CHECK(grafcet.assumptions.empty());
    Diagnostics none_wrong;
    add_assumption(grafcet, variable("a"), {1, 1}, none_wrong);
    CHECK(messages_of(none_wrong) == "");
    REQUIRE(grafcet.assumptions.size() == 1);
    CHECK(fault_of(grafcet) == "");
}
