#include <numeric>

#include "equations/logic.h"
#include "equations/parsed.h"

namespace grafwire::testing {

namespace {

struct Pool {
    Expressions pool;
    ExprId a = pool.variable({VariableKind::input, 0});
    ExprId b = pool.variable({VariableKind::input, 1});
    ExprId c = pool.variable({VariableKind::input, 2});
    ExprId zero = pool.constant(false);
    ExprId one = pool.constant(true);

    ExprId written_and(std::initializer_list<ExprId> ids) {
        return pool.conjunction({ids.begin(), ids.size()});
    }
    ExprId written_or(std::initializer_list<ExprId> ids) {
        return pool.disjunction({ids.begin(), ids.size()});
    }
    ExprId xor_of_all(std::initializer_list<ExprId> ids) {
        return xor_of(pool, {ids.begin(), ids.size()});
    }
};

}  // namespace

TEST_CASE_FIXTURE(Pool, "conjunction and disjunction") {
    CHECK(and_of(pool, {b, one, a, b}) == written_and({b, a}));
    CHECK(and_of(pool, {a, written_and({b, written_and({c, a})})}) == written_and({a, b, c}));
    CHECK(and_of(pool, {a, zero, b}) == zero);
    CHECK(and_of(pool, {one, one}) == one);
    CHECK(and_of(pool, {}) == one);
    CHECK(and_of(pool, {one, a}) == a);
    CHECK(and_of(pool, {a, written_or({b, c})}) == written_and({a, written_or({b, c})}));
    CHECK(or_of(pool, {b, zero, a, b}) == written_or({b, a}));
    CHECK(or_of(pool, {written_or({a, b}), written_or({c, a})}) == written_or({a, b, c}));
    CHECK(or_of(pool, {a, one}) == one);
    CHECK(or_of(pool, {}) == zero);
    CHECK(or_of(pool, {a, a}) == a);
}

TEST_CASE_FIXTURE(Pool, "exclusive or: constants invert, pairs cancel") {
    const ExprId a_xor_b = xor_of_all({a, b});
    CHECK(pool.kind(a_xor_b) == ExprKind::exclusive_or);
    CHECK(xor_of_all({a, zero, b}) == a_xor_b);
    CHECK(xor_of_all({a, one, b}) == pool.negation(a_xor_b));
    CHECK(xor_of_all({a, one}) == pool.negation(a));
    CHECK(xor_of_all({a, b, a}) == b);
    CHECK(xor_of_all({a, b, a, a}) == a_xor_b);
    CHECK(xor_of_all({a, a}) == zero);
    CHECK(xor_of_all({a_xor_b, c, b}) == xor_of_all({a, c}));
}

TEST_CASE_FIXTURE(Pool, "negation") {
    CHECK(not_of(pool, zero) == one);
    CHECK(not_of(pool, not_of(pool, a)) == a);
    CHECK(pool.kind(not_of(pool, a)) == ExprKind::negation);
    CHECK(is_constant(pool, one, true));
    CHECK_FALSE(is_constant(pool, one, false));
    CHECK_FALSE(is_constant(pool, a, true));
}

TEST_CASE_FIXTURE(Pool, "large operators are shared, not copied") {
    std::vector<ExprId> many;
    for (std::uint32_t i = 0; i < 1000; ++i)
        many.push_back(pool.variable({VariableKind::input, i}));
    const ExprId sum = or_of(pool, many);
    CHECK(pool.operands(sum).size() == 1000);
    const ExprId longer = or_of(pool, {sum, pool.variable({VariableKind::input, 2000})});
    CHECK(pool.operands(longer).size() == 2);
    // Repeated operands go also where there are many.
    many.insert(many.end(), many.begin(), many.end());
    CHECK(or_of(pool, many) == sum);
}

TEST_CASE_FIXTURE(Pool, "deeply nested operators are flattened without recursion") {
    ExprId nested = a;
    for (int i = 0; i < 200'000; ++i) nested = written_or({nested, i % 2 == 0 ? b : c});
    CHECK(or_of(pool, {nested, c}) == written_or({a, b, c}));
}

TEST_CASE("edges and time conditions keep their ordinals") {
    const Grafcet grafcet = parsed(R"(
        input a, b
        graph G {
          initial 1 macro M = e
          1 -> M : ↑(a + 0) + ↑a + ↑(a . 1 . 1) + ↓a + ↑(0 . b) + ↓1
          M -> 1 : 2s/(a + 0) + 2s/a + 1s/0 + 1s/1 + 2s/XM + 2s/(XE + XS) + 2s/(a . 1)
        }
        expansion e { entry E exit S  E -> S : b })");
    const Equations equations = equations_from(grafcet, without_modes);
    const Expressions& source = grafcet.expressions;
    const Expressions& pool = equations.expressions;
    const auto here = [&](ExprId id) {
        return write_expression(grafcet, equations.expressions,
                                equations.from_grafcet[index_of(id)]);
    };

    std::vector<std::string> edges;
    for (const ExprId id : source.edges()) edges.push_back(here(id));
    CHECK(edges == std::vector<std::string>{"↑a", "↑(a.a)", "↑(a.(a.a))", "↓a", "0", "0"});

    std::vector<std::string> times;
    for (const ExprId id : source.time_conditions()) times.push_back(here(id));
    CHECK(times == std::vector<std::string>{"2s/a", "2s/(a.a)", "0", "1s/1", "2s/(XE + XS)",
                                            "2s/((XE + XS).(XE + XS))", "2s/(a.(a.a))"});

    for (std::size_t i = 0; i < edges.size(); ++i)
        if (edges[i] != "0")
            CHECK(pool.ordinal(equations.from_grafcet[index_of(source.edges()[i])]) == i);
    for (std::size_t i = 0; i < times.size(); ++i)
        if (times[i] != "0")
            CHECK(pool.ordinal(equations.from_grafcet[index_of(source.time_conditions()[i])]) == i);
    CHECK(pool.edges().size() == source.edges().size());
    CHECK(pool.time_conditions().size() == source.time_conditions().size());
}

}  // namespace grafwire::testing
