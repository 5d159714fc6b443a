#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "gates.h"
#include "schedule/delays_text.h"

namespace grafwire::testing {

namespace {

std::vector<std::string> named_in(std::string_view text) {
    const Netlist netlist = some_gates();
    std::vector<std::string> names;
    for (const Wire& wire : wires_named_in({"t.delays", std::string(text)}, netlist)) {
        names.push_back(wire_name(netlist, wire));
    }
    return names;
}

}  // namespace

TEST_CASE("wires that a text names are found in any section, with quotes or without") {
    CHECK(named_in("X1$set 3\n* 2\n").empty());
    const std::vector<std::string> expected = {"a->X1$q", "X1$q->two words"};
    CHECK(named_in("a->X1$q 3 # a->X1$set\nat 20ms\n \"X1$q->two words\" 4\na->X1$q 5\n") ==
          expected);
    CHECK(named_in("b->X1$q 3\n-> 4\n").empty());
}

TEST_CASE("wires are written whatever they take, and read back") {
    const Netlist netlist = some_gates();
    const SourceFile source{"t.delays", "a->X1$q 1\nX1$set 3\n"};
    const Netlist wired = with_wire_delays(netlist, wires_named_in(source, netlist));
    Diagnostics diagnostics;
    const auto schedule = read_delays(source, wired, diagnostics);
    REQUIRE(schedule);
    CHECK(write_delays(*schedule, wired) == "X1$set 3\na->X1$q 1\n");
}

}  // namespace grafwire::testing
