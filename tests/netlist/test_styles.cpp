#include "netlist/styles/messages.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

const std::string sequence = R"(
grafcet sequence
input m, a, b
output lamp
graph G {
  initial 0
  step 1 : lamp
  step 2
  0 -> 1 : m
  1 -> 2 : a
  2 -> 0 : b
}
)";

const std::string ports = R"(netlist sequence
input m
input a
input b
output X0 = X0
output X1 = X1
output X2 = X2
output lamp = lamp
)";

std::string text_in(Style style) {
    const Grafcet grafcet = grafcet_of(sequence);
    return write_netlist_text(netlist_of(grafcet, style, false));
}

}  // namespace

TEST_CASE("phase modules of AND, OR and NOT gates") {
    CHECK(text_in(Style::gates) == ports + R"(module X0 # X0 = X2.b + /X1.X0
  T2$clear = and(X2, b)
  X1$not = not(X1)
  X0$hold = and(X1$not, X0)
  X0 = or(T2$clear, X0$hold)
module X1 # X1 = X0.m + /X2.X1
  T0$clear = and(X0, m)
  X2$not = not(X2)
  X1$hold = and(X2$not, X1)
  X1 = or(T0$clear, X1$hold)
module X2 # X2 = X1.a + /X0.X2
  T1$clear = and(X1, a)
  X0$not = not(X0)
  X2$hold = and(X0$not, X2)
  X2 = or(T1$clear, X2$hold)
module lamp # lamp = X1
  lamp = buf(X1)
initially X0 = 1
initially X1 = 0
initially X2 = 0
)");
}

TEST_CASE("latches of NAND gates") {
    CHECK(text_in(Style::nand) == ports + R"(module X0 # X0 = X2.b + /X1.X0
  X0$set2 = nand(X2, b)
  X0$reset0 = nand(X1, X0$set2)
  X0 = nand(X0$set2, X0$q)
  X0$q = nand(X0$reset0, X0)
module X1 # X1 = X0.m + /X2.X1
  X1$set0 = nand(X0, m)
  X1$reset0 = nand(X2, X1$set0)
  X1 = nand(X1$set0, X1$q)
  X1$q = nand(X1$reset0, X1)
module X2 # X2 = X1.a + /X0.X2
  X2$set1 = nand(X1, a)
  X2$reset0 = nand(X0, X2$set1)
  X2 = nand(X2$set1, X2$q)
  X2$q = nand(X2$reset0, X2)
module lamp # lamp = X1
  lamp = buf(X1)
initially X0$q = 0
initially X0 = 1
initially X1$q = 1
initially X1 = 0
initially X2$q = 1
initially X2 = 0
)");
}

TEST_CASE("latches of NOR gates") {
    CHECK(text_in(Style::nor) == ports + R"(module X0 # X0 = X2.b + /X1.X0
  X1$not = not(X1)
  X0$set2 = and(X2, b, X1$not)
  X0 = nor(X1, X0$q)
  X0$q = nor(X0$set2, X0)
module X1 # X1 = X0.m + /X2.X1
  X2$not = not(X2)
  X1$set0 = and(X0, m, X2$not)
  X1 = nor(X2, X1$q)
  X1$q = nor(X1$set0, X1)
module X2 # X2 = X1.a + /X0.X2
  X0$not = not(X0)
  X2$set1 = and(X1, a, X0$not)
  X2 = nor(X0, X2$q)
  X2$q = nor(X2$set1, X2)
module lamp # lamp = X1
  lamp = buf(X1)
initially X0$q = 0
initially X0 = 1
initially X1$q = 1
initially X1 = 0
initially X2$q = 1
initially X2 = 0
)");
}

TEST_CASE("flip-flops on a common clock") {
    const std::string text = text_in(Style::clocked);
    CHECK(text.find("input b\ninput clk\noutput X0 = X0\n") != std::string::npos);
    CHECK(text.find("module T0\n  T0$clear = and(X0, m)\n") != std::string::npos);
    CHECK(text.find("  X0 = dff(X0$next, clk) initially 1\n") != std::string::npos);
    CHECK(text.find("  X1 = dff(X1$next, clk) initially 0\n") != std::string::npos);
    CHECK(text.find("module lamp # lamp = X1\n  lamp = buf(X1)\n") != std::string::npos);
}

TEST_CASE("in gates what an order clears and what it lists come through as many gates") {
    // One would otherwise be ahead of the other, and the listed step fall for that long.
    const std::string forced = "input a, b graph G1 { initial 0 step 1 step 2 0 -> 1 : a } ";
    const auto has = [&](const std::string& orders, const std::string& line) {
        const Grafcet grafcet = grafcet_of(forced + orders);
        const std::string text = write_netlist_text(netlist_of(grafcet, Style::gates, false));
        CHECK(text.find("\n  " + line + "\n") != std::string::npos);
    };
    has("graph G2 { initial 10 : G1{1} step 11 10 -> 11 : b }", "X1$free = or(X10$not, X10$buf)");
    const std::string three =
        "graph G2 { initial 10 : G1{1} step 11 : G1{2} step 12 : G1{2} 10 -> 11 : b 11 -> 12 : a }";
    has(three, "X0$1 = or(X10, X11, X12)");
    has(three, "X1$free = or(X0$1$not, X10$buf$buf)");
    has(three, "X2$1 = or(X11, X12)");
    has(three, "X2$free = or(X0$1$not, X2$1$buf)");
}

TEST_CASE("inner nets stay clear of every name of the GRAFCET that looks like theirs") {
    for (const std::string what : {"input", "output", "var"}) {
        const std::string name = what == "output" ? " : \"X0$hold\"" : "";
        const Grafcet grafcet = grafcet_of("input a " + what + " \"X0$hold\" graph G { initial 0" +
                                           name + " step 1 0 -> 1 : a 1 -> 0 : /a }");
        const Netlist netlist = netlist_of(grafcet, Style::gates, false);
        CHECK(fault_of(netlist) == "");
        CHECK(write_netlist_text(netlist).find("  X0$hold$ = ") != std::string::npos);
    }
}

TEST_CASE("a port may have another name than its net") {
    const Grafcet grafcet = grafcet_of(sequence);
    Netlist netlist = netlist_of(grafcet, Style::gates, false);
    netlist.outputs.push_back({"copy", netlist.outputs[0].net});
    CHECK(write_netlist_text(netlist).find("output copy = X0\n") != std::string::npos);
}

TEST_CASE("the control inputs are ports with modes only") {
    const Grafcet grafcet = grafcet_of(sequence);
    for (const StyleRow& row : style_table) {
        const Netlist with = netlist_of(grafcet, row.style, true);
        const Netlist without = netlist_of(grafcet, row.style, false);
        CHECK(with.has_modes);
        CHECK_FALSE(without.has_modes);
        REQUIRE(with.inputs.size() == without.inputs.size() + 3);
        CHECK(with.inputs[3].name == "Init");
        CHECK(with.inputs[4].name == "AUdur");
        CHECK(with.inputs[5].name == "AUdoux");
        CHECK(with.is_clocked() == (row.style == Style::clocked));
        CHECK(with.step_count == 3);
        CHECK(fault_of(with).empty());
        CHECK(fault_of(without).empty());
    }
}

TEST_CASE("every gate says what it was made for") {
    const Grafcet grafcet = grafcet_of(sequence);
    const Netlist netlist = netlist_of(grafcet, Style::nand);
    std::size_t of_step_1 = 0;
    for (const Cell& cell : netlist.cells) {
        const Origin& origin = netlist.origin_of(cell);
        if (origin.kind != Origin::Kind::step || origin.name != "1") continue;
        ++of_step_1;
        CHECK(origin.where.line == 7);
    }
    CHECK(of_step_1 >= 4);
    for (std::size_t i = 0; i < netlist.cells.size(); ++i) {
        const CellId id = netlist.cells.id_at(i);
        if (netlist.names[netlist.cells[id].output] != "X1$q") continue;
        CHECK(cell_description(netlist, id) == "NAND gate X1$q of step 1");
    }
}

TEST_CASE("asynchronous styles refuse counters, the clocked one does not") {
    const Grafcet grafcet = grafcet_of(R"(
counter c : 0..3
counter d : 0..3
graph G { initial 0 : c := c + 1
  0 -> 0 : [d = 0] }
)");
    for (const StyleRow& row : style_table) {
        const Equations equations = equations_from(grafcet, {row.default_cdx, true});
        Diagnostics diagnostics;
        const auto netlist = netlist_from(grafcet, equations, row.style, diagnostics);
        CHECK(netlist.has_value() == (row.style == Style::clocked));
        if (netlist) continue;
        REQUIRE(diagnostics.error_count() == 2);
        CHECK(diagnostics.items()[0].code == code::unsupported_by_style);
        CHECK(diagnostics.items()[0].where.line == 2);
        CHECK(diagnostics.items()[1].where.line == 3);
        CHECK(diagnostics.items()[0].message.english ==
              "the " + std::string(row.name) +
                  " style has no registers for the counter 'c'; use --style clocked");
    }
}

}  // namespace grafwire::testing
