#include "equations/parsed.h"

namespace grafwire::testing {

namespace {

// The minimised form of one expression over the inputs a to l and the step X1.
std::string minimal(const std::string& expression) {
    const Grafcet grafcet = parsed(
        "input a, b, c, d, e, f, g, h, i, j, k, l\n"
        "graph G { initial 1 step 2  1 -> 2 : " +
        expression + " }");
    const Equations equations = equations_from(grafcet, without_modes);
    Expressions pool = equations.expressions;
    const ExprId id = minimised(pool, equations.transition_conditions[TransitionId{0}]);
    return id == no_expr ? "none" : write_expression(grafcet, pool, id);
}

}  // namespace

TEST_CASE("absorption, adjacency and consensus") {
    CHECK(minimal("a + a.b") == "a");
    CHECK(minimal("a.b + a./b") == "a");
    CHECK(minimal("a.b + /a.c + b.c") == "a.b + /a.c");
    CHECK(minimal("(a + b).(a + c)") == "a + b.c");
    CHECK(minimal("a + /a.b") == "a + b");
    CHECK(minimal("a ⊕ b") == "a./b + /a.b");
    CHECK(minimal("/(a.b)") == "/a + /b");
}

TEST_CASE("constants") {
    CHECK(minimal("a + /a") == "1");
    CHECK(minimal("a./a") == "0");
    CHECK(minimal("0") == "0");
    CHECK(minimal("1") == "1");
}

TEST_CASE("edges, time conditions and comparisons are atoms") {
    CHECK(minimal("↑a.X1 + ↑a./X1") == "↑a");
    CHECK(minimal("3s/X1.a + 3s/X1") == "3s/X1");
    CHECK(minimal("a + ↑a") == "a + ↑a");
}

TEST_CASE("a cyclic core has a smallest cover") {
    // Six prime implicants in a circle, of which three are needed.
    CHECK(minimal("/a./b + /b.c + b./c + a.b + /a./c + a.c") == "a.b + /a./c + /b.c");
}

TEST_CASE("don't-care free four-variable example of McCluskey's kind") {
    // Rows 4, 8, 9, 10, 11, 12, 14, 15 of a, b, c, d (a is the highest bit).
    CHECK(minimal("/a.b./c./d + a./b./c./d + a./b./c.d + a./b.c./d + a./b.c.d + a.b./c./d + "
                  "a.b.c./d + a.b.c.d") == "a./b + a.c + b./c./d");
}

TEST_CASE("ten atoms are minimised, eleven are not") {
    CHECK(minimal("a.b.c.d.e.f.g.h.i.j + a.b.c.d.e.f.g.h.i./j") == "a.b.c.d.e.f.g.h.i");
    CHECK(minimal("a.b.c.d.e.f.g.h.i.j.k") == "none");
    CHECK(minimal("a ⊕ b ⊕ c ⊕ d ⊕ e ⊕ f ⊕ g ⊕ h ⊕ i ⊕ j ⊕ k ⊕ a").size() > 1000);
}

}  // namespace grafwire::testing
