#include "check/check_equivalence.h"
#include "check/compare_ports.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

const std::string two_inputs = R"(
input a, b
output lamp
graph G { initial 0 : lamp step 1
  0 -> 1 : a . 2s/X0
  1 -> 0 : b }
)";

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("ports that fit") {
    const Grafcet grafcet = grafcet_of(two_inputs);
    for (const StyleRow& row : style_table) {
        for (const bool modes : {true, false}) {
            const PortComparison ports =
                compare_ports(grafcet, netlist_of(grafcet, row.style, modes));
            CHECK(ports.fits());
            CHECK(ports.can_compare());
            CHECK(write_port_table(ports, Language::english).empty());
        }
    }
}

TEST_CASE("ports that are missing or too many") {
    const Grafcet grafcet = grafcet_of(two_inputs);
    const Netlist netlist = netlist_of(grafcet_of(R"(
input a, c
output lamp, bell
graph G { initial 0 : lamp step 2 : bell
  0 -> 2 : a . 2s/X0
  2 -> 0 : c }
)"),
                                       Style::nand);
    const PortComparison ports = compare_ports(grafcet, netlist);
    CHECK(ports.missing_inputs == Names{"b"});
    CHECK(ports.extra_inputs == Names{"c"});
    CHECK(ports.missing_outputs == Names{"X1"});
    CHECK(ports.extra_outputs == Names{"X2", "bell"});
    CHECK(ports.unrelated_timers.empty());
    CHECK_FALSE(ports.fits());
    CHECK_FALSE(ports.can_compare());
    for (const Language language : {Language::english, Language::french}) {
        const std::string table = write_port_table(ports, language);
        for (const char* name : {"b", "c", "X1", "X2", "bell"}) {
            CHECK(table.find(name) != std::string::npos);
        }
    }
    CHECK(write_port_table(ports, Language::english) != write_port_table(ports, Language::french));
}

TEST_CASE("clk is the clock among the inputs of a clocked netlist, and anywhere else too many") {
    const Grafcet grafcet = grafcet_of(two_inputs);
    Netlist clocked = netlist_of(grafcet, Style::clocked);
    CHECK(compare_ports(grafcet, clocked).extra_inputs.empty());
    clocked.outputs.push_back({"clk", clocked.outputs[0].net});
    CHECK(compare_ports(grafcet, clocked).extra_outputs == Names{"clk"});
    const Netlist gates =
        netlist_of(grafcet_of("input clk output lamp graph G { initial 0 : lamp step 1 0 -> 1 : "
                              "clk . 2s/X0 }"),
                   Style::gates);
    CHECK(compare_ports(grafcet, gates).extra_inputs == Names{"clk"});
}

TEST_CASE("an input that is not wired does not prevent the comparison") {
    const Grafcet grafcet = grafcet_of(two_inputs);
    const Netlist netlist = netlist_of(grafcet_of(R"(
input a
output lamp
graph G { initial 0 : lamp step 1
  0 -> 1 : a . 2s/X0
  1 -> 0 : /a }
)"),
                                       Style::nand);
    const PortComparison ports = compare_ports(grafcet, netlist);
    CHECK(ports.missing_inputs == Names{"b"});
    CHECK(ports.can_compare());
    CHECK_FALSE(ports.fits());
}

TEST_CASE("some control inputs but not all") {
    const Grafcet grafcet = grafcet_of(two_inputs);
    Netlist netlist = netlist_of(grafcet, Style::gates);
    for (Port& port : netlist.inputs) {
        if (port.name == "AUdur") port.name = "stop";
    }
    const PortComparison ports = compare_ports(grafcet, netlist);
    CHECK(ports.missing_inputs == Names{"AUdur"});
    CHECK(ports.extra_inputs == Names{"stop"});
}

TEST_CASE("timers that do not say which time condition they are") {
    const Grafcet grafcet = grafcet_of(two_inputs);
    Netlist netlist = netlist_of(grafcet, Style::gates);
    for (const std::uint32_t ordinal : {1U, Timing::no_ordinal}) {
        for (Timing& timing : netlist.timings) timing.ordinal = ordinal;
        const PortComparison ports = compare_ports(grafcet, netlist);
        CHECK(ports.unrelated_timers.size() == 1);
        CHECK_FALSE(ports.can_compare());
    }
}

TEST_CASE("a netlist from elsewhere is brought into the order of the GRAFCET") {
    const Grafcet grafcet = grafcet_of(two_inputs);
    Netlist netlist = netlist_of(grafcet, Style::nand);
    std::swap(netlist.outputs.front(), netlist.outputs.back());
    netlist.step_count = 0;
    netlist.has_modes = false;
    adopt_ports(grafcet, netlist);
    CHECK(netlist.has_modes);
    CHECK(netlist.step_count == 2);
    REQUIRE(netlist.outputs.size() == 3);
    CHECK(netlist.outputs[0].name == "X0");
    CHECK(netlist.outputs[1].name == "X1");
    CHECK(netlist.outputs[2].name == "lamp");
    CHECK(check_equivalence(grafcet, netlist, {}).verdict ==
          check_equivalence(grafcet, netlist_of(grafcet, Style::nand), {}).verdict);
}

}  // namespace grafwire::testing
