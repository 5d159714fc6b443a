// Checks under open delays: states of gates gone through a second under each model, and how the
// time grows with the number of sequences that go on at the same time.

#include <fmt/format.h>

#include <cstdlib>
#include <string>

#include "charts.h"
#include "check/check_equivalence.h"
#include "check/report.h"
#include "child.h"
#include "equations/equations.h"
#include "grafcet/parse_grafcet.h"
#include "netlist/passes/wire_delays.h"
#include "netlist/styles/styles.h"
#include "sections.h"

namespace bench {

namespace {

using namespace grafwire;

void measure_model(std::size_t branches, Style style, const char* delays) {
    Diagnostics diagnostics;
    const auto grafcet = parse_grafcet({"nine steps", nine_steps_chart(branches)}, diagnostics);
    if (!grafcet) std::abort();
    CheckOptions options;
    options.delays = *delay_model_of(delays);
    options.looks_at_many = false;
    options.max_cases = 20'000;
    const auto made = netlist_from(*grafcet, equations_from(*grafcet, EquationOptions{}), style,
                                   diagnostics, options.delays);
    if (!made) std::abort();
    const bool has_wires = options.delays.kind == DelayModel::Kind::any_wire;
    const Netlist netlist = has_wires ? with_wire_delays(*made, telling_wires(*made)) : *made;
    CheckResult result;
    const double seconds = time_of([&] { result = check_equivalence(*grafcet, netlist, options); });
    const auto& coverage = result.coverage;
    fmt::print("{:<9} {:>9} {:>9} {:>8} {:>10} {:>9.3f} {:>9.0f} {:>9.0f}  {}\n", branches,
               style_table[static_cast<std::size_t>(style)].name, delays, coverage.cases,
               coverage.gate_states, seconds, static_cast<double>(coverage.cases) / seconds,
               static_cast<double>(coverage.gate_states) / seconds, name_of(result.verdict));
}

}  // namespace

void measure_delays(const Options& options) {
    fmt::print(
        "Checks of nine-steps, one change at a time, by one worker; with more sequences side by "
        "side.\n\n{:<9} {:>9} {:>9} {:>8} {:>10} {:>9} {:>9} {:>9}\n",
        "sequences", "style", "delays", "cases", "states", "seconds", "cases/s", "states/s");
    for (const char* delays : {"unit", "any", "any-wire", "1..1.2"}) {
        measure_model(2, Style::nand, delays);
    }
    for (const char* delays : {"unit", "any", "1..1.2"}) {
        measure_model(2, Style::handshake, delays);
    }
    const std::size_t most = options.has_largest ? 4 : 3;
    for (std::size_t branches = 3; branches <= most; ++branches) {
        measure_model(branches, Style::handshake, "any");
    }
    fmt::print("\n");
}

}  // namespace bench
