#include "netlist/styles/netlist_from.h"

#include <fmt/format.h>

#include <cassert>

#include "netlist/styles/asynchronous.h"

namespace grafwire {

namespace {

void refuse_counters(const Grafcet& grafcet, Style style, Diagnostics& diagnostics) {
    for (const Counter& counter : grafcet.counters) {
        diagnostics.error(
            Code::unsupported_by_style, counter.where,
            fmt::format("the {} style has no registers for the counter '{}'; use --style clocked",
                        style_table[static_cast<std::size_t>(style)].name, counter.name));
    }
}

}  // namespace

std::optional<Netlist> netlist_from(Equations& equations, Style style, Diagnostics& diagnostics,
                                    const DelayModel& delays) {
    if (style != Style::clocked) refuse_counters(*equations.grafcet, style, diagnostics);
    if (diagnostics.has_errors()) return std::nullopt;
    const bool modes = equations.options.modes;
    Netlist netlist;
    switch (style) {
        case Style::gates:
            netlist =
                make_asynchronous(equations, make_gates_phase, delays.of_chain(modes ? 3 : 2));
            break;
        case Style::nand:
            netlist = make_asynchronous(equations, make_nand_phase, delays.of_chain(2));
            break;
        case Style::nor:
            netlist = make_asynchronous(equations, make_nor_phase, delays.of_chain(3));
            break;
        case Style::clocked:
            netlist = make_clocked(equations);
            break;
    }
    assert(fault_of(netlist).empty());
    return netlist;
}

}  // namespace grafwire
