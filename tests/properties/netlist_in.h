#pragma once

#include <optional>

#include "netlist/styles/styles.h"

namespace grafwire::testing {

/// The netlist of a chart with modes, with the form of CDX that the style takes by itself; none
/// where the style refuses the chart.
inline std::optional<Netlist> netlist_in(const Grafcet& grafcet, Style style) {
    const CdxForm cdx = style_table[static_cast<std::size_t>(style)].default_cdx;
    const Equations equations = equations_from(grafcet, {cdx, true});
    Diagnostics diagnostics;
    return netlist_from(grafcet, equations, style, diagnostics);
}

}  // namespace grafwire::testing
