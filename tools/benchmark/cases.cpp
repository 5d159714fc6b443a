#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "check/check_equivalence.h"
#include "check/report.h"
#include "child.h"
#include "equations/equations.h"
#include "grafcet/parse_grafcet.h"
#include "netlist/styles/styles.h"
#include "sections.h"
#include "simulate/simulator.h"

namespace bench {

namespace {

using namespace grafwire;

void measure_example(const std::string& name, Style style) {
    std::stringstream text;
    text << std::ifstream(GRAFWIRE_ROOT "/examples/" + name + ".grafcet").rdbuf();
    Diagnostics diagnostics;
    const auto grafcet = parse_grafcet({name, text.str()}, diagnostics);
    if (!grafcet) std::abort();
    const Equations equations = equations_from(*grafcet, EquationOptions{});
    const auto netlist = netlist_from(*grafcet, equations, style, diagnostics);
    if (!netlist) std::abort();
    CheckOptions options;
    options.changes = Changes::many;
    CheckResult result;
    const double seconds =
        time_of([&] { result = check_equivalence(*grafcet, *netlist, options); });
    fmt::print("{:<20} {:>8} {:>9} {:>9.3f} {:>9.0f}  {}\n", name,
               style_table[static_cast<std::size_t>(style)].name, result.coverage.cases, seconds,
               static_cast<double>(result.coverage.cases) / seconds, name_of(result.verdict));
}

}  // namespace

void measure_cases() {
    fmt::print("{:<20} {:>8} {:>9} {:>9} {:>9}\n", "Check, many changes", "style", "cases",
               "seconds", "a second");
    measure_example("manipulator", Style::nand);
    measure_example("manipulator", Style::gates);
    measure_example("manipulator", Style::clocked);
    fmt::print("\n");
}

}  // namespace bench
