// The tables of the course "Mise en œuvre du GRAFCET", sections 1.3, 1.4, 2.2 and 3.1.

#include "equations/parsed.h"

namespace grafwire::testing {

TEST_CASE("selection of sequence: divergence") {
    CHECK(csv(R"(
        input a, x, z
        graph G {
          initial 6 step 7 step 10 step 11 step 20 step 21
          6 -> 7 : a    7 -> 10 : x    7 -> 20 : z    10 -> 11 : 1    20 -> 21 : 1
        })",
              without_modes) == R"(variable,CAX,CDX,X
X6,0,X7,/X7.X6
X7,X6.a,X10 + X20,X6.a + /(X10 + X20).X7
X10,X7.x,X11,X7.x + /X11.X10
X11,X10,0,X10 + X11
X20,X7.z,X21,X7.z + /X21.X20
X21,X20,0,X20 + X21
)");
}

TEST_CASE("selection of sequence: convergence") {
    CHECK(csv(R"(
        input b, c, d, e, f
        graph G {
          initial 30 step 31 initial 47 step 48 step 6 step 7
          30 -> 31 : b    47 -> 48 : c    31 -> 6 : d    48 -> 6 : e    6 -> 7 : f
        })",
              without_modes) == R"(variable,CAX,CDX,X
X30,0,X31,/X31.X30
X31,X30.b,X6,X30.b + /X6.X31
X47,0,X48,/X48.X47
X48,X47.c,X6,X47.c + /X6.X48
X6,X31.d + X48.e,X7,X31.d + X48.e + /X7.X6
X7,X6.f,0,X6.f + X7
)");
}

TEST_CASE("parallel sequences: divergence") {
    CHECK(csv(R"(
        input a, x
        graph G {
          initial 6 step 7 step 10 step 11 step 20 step 21
          6 -> 7 : a    7 -> 10, 20 : x    10 -> 11 : 1    20 -> 21 : 1
        })",
              without_modes) == R"(variable,CAX,CDX,X
X6,0,X7,/X7.X6
X7,X6.a,X10.X20,X6.a + /(X10.X20).X7
X10,X7.x,X11,X7.x + /X11.X10
X11,X10,0,X10 + X11
X20,X7.x,X21,X7.x + /X21.X20
X21,X20,0,X20 + X21
)");
}

TEST_CASE("parallel sequences: convergence") {
    CHECK(csv(R"(
        input b, c, d
        graph G {
          initial 30 step 31 initial 47 step 48 step 6 step 7
          30 -> 31 : b    47 -> 48 : c    31, 48 -> 6 : d    6 -> 7 : 1
        })",
              without_modes) == R"(variable,CAX,CDX,X
X30,0,X31,/X31.X30
X31,X30.b,X6,X30.b + /X6.X31
X47,0,X48,/X48.X47
X48,X47.c,X6,X47.c + /X6.X48
X6,X31.X48.d,X7,X31.X48.d + /X7.X6
X7,X6,0,X6 + X7
)");
}

TEST_CASE("single sequence with modes") {
    CHECK(csv(R"(
        input m, a, b
        graph G {
          initial 0 step 1 step 2
          0 -> 1 : m    1 -> 2 : a    2 -> 0 : b
        })",
              with_modes) == R"(variable,CAX,CDX,X
X0,X2.b + Init,X1./Init,(X2.b + /X1.X0 + Init)./AUdur
X1,X0.m./Init,X2 + Init,(X0.m + /X2.X1)./Init./AUdur
X2,X1.a./Init,X0 + Init,(X1.a + /X0.X2)./Init./AUdur
)");
}

TEST_CASE("exercise of nine steps with modes") {
    CHECK(csv(R"(
        input m, a, b, c, d1, d2, e, f
        graph G {
          initial 1 step 2 step 3 step 4 step 5 step 6 step 7 step 8 step 9
          1 -> 2, 5 : m
          2 -> 3 : b    3 -> 4 : c
          5 -> 6 : a    6 -> 7 : d1    6 -> 9 : d2    7 -> 8 : e    9 -> 8 : f
          4, 8 -> 1 : 1
        })",
              with_modes) == R"(variable,CAX,CDX,X
X1,X4.X8 + Init,X2.X5./Init,(X4.X8 + /(X2.X5).X1 + Init)./AUdur
X2,X1.m./Init,X3 + Init,(X1.m + /X3.X2)./Init./AUdur
X3,X2.b./Init,X4 + Init,(X2.b + /X4.X3)./Init./AUdur
X4,X3.c./Init,X1 + Init,(X3.c + /X1.X4)./Init./AUdur
X5,X1.m./Init,X6 + Init,(X1.m + /X6.X5)./Init./AUdur
X6,X5.a./Init,X7 + X9 + Init,(X5.a + /(X7 + X9).X6)./Init./AUdur
X7,X6.d1./Init,X8 + Init,(X6.d1 + /X8.X7)./Init./AUdur
X8,(X7.e + X9.f)./Init,X1 + Init,(X7.e + X9.f + /X1.X8)./Init./AUdur
X9,X6.d2./Init,X8 + Init,(X6.d2 + /X8.X9)./Init./AUdur
)");
}

TEST_CASE("a continuous action of the course") {
    CHECK(csv(R"(
        input m
        output A
        graph G { initial 3 : A  step 4  3 -> 4 : m  4 -> 3 : /m })",
              with_modes) == R"(variable,CAX,CDX,X
X3,X4./m + Init,X4./Init,(X4./m + /X4.X3 + Init)./AUdur
X4,X3.m./Init,X3 + Init,(X3.m + /X3.X4)./Init./AUdur
A,,,X3./AUdoux
)");
}

}  // namespace grafwire::testing
