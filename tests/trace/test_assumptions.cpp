#include "trace/input_values.h"
#include "trace/small_grafcet.h"

namespace grafwire::testing {

TEST_CASE("the first broken assumption is found") {
    const Grafcet grafcet = read_grafcet(R"(
input a, b, c
assume /(a . b)
assume a + b + c + 0
assume a ⊕ b ⊕ c ⊕ Init . 1
graph G { initial 1  step 2  1 -> 2 : a . b . c }
)");
    const auto broken = [&](InputValues inputs) { return broken_assumption(grafcet, inputs); };
    CHECK(broken({1, 0, 0, 0, 0, 0}) == 3);
    CHECK(broken({1, 1, 1, 0, 0, 0}) == 0);
    CHECK(broken({0, 0, 0, 0, 0, 0}) == 1);
    CHECK(broken({1, 0, 1, 0, 0, 0}) == 2);
    CHECK(broken({1, 0, 1, 1, 0, 0}) == 3);
    CHECK(broken({1, 0, 1, 0, 1, 1}) == 2);
    CHECK(assumption_holds(grafcet, 0, {0, 0, 0, 0, 0, 0}));
    CHECK_FALSE(assumption_holds(grafcet, 1, {0, 0, 0, 0, 0, 0}));
}

TEST_CASE("without assumptions none is broken") {
    const Grafcet grafcet = read_grafcet("graph G { initial 1 }");
    CHECK(broken_assumption(grafcet, {1, 1, 1}) == 0);
}

}  // namespace grafwire::testing
