// Tables of assignment, and how they meet a GRAFCET.

#include <doctest/doctest.h>

#include "random/read_text.h"
#include "s7/machine/binding.h"
#include "support/listings.h"
#include "trace/trace.h"

namespace grafwire::testing {

using namespace s7;

TEST_CASE("an assignment reads back as it was written") {
    const std::string text = R"(E0.0   = v0
A0.0   = "V+"
V21.0  = X10
V81.0  = (10)
VW100  = pieces
Z3     = "Compteur à pièces"
)";
    CHECK(write_io_assignment(read_assignment(text)) == text);
    CHECK(write_io_assignment(
              read_assignment("# Both spellings\nI0.0=v0 # an input\n\nQ0.1 = b\n")) ==
          "E0.0   = v0\nA0.1   = b\n");
    for (const std::string name : {"positioning-axis", "manipulator", "manipulator-modes"}) {
        const IoAssignment io = read_assignment(example_text("s7-200/" + name + ".io"));
        const std::string written = write_io_assignment(io);
        CHECK(write_io_assignment(read_assignment(written)) == written);
    }
}

TEST_CASE("what is wrong with an assignment, in one go") {
    const SourceFile source{"test.io", R"(E0.8 = v0
E0.0 v1
A0.0 = "V+
E0.1 = h0
A0.1 = h0
V10.3 = X1
VW10 = pieces
A0.2 = H+
A0.3 =
)"};
    Diagnostics diagnostics;
    CHECK_FALSE(parse_io_assignment(source, diagnostics));
    CHECK(
        format_diagnostics(diagnostics, source) ==
        R"(test.io:1:1: error: 'E0.8' is not an address: write one such as E0.4, A0.0, V21.0 or VW100 (bits are 0 … 7)
E0.8 = v0
^
test.io:2:6: error: expected '=' and a name after the address, as in 'E0.0 = v0'
E0.0 v1
     ^
test.io:3:8: error: the name is not ended on its line
A0.0 = "V+
       ^
test.io:5:8: error: 'h0' has an address already
A0.1 = h0
       ^
test.io:4:8: note: it is here
E0.1 = h0
       ^
test.io:7:1: error: VW10 is taken, wholly or in part
VW10 = pieces
^
test.io:6:1: note: by this address
V10.3 = X1
^
test.io:8:9: error: nothing may follow the name but a comment (#)
A0.2 = H+
        ^
test.io:9:7: error: expected a name (quoted, if it holds other characters than letters, digits and '_'), or a transition's label in parentheses
A0.3 =
      ^
)");
}

TEST_CASE("an assignment meets a GRAFCET") {
    const auto grafcet = read_grafcet(R"(
        input a
        output lamp
        var m
        counter c : 0..9
        graph G {
          initial 0 : lamp
          step 1 : c := c + 1, set m
          (t) 0 -> 1 : a
          1 -> 0 : /a
        })");
    REQUIRE(grafcet);
    const auto messages = [&](const std::string& text) {
        Diagnostics diagnostics;
        const IoAssignment io = read_assignment(text);
        const auto binding = bind(*grafcet, io, diagnostics);
        CHECK(binding.has_value() != diagnostics.has_errors());
        return format_diagnostics(diagnostics, {"test.io", text});
    };
    const std::string whole =
        "E0.0 = a\nE0.1 = Init\nA0.0 = lamp\nV20.0 = X0\nV20.1 = X1\nM0.0 = m\nVW100 = c\nV80.0 = "
        "(t)\nV0.0 = G\n";
    CHECK(messages(whole) == "");
    CHECK(messages("V20.0 = X0\nV20.1 = X11\nA0.0 = a\nV100.0 = c\n") ==
          R"(test.io: error: input 'a' of the GRAFCET has no address
test.io: error: step 'X1' of the GRAFCET has no address
test.io: error: output 'lamp' of the GRAFCET has no address
test.io:2:1: error: the GRAFCET has no 'X11'; did you mean 'X1'?
V20.1 = X11
^
test.io:3:1: error: A0.0 is the address of 'a', which needs an input bit such as E0.4
A0.0 = a
^
test.io:4:1: error: V100.0 is the address of 'c', which needs a word such as VW100
V100.0 = c
^
)");
}

TEST_CASE("columns without a GRAFCET") {
    const Grafcet names =
        names_of(read_assignment("A0.0 = lamp\nE0.0 = a\nE0.1 = Init\nV20.0 = X0\nV80.0 = "
                                 "(t)\nV0.1 = G\nVW100 = c\nM0.0 = m\n"));
    std::string columns;
    for (const auto& column : empty_trace(names).columns) columns += column.name + " ";
    CHECK(columns == "a Init AUdur AUdoux X0 lamp m c ");
    const IoAssignment own =
        addresses_of(read_listing("NETWORK1\nLD E0.4\n= A1.0\nMOVB EB2 VB0\nS A0.6 K3\nMEND\n"));
    CHECK(write_io_assignment(own) ==
          "E0.4   = \"E0.4\"\nE2.0   = \"E2.0\"\nE2.1   = \"E2.1\"\nE2.2   = \"E2.2\"\n"
          "E2.3   = \"E2.3\"\nE2.4   = \"E2.4\"\nE2.5   = \"E2.5\"\nE2.6   = \"E2.6\"\n"
          "E2.7   = \"E2.7\"\nA0.6   = \"A0.6\"\nA0.7   = \"A0.7\"\nA1.0   = \"A1.0\"\n");
}

}  // namespace grafwire::testing
