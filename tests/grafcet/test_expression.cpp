#include "parsing.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

std::string chart_with(std::string_view expression) {
    return "input a, b, c, d, e, \"5\", \"x y\"\ncounter n : -9..9\ncounter m : 0..3\n"
           "graph G {\n initial 1\n step 2\n 1 -> 2 : " +
           std::string(expression) + "\n 2 -> 1 : a.b.c.d.e.\"5\".\"x y\".[n = m]\n}\n";
}

// The expression with every operator in parentheses of its own: the tree that was read.
std::string tree_of(const Grafcet& grafcet, ExprId id) {
    const Expressions& pool = grafcet.expressions;
    const auto joined = [&](std::string_view sign) {
        std::string result = "(";
        for (const ExprId operand : pool.operands(id)) {
            if (result.size() > 1) result += sign;
            result += tree_of(grafcet, operand);
        }
        return result + ")";
    };
    switch (pool.kind(id)) {
        case ExprKind::constant:
            return pool.constant_value(id) ? "1" : "0";
        case ExprKind::variable:
            return variable_name(grafcet, pool.variable_of(id));
        case ExprKind::negation:
            return "NOT" + joined("");
        case ExprKind::conjunction:
            return joined(" AND ");
        case ExprKind::disjunction:
            return joined(" OR ");
        case ExprKind::exclusive_or:
            return joined(" XOR ");
        case ExprKind::rise:
            return "RISE" + joined("");
        case ExprKind::fall:
            return "FALL" + joined("");
        case ExprKind::time_condition: {
            const TimeCondition& time = pool.time_condition_of(id);
            return "TIME(" + format_duration(time.on_delay) + ", " +
                   tree_of(grafcet, time.operand) + ", " + format_duration(time.off_delay) + ")";
        }
        case ExprKind::comparison:
            return write_expression(grafcet, pool, id);
    }
    return {};
}

std::string tree(std::string_view expression) {
    const Grafcet grafcet = parsed(chart_with(expression));
    return tree_of(grafcet, grafcet.transitions[TransitionId{0}].condition);
}

std::string written(std::string_view expression) {
    const Grafcet grafcet = parsed(chart_with(expression));
    return write_expression(grafcet, grafcet.expressions,
                            grafcet.transitions[TransitionId{0}].condition);
}

}  // namespace

TEST_CASE("precedence") {
    CHECK(tree("a") == "a");
    CHECK(tree("((a))") == "a");
    CHECK(tree("a + b . c") == "(a OR (b AND c))");
    CHECK(tree("a . b + c . d") == "((a AND b) OR (c AND d))");
    CHECK(tree("a ⊕ b . c + d") == "((a XOR (b AND c)) OR d)");
    CHECK(tree("a + b + c") == "(a OR b OR c)");
    CHECK(tree("a + (b + c)") == "(a OR (b OR c))");
    CHECK(tree("(a + b) + c") == "((a OR b) OR c)");
    CHECK(tree("/a . b") == "(NOT(a) AND b)");
    CHECK(tree("/(a . b)") == "NOT((a AND b))");
    CHECK(tree("//a") == "NOT(NOT(a))");
    CHECK(tree("↑a . b") == "(RISE(a) AND b)");
    CHECK(tree("↑/a") == "RISE(NOT(a))");
    CHECK(tree("/↓a") == "NOT(FALL(a))");
    CHECK(tree("↑↓a") == "RISE(FALL(a))");
    CHECK(tree("rise(a + b) . c") == "(RISE((a OR b)) AND c)");
    CHECK(tree("5s/a . b") == "(TIME(5s, a, 0s) AND b)");
    CHECK(tree("/3s/a") == "NOT(TIME(3s, a, 0s))");
    CHECK(tree("3s//a") == "TIME(3s, NOT(a), 0s)");
    CHECK(tree("↑3s/X2") == "RISE(TIME(3s, X2, 0s))");
}

TEST_CASE("every spelling of an operator") {
    CHECK(tree("a and b") == "(a AND b)");
    CHECK(tree("a . b * c & d and e") == "(a AND b AND c AND d AND e)");
    CHECK(tree("a + b | c or d") == "(a OR b OR c OR d)");
    CHECK(tree("a ⊕ b xor c") == "(a XOR b XOR c)");
    CHECK(tree("/a . !b . not c") == "(NOT(a) AND NOT(b) AND NOT(c))");
    CHECK(tree("↑a . rise(a)") == "(RISE(a) AND RISE(a))");
    CHECK(tree("↓a . fall(a)") == "(FALL(a) AND FALL(a))");
    CHECK(tree("0 + 1") == "(0 OR 1)");
}

TEST_CASE("the off-delay belongs to the innermost time condition") {
    CHECK(tree("1s/2s/a/3s") == "TIME(1s, TIME(2s, a, 3s), 0s)");
    CHECK(tree("1s/2s/a/3s/4s") == "TIME(1s, TIME(2s, a, 3s), 4s)");
    CHECK(tree("1s/(2s/a)/3s") == "TIME(1s, TIME(2s, a, 0s), 3s)");
    CHECK(tree("1s/(/2s/a)/3s") == "TIME(1s, NOT(TIME(2s, a, 0s)), 3s)");
    CHECK(tree("1s//2s/a/3s") == "TIME(1s, NOT(TIME(2s, a, 3s)), 0s)");
    CHECK(tree("1s/a/2s . b") == "(TIME(1s, a, 2s) AND b)");
}

TEST_CASE("the longest token wins") {
    CHECK(tree("1.5s/a") == "TIME(1.5s, a, 0s)");
    CHECK(tree("1 .5s/a") == "(1 AND TIME(5s, a, 0s))");
    CHECK(tree("1.0.a") == "(1 AND 0 AND a)");
    CHECK(tree("X1.5s/a") == "(X1 AND TIME(5s, a, 0s))");
    CHECK(tree("5min/a.2h/b.3us/c.4ms/d") ==
          "(TIME(5min, a, 0s) AND TIME(2h, b, 0s) AND TIME(3us, c, 0s) AND TIME(4ms, d, 0s))");
    CHECK(tree("[n<-1]") == "[n < -1]");
    CHECK(tree("[-1<>n]") == "[-1 <> n]");
    CHECK(tree("[m>=1].a") == "([m >= 1] AND a)");
}

TEST_CASE("names of every kind") {
    CHECK(tree("\"a\" + \"5\" + \"x y\"") == "(a OR 5 OR x y)");
    CHECK(tree("X1 + XG + Init + AUdur + AUdoux") == "(X1 OR XG OR Init OR AUdur OR AUdoux)");
    CHECK(tree("\"X1\"") == "X1");
}

TEST_CASE("comparisons") {
    CHECK(tree("[n = 3]") == "[n = 3]");
    CHECK(tree("[-n + 2 - m <= m - 1]") == "[-n + 2 - m <= m - 1]");
    CHECK(tree("[m<>2]") == "[m <> 2]");
    CHECK(tree("[m<2]") == "[m < 2]");
    CHECK(tree("[m>2]") == "[m > 2]");
}

TEST_CASE("expressions are written with the parentheses they need and no others") {
    for (const char* text : {"a",
                             "a + b.c",
                             "(a + b).c",
                             "a + (b + c)",
                             "(a.b).c",
                             "a.(b ⊕ c)",
                             "a ⊕ (b + c)",
                             "a ⊕ b.c + d",
                             "X1.↑a + /(a + b)",
                             "/(a.b)",
                             "//a",
                             "↑(a + b)",
                             "↓/a",
                             "↑↓a",
                             "5s/X1",
                             "5s/X1/2s",
                             "5s/(a.b)/2s",
                             "1s/2s/a/3s",
                             "1s/2s/a/3s/4s",
                             "1s/(2s/a)/3s",
                             "1s/(/2s/a)/3s",
                             "1s/(↑/2s/a)/3s",
                             "1s//2s/a",
                             "/3s/a",
                             "1 . 5s/a",
                             "1 . 0.a",
                             "X1 . 5s/a.b",
                             "2s/1 . 5s/a",
                             "1.5s/a.\"x y\"",
                             "\"5\".a",
                             "[n + 1 > -m - 2].a",
                             "0",
                             "1"}) {
        CHECK(written(text) == text);
        CHECK(tree(written(text)) == tree(text));
    }
    CHECK(written("((a) and (b))") == "a.b");
    CHECK(written("5s/a/0s") == "5s/a");
    CHECK(written("60s/a") == "1min/a");
}

TEST_CASE("equal expressions are one node") {
    const Grafcet grafcet = parsed(R"(
input a, b
graph G {
  initial 1
  step 2
  1 -> 2 : ↑a . 5s/X1 + (↑a . 5s/X1)
  2 -> 1 : 5s/X1 . ↑b
}
)");
    const Expressions& pool = grafcet.expressions;
    CHECK(pool.edges().size() == 2);
    CHECK(pool.time_conditions().size() == 1);
    CHECK(pool.ordinal(pool.edges()[1]) == 1);
    CHECK(pool.ordinal(pool.time_conditions()[0]) == 0);
    const ExprId sum = grafcet.transitions[TransitionId{0}].condition;
    CHECK(pool.operands(sum).size() == 2);
    CHECK(pool.operands(sum)[0] == pool.operands(sum)[1]);
    for (const ExprId operand : pool.operands(sum)) CHECK(operand < sum);
    CHECK(pool.operands(pool.time_conditions()[0]).empty());
}

TEST_CASE("building an expression twice gives the same node") {
    Expressions pool;
    const ExprId a = pool.variable({VariableKind::input, 0});
    const ExprId b = pool.variable({VariableKind::input, 1});
    const ExprId ab[] = {a, b};
    const ExprId ba[] = {b, a};
    CHECK(a == pool.variable({VariableKind::input, 0}));
    CHECK(a != pool.variable({VariableKind::var, 0}));
    CHECK(pool.constant(true) != pool.constant(false));
    CHECK(pool.conjunction(ab) == pool.conjunction(ab));
    CHECK(pool.conjunction(ab) != pool.conjunction(ba));
    CHECK(pool.conjunction(ab) != pool.disjunction(ab));
    CHECK(pool.rise(a) != pool.fall(a));
    CHECK(pool.rise(a) == pool.rise(a));
    CHECK(pool.edges().size() == 2);
    CHECK(pool.time_condition({second, a, 0}) == pool.time_condition({second, a, 0}));
    CHECK(pool.time_condition({second, a, 0}) != pool.time_condition({second, a, 1}));
    const Comparison comparison{{{false, 0, 0}}, Relation::less, {{true, SumTerm::no_counter, 1}}};
    CHECK(pool.comparison(comparison) == pool.comparison(comparison));
    CHECK(pool.comparison_of(pool.comparison(comparison)) == comparison);
    // The operands may be those of another node.
    const ExprId sum = pool.disjunction(ab);
    CHECK(pool.exclusive_or(pool.operands(sum)) == pool.exclusive_or(ab));
}

TEST_CASE("an emptied pool is as good as a new one") {
    Expressions pool;
    for (const std::uint32_t variables : {3U, 500U, 3U}) {
        std::vector<ExprId> all;
        for (std::uint32_t i = 0; i < variables; ++i) {
            const ExprId variable = pool.variable({VariableKind::input, variables - i});
            CHECK(static_cast<std::size_t>(variable) == 2 * i);
            all.push_back(pool.negation(variable));
        }
        const ExprId sum = pool.disjunction(all);
        pool.time_condition({second, pool.rise(sum), 0});
        CHECK(pool.size() == 2 * variables + 3);
        CHECK(pool.disjunction(all) == sum);
        CHECK(pool.edges().size() == 1);
        CHECK(pool.time_conditions().size() == 1);
        pool.clear();
        CHECK(pool.size() == 0);
        CHECK(pool.edges().empty());
    }
}
