#include "equations/parsed.h"

namespace grafwire::testing {

namespace {

constexpr std::string_view manipulator = R"(
grafcet manipulator
input  v0, v1, h0, h1, dcy, au
output "V+", "H-", "H+"
graph G0 {
  initial 0 : G1{}
  step 1    : G1{10}
  step 2
  step 3    : G1{*}
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
  (13) 13 -> 10 : 5s/X13
})";

}  // namespace

TEST_CASE("forcing acts outside the memory, freezing on the receptivities") {
    CHECK(csv(manipulator, with_modes) == R"csv(variable,CAX,CDX,X
X0,X3./au + Init,X1./Init,(X3./au + /X1.X0 + Init)./AUdur
X1,X0.↑dcy./au./Init,X2 + Init,(X0.↑dcy./au + /X2.X1)./Init./AUdur
X2,X1./Init,X3 + Init,(X1 + /X3.X2)./Init./AUdur
X3,X2.au./Init,X0 + Init,(X2.au + /X0.X3)./Init./AUdur
X10,X13 . 5s/X13./X3 + Init,X11./Init,((X13 . 5s/X13./X3 + /X11.X10 + Init)./(X0 + X1) + X1)./AUdur
X11,X10.h1./X3./Init,X12 + Init,(X10.h1./X3 + /X12.X11)./Init./(X0 + X1)./AUdur
X12,X11.v1./X3./Init,X13 + Init,(X11.v1./X3 + /X13.X12)./Init./(X0 + X1)./AUdur
X13,X12.h0./X3./Init,X10 + Init,(X12.h0./X3 + /X10.X13)./Init./(X0 + X1)./AUdur
V+,,,X11./AUdoux
H-,,,X12.v0./AUdoux
H+,,,X10./AUdoux
)csv");
}

TEST_CASE("several orders on one graph are summed; INIT lists the initial steps") {
    CHECK(csv(R"(
        input a
        graph G0 {
          initial 0 : G1{INIT}   step 1 : G1{11}   step 2 : G1{*}   step 3 : G1{10, 11}   step 4 : G1{*}
          0 -> 1 : a   1 -> 2 : a   2 -> 3 : a   3 -> 4 : a   4 -> 0 : a
        }
        graph G1 { initial 10 step 11 step 12   10 -> 11 : a   11 -> 12 : a   12 -> 10 : a })",
              without_modes)
              .substr(std::string("variable,CAX,CDX,X\n"
                                  "X0,X4.a,X1,X4.a + /X1.X0\nX1,X0.a,X2,X0.a + /X2.X1\n"
                                  "X2,X1.a,X3,X1.a + /X3.X2\nX3,X2.a,X4,X2.a + /X4.X3\n"
                                  "X4,X3.a,X0,X3.a + /X0.X4\n")
                          .size()) ==
          R"(X10,X12.a./(X2 + X4),X11,(X12.a./(X2 + X4) + /X11.X10)./(X0 + X1 + X3) + X0 + X3
X11,X10.a./(X2 + X4),X12,(X10.a./(X2 + X4) + /X12.X11)./(X0 + X1 + X3) + X1 + X3
X12,X11.a./(X2 + X4),X10,(X11.a./(X2 + X4) + /X10.X12)./(X0 + X1 + X3)
)");
}

TEST_CASE("in the transition form a frozen transition does not deactivate either") {
    const std::string report = csv(manipulator, {.cdx = CdxForm::transition, .modes = false});
    CHECK(report.find("X11,X10.h1./X3,X11.v1./X3,"
                      "(X10.h1./X3 + /(X11.v1./X3).X11)./(X0 + X1)\n") != std::string::npos);
}

TEST_CASE(
    "enclosed graphs: the enclosing step gates every step, links are added on its activation") {
    CHECK(csv(R"(
        input a
        graph G2 { initial 50 encloses G3{60}  step 51   50 -> 51 : a   51 -> 50 : /a }
        graph G3 { initial 60 step 61   60 -> 61 : a   61 -> 60 : /a })",
              with_modes) == R"(variable,CAX,CDX,X
X50,X51./a + Init,X51./Init,(X51./a + /X51.X50 + Init)./AUdur
X51,X50.a./Init,X50 + Init,(X50.a + /X50.X51)./Init./AUdur
X60,X61./a + Init,X61./Init,((X61./a + /X61.X60 + Init).X50 + ↑X50./Init)./AUdur
X61,X60.a./Init,X60 + Init,(X60.a + /X60.X61)./Init.X50./AUdur
)");
}

TEST_CASE("orders on an enclosed graph, freezing included, hold back its activation links") {
    const std::string report = csv(R"(
        input a
        graph G1 { initial 1 : G3{61}  step 2 : G3{*}  step 3   1 -> 2 : a   2 -> 3 : a   3 -> 1 : a }
        graph G2 { step 50 encloses G3{60, 61}  initial 51   50 -> 51 : a   51 -> 50 : /a }
        graph G3 { step 60 step 61   60 -> 61 : a   61 -> 60 : /a })",
                                   without_modes);
    CHECK(report.find("\nX60,X61./a./X2,X61,"
                      "(X61./a./X2 + /X61.X60)./X1.X50 + ↑X50./(X1 + X2)\n"
                      "X61,X60.a./X2,X60,"
                      "((X60.a./X2 + /X60.X61)./X1 + X1).X50 + ↑X50./(X1 + X2)\n") !=
          std::string::npos);
}

TEST_CASE("the steps of expansions are forced and enclosed with their graph") {
    const Grafcet grafcet = parsed(R"(
        input a
        graph G1 { initial 1 : G3{}  step 2   1 -> 2 : a   2 -> 1 : a }
        graph G2 { step 50 encloses G3{60}  initial 51   50 -> 51 : a   51 -> 50 : /a }
        graph G3 { step 60 macro M = outer   60 -> M : a   M -> 60 : /a }
        expansion outer { entry E macro N = inner exit S   E -> N : a   N -> S : a }
        expansion inner { entry F exit T   F -> T : a })");
    const Equations equations = equations_from(grafcet, with_modes);
    const Graph& enclosed = grafcet.graphs[GraphId{2}];
    CHECK(enclosed.steps.count == 5);
    for (const StepId id : enclosed.steps) {
        const StepEquation& step = equations.steps[id];
        CHECK(write_expression(grafcet, equations.expressions, step.forced_off) == "X1");
        CHECK(step.forced_on == no_expr);
        CHECK(write_expression(grafcet, equations.expressions, step.enclosing) == "X50");
        CHECK((step.link == no_expr) == (index_of(id) > enclosed.steps.first));
    }
    CHECK(equations.steps[StepId{0}].forced_off == no_expr);
    CHECK(equations.steps[StepId{0}].enclosing == no_expr);
}

}  // namespace grafwire::testing
