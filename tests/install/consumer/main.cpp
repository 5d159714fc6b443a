// A program of somebody else's: reads a chart, makes a netlist of it and checks that.
#include <cstdio>

#include "check/check_equivalence.h"
#include "equations/equations.h"
#include "grafcet/parse_grafcet.h"
#include "netlist/styles/netlist_from.h"
#include "simulate/simulator.h"

int main() {
    const grafwire::SourceFile source{"sequence.grafcet", R"(
grafcet sequence
input m, a, b
graph G {
  initial 0
  step 1
  step 2
  0 -> 1 : m
  1 -> 2 : a
  2 -> 0 : b
}
)"};
    grafwire::Diagnostics diagnostics;
    const auto grafcet = grafwire::parse_grafcet(source, diagnostics);
    if (!grafcet) {
        std::fputs(grafwire::format_diagnostics(diagnostics, source).c_str(), stderr);
        return 2;
    }
    grafwire::Equations equations = grafwire::equations_from(*grafcet, {});
    const auto netlist = grafwire::netlist_from(equations, grafwire::Style::nand, diagnostics);
    if (!netlist) return 2;
    const grafwire::CheckResult result = grafwire::check_equivalence(
        *grafcet, *netlist, grafwire::unit_delays(*netlist), grafwire::CheckOptions{});
    std::printf("%zu steps, %s\n", grafcet->steps.size(),
                result.verdict == grafwire::Verdict::equivalent ? "equivalent" : "not equivalent");
}
