#include "equations/parsed.h"

namespace grafwire::testing {

TEST_CASE("the transition form takes the clearing of the transitions out of a step") {
    CHECK(csv(R"(
        input a, x, z
        graph G {
          initial 6 step 7 step 10 step 20
          6 -> 7 : a    7 -> 10 : x    7 -> 20 : z    10, 20 -> 6 : 1
        })",
              {.cdx = CdxForm::transition, .modes = false}) == R"(variable,CAX,CDX,X
X6,X10.X20,X6.a,X10.X20 + /(X6.a).X6
X7,X6.a,X7.x + X7.z,X6.a + /(X7.x + X7.z).X7
X10,X7.x,X10.X20,X7.x + /(X10.X20).X10
X20,X7.z,X10.X20,X7.z + /(X10.X20).X20
)");
}

TEST_CASE("the transition form with modes") {
    CHECK(csv(R"(
        input m, b
        graph G { initial 0 step 1  0 -> 1 : m  1 -> 0 : b })",
              {.cdx = CdxForm::transition}) == R"(variable,CAX,CDX,X
X0,X1.b + Init,X0.m./Init,(X1.b + /(X0.m).X0 + Init)./AUdur
X1,X0.m./Init,X1.b + Init,(X0.m + /(X1.b).X1)./Init./AUdur
)");
}

TEST_CASE("source and sink transitions") {
    const std::string_view chart = R"(
        input a, b, c
        graph G {
          step 1 step 2
          -> 1 : a + b    1 -> 2 : c    2 -> : /c
        })";
    CHECK(csv(chart, without_modes) == R"(variable,CAX,CDX,X
X1,a + b,X2,a + b + /X2.X1
X2,X1.c,X2./c,X1.c + /(X2./c).X2
)");
    CHECK(csv(chart, with_modes) == R"(variable,CAX,CDX,X
X1,(a + b)./Init,X2 + Init,(a + b + /X2.X1)./Init./AUdur
X2,X1.c./Init,X2./c + Init,(X1.c + /(X2./c).X2)./Init./AUdur
)");
}

TEST_CASE("a source transition that is always cleared makes CAX the constant 1") {
    CHECK(csv("input a graph G { step 1 step 2  -> 1 : 1  1 -> 2 : a }", with_modes) ==
          R"(variable,CAX,CDX,X
X1,/Init,X2 + Init,/Init./AUdur
X2,X1.a./Init,Init,(X1.a + X2)./Init./AUdur
)");
}

TEST_CASE("receptivities are spliced into the product; sums are parenthesised") {
    CHECK(csv(R"(
        input m, au, a, b
        graph G {
          initial 0 step 1 step 2
          0 -> 1 : ↑m . /au    1 -> 2 : a + b . m    2 -> 0 : (a ⊕ b) . 1
        })",
              without_modes) == R"(variable,CAX,CDX,X
X0,X2.(a ⊕ b),X1,X2.(a ⊕ b) + /X1.X0
X1,X0.↑m./au,X2,X0.↑m./au + /X2.X1
X2,X1.(a + b.m),X0,X1.(a + b.m) + /X0.X2
)");
}

TEST_CASE("a transition that is never cleared contributes nothing, whatever the form") {
    const std::string_view chart = R"(
        input a
        graph G {
          initial 0 step 1 step 2
          0 -> 1 : a    1 -> 2 : a . 0    1 -> 0 : /a    2 -> 0 : a
        })";
    CHECK(csv(chart, without_modes) == R"(variable,CAX,CDX,X
X0,X1./a + X2.a,X1,X1./a + X2.a + /X1.X0
X1,X0.a,X0,X0.a + /X0.X1
X2,0,X0,/X0.X2
)");
    CHECK(csv(chart, {.cdx = CdxForm::transition}) == R"(variable,CAX,CDX,X
X0,X1./a + X2.a + Init,X0.a./Init,(X1./a + X2.a + /(X0.a).X0 + Init)./AUdur
X1,X0.a./Init,X1./a + Init,(X0.a + /(X1./a).X1)./Init./AUdur
X2,0,X2.a + Init,/(X2.a).X2./Init./AUdur
)");
}

TEST_CASE("steps without transitions keep what they have") {
    CHECK(csv("graph G { initial 0 step 1 }", with_modes) == R"(variable,CAX,CDX,X
X0,Init,0,(X0 + Init)./AUdur
X1,0,Init,X1./Init./AUdur
)");
}

TEST_CASE("two transitions between the same steps are one term of CDX, two of CAX") {
    CHECK(csv("input a, b graph G { initial 0 step 1  0 -> 1 : a  0 -> 1 : b  1 -> 0 : 1 }",
              without_modes) == R"(variable,CAX,CDX,X
X0,X1,X1,X1 + /X1.X0
X1,X0.a + X0.b,X0,X0.a + X0.b + /X0.X1
)");
}

TEST_CASE("macro-steps: entry and exit in the conditions, the OR of the steps for their variable") {
    CHECK(csv(R"(
        input a, b, c
        output A
        graph G {
          initial 1 macro M2 = cycle step 3 : A if /XM2
          1 -> M2 : a    M2 -> 3 : b    3 -> 1 : 3s/XM2 + ↑XG
        }
        expansion cycle {
          entry E2 step 21 exit S2
          E2 -> 21 : 1    21 -> S2 : c
        })",
              without_modes) == R"(variable,CAX,CDX,X
X1,X3.(3s/(XE2 + X21 + XS2) + ↑(X1 + XE2 + X21 + XS2 + X3)),XE2,X3.(3s/(XE2 + X21 + XS2) + ↑(X1 + XE2 + X21 + XS2 + X3)) + /XE2.X1
XE2,X1.a,X21,X1.a + /X21.XE2
X21,XE2,XS2,XE2 + /XS2.X21
XS2,X21.c,X3,X21.c + /X3.XS2
X3,XS2.b,X1,XS2.b + /X1.X3
A,,,X3./(XE2 + X21 + XS2)
)");
}

TEST_CASE("transitions by step stand in table order") {
    const Grafcet grafcet = parsed(R"(
        input a
        graph G { initial 0 step 1 step 2
          0 -> 1, 2 : a    1 -> 2 : a    1, 2 -> 0 : a    -> 2 : a    2 -> : a })");
    const StepTransitions transitions = transitions_by_step(grafcet);
    const auto numbers = [](std::span<const TransitionId> ids) {
        std::vector<std::size_t> result;
        for (const TransitionId id : ids) result.push_back(index_of(id));
        return result;
    };
    using Numbers = std::vector<std::size_t>;
    CHECK(numbers(transitions.into_step(StepId{0})) == Numbers{2});
    CHECK(numbers(transitions.into_step(StepId{1})) == Numbers{0});
    CHECK(numbers(transitions.into_step(StepId{2})) == Numbers{0, 1, 3});
    CHECK(numbers(transitions.out_of_step(StepId{0})) == Numbers{0});
    CHECK(numbers(transitions.out_of_step(StepId{1})) == Numbers{1, 2});
    CHECK(numbers(transitions.out_of_step(StepId{2})) == Numbers{2, 4});
}

TEST_CASE("clearing and receptivity of a transition") {
    const Grafcet grafcet = parsed(R"(
        input a, b
        graph G0 { initial 0 step 9 : G{*}  0 -> 9 : a  9 -> 0 : b }
        graph G { initial 1 step 2 step 3  1, 2 -> 3 : a + b   3 -> 1, 2 : 1 })");
    const Equations equations = equations_from(grafcet, with_modes);
    const auto text = [&](ExprId id) {
        return write_expression(grafcet, equations.expressions, id);
    };
    CHECK(text(equations.transition_conditions[TransitionId{2}]) == "(a + b)./X9");
    CHECK(text(equations.clearing[TransitionId{2}]) == "X1.X2.(a + b)./X9");
    CHECK(text(equations.transition_conditions[TransitionId{3}]) == "/X9");
    CHECK(text(equations.clearing[TransitionId{3}]) == "X3./X9");
    CHECK(equations.frozen[GraphId{0}] == no_expr);
    CHECK(text(equations.frozen[GraphId{1}]) == "X9");
}

TEST_CASE("a synchronisation of many steps does not cost their square") {
    // 20 000 steps before one transition and 20 000 after it: the product is built once and shared.
    constexpr int width = 20'000;
    std::string before;
    std::string after;
    std::string steps;
    for (int i = 0; i < width; ++i) {
        const std::string comma = i == 0 ? "" : ",";
        before += comma + "b" + std::to_string(i);
        after += comma + "a" + std::to_string(i);
        steps += " initial b" + std::to_string(i) + " step a" + std::to_string(i);
    }
    const Grafcet grafcet = parsed("input go graph G {" + steps + "\n" + before + " -> " + after +
                                   " : go\n" + after + " -> " + before + " : 1 }");
    const Equations equations = equations_from(grafcet, with_modes);
    const StepEquation& first = equations.steps[StepId{1}];
    const StepEquation& last = equations.steps[StepId{2 * width - 1}];
    CHECK(first.cax == last.cax);
    Expressions pool = equations.expressions;
    CHECK(table_conditions(equations, StepId{1}, pool).cdx ==
          table_conditions(equations, StepId{2 * width - 1}, pool).cdx);
    CHECK(equations.expressions.operands(first.cax).size() == width + 1);
    CHECK(equations.expressions.size() < 3 * width);
}

}  // namespace grafwire::testing
