// Random receptivities: what the equations hold means the same as what was written, and keeps the
// promises of the header about its form.

#include <map>

#include "equations/parsed.h"
#include "random/random_expression.h"
#include "support/evaluate_expression.h"

namespace grafwire::testing {

namespace {

// A value for everything an expression can depend on. Edges and time conditions have values of
// their own, by ordinal, which is how evolution and netlist agree on them.
struct Assignment {
    const Grafcet& grafcet;
    std::map<Variable, bool> variables;
    std::vector<bool> edges;
    std::vector<bool> times;
    std::vector<std::int64_t> counters;
};

bool any_step(std::uint32_t first, std::uint32_t count, const Assignment& values) {
    for (std::uint32_t i = first; i < first + count; ++i)
        if (values.variables.at({VariableKind::step, i})) return true;
    return false;
}

bool variable_value(Variable variable, const Assignment& values) {
    if (variable.kind == VariableKind::macro) {
        const Macro& macro = values.grafcet.macros[MacroId{variable.index}];
        return any_step(macro.steps.first, macro.steps.count, values);
    }
    if (variable.kind == VariableKind::graph) {
        const Graph& graph = values.grafcet.graphs[GraphId{variable.index}];
        return any_step(graph.steps.first, graph.steps.count, values);
    }
    return values.variables.at(variable);
}

bool evaluate(const Expressions& pool, ExprId id, const Assignment& values) {
    return value_of(pool, id,
                    {[&](Variable variable) { return variable_value(variable, values); },
                     [&](std::size_t edge) { return values.edges[edge]; },
                     [&](std::size_t condition) { return values.times[condition]; },
                     [&](std::uint32_t counter) { return values.counters[counter]; }});
}

// Edges and time conditions whose operand is constantly 0 (for edges also 1) are 0.
Assignment random_assignment(const Grafcet& grafcet, const Equations& equations,
                             RandomSource& random) {
    Assignment values{grafcet, {}, {}, {}, {}};
    const auto add = [&](VariableKind kind, std::size_t count) {
        for (std::uint32_t i = 0; i < count; ++i)
            values.variables[{kind, i}] = random.below(2) == 1;
    };
    add(VariableKind::input, grafcet.inputs.size());
    add(VariableKind::control, control_input_count);
    add(VariableKind::var, grafcet.vars.size());
    add(VariableKind::step, grafcet.steps.size());
    for (std::size_t i = 0; i < grafcet.counters.size(); ++i)
        values.counters.push_back(static_cast<std::int64_t>(random.below(10)));
    const auto constant_here = [&](ExprId id) {
        return equations.expressions.kind(equations.from_grafcet[index_of(id)]) ==
               ExprKind::constant;
    };
    for (const ExprId id : grafcet.expressions.edges())
        values.edges.push_back(!constant_here(id) && random.below(2) == 1);
    for (const ExprId id : grafcet.expressions.time_conditions())
        values.times.push_back(!constant_here(id) && random.below(2) == 1);
    values.edges.resize(equations.expressions.edges().size());
    return values;
}

void check_form(const Expressions& pool, ExprId root) {
    std::vector<ExprId> pending{root};
    while (!pending.empty()) {
        const ExprId id = pending.back();
        pending.pop_back();
        const ExprKind kind = pool.kind(id);
        if (kind == ExprKind::variable) {
            CHECK(pool.variable_of(id).kind != VariableKind::macro);
            CHECK(pool.variable_of(id).kind != VariableKind::graph);
        }
        // Operands of edges may be doubled on purpose; of the others none is constant or nested.
        const bool is_operator = kind == ExprKind::negation || kind == ExprKind::conjunction ||
                                 kind == ExprKind::disjunction || kind == ExprKind::exclusive_or;
        if (!is_operator) continue;
        for (const ExprId operand : pool.operands(id)) {
            CHECK(pool.kind(operand) != ExprKind::constant);
            CHECK(pool.kind(operand) != kind);
            pending.push_back(operand);
        }
    }
}

constexpr std::string_view declarations = R"(
input a, b, c
var v
counter n : 0..9
)";

std::string random_chart(RandomSource& random, const std::vector<std::string>& atoms,
                         int transitions) {
    std::string text(declarations);
    text += "graph G { initial 1 : set v  macro M = e  step 3 : n := 1\n";
    for (int i = 0; i < transitions; ++i)
        text += "1 -> 3 : " + expression_of(random, atoms, 3) + "\n";
    text += "3 -> M : 1  M -> 1 : 1 }\nexpansion e { entry E exit S  E -> S : a }\n";
    text += "graph H { step 7 step 8  7 -> 8 : b  8 -> 7 : c }\n";
    return text;
}

}  // namespace

TEST_CASE("random receptivities keep their meaning") {
    const std::vector<std::string> atoms{"a",        "b",
                                         "c",        "v",
                                         "0",        "1",
                                         "X1",       "X3",
                                         "XM",       "XG",
                                         "XH",       "XE",
                                         "↑a",       "↓a",
                                         "↑(a + 0)", "↑(XM.b)",
                                         "↓0",       "1s/a",
                                         "2s/c/1s",  "1s/0",
                                         "1s/(a.1)", "1s/(XM + XH)",
                                         "[n > 4]",  "[n = 2 + 1]",
                                         "Init",     "AUdur"};
    for (unsigned seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        RandomSource random(seed);
        const Grafcet grafcet = parsed(random_chart(random, atoms, 20));
        const Equations equations = equations_from(grafcet, without_modes);
        for (int round = 0; round < 40; ++round) {
            const Assignment values = random_assignment(grafcet, equations, random);
            for (const Transition& transition : grafcet.transitions) {
                const ExprId here = equations.from_grafcet[index_of(transition.condition)];
                if (round == 0) check_form(equations.expressions, here);
                CHECK(evaluate(grafcet.expressions, transition.condition, values) ==
                      evaluate(equations.expressions, here, values));
            }
        }
    }
}

TEST_CASE("random expressions: the minimised form is equal") {
    const std::vector<std::string> atoms{"a", "b", "c", "X1", "X3", "↑a", "1s/b", "[n > 4]"};
    for (unsigned seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        RandomSource random(seed);
        const Grafcet grafcet = parsed(random_chart(random, atoms, 10));
        const Equations equations = equations_from(grafcet, without_modes);
        Expressions pool = equations.expressions;
        std::vector<std::pair<ExprId, ExprId>> pairs;
        for (const ExprId receptivity : equations.transition_conditions) {
            pairs.emplace_back(receptivity, minimised(pool, receptivity));
        }
        for (int round = 0; round < 200; ++round) {
            const Assignment values = random_assignment(grafcet, equations, random);
            for (const auto& pair : pairs) {
                const ExprId written = pair.first;
                const ExprId smaller = pair.second;
                REQUIRE(smaller != no_expr);
                CHECK(evaluate(pool, written, values) == evaluate(pool, smaller, values));
            }
        }
    }
}

}  // namespace grafwire::testing
