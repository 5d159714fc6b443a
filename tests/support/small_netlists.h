#pragma once

#include <doctest/doctest.h>

#include <optional>
#include <string>

#include "netlist/styles/styles.h"
#include "random/read_text.h"

namespace grafwire::testing {

/// The GRAFCET of a text without errors; the test fails otherwise.
inline Grafcet grafcet_of(const std::string& text) {
    std::string messages;
    std::optional<Grafcet> grafcet = read_grafcet(text, &messages);
    if (!grafcet) FAIL(messages);
    return std::move(*grafcet);
}

/// Whether the style handshake, which does not take every construct, refuses the GRAFCET.
inline bool refused_by_handshake(const Grafcet& grafcet) {
    const Equations equations = equations_from(grafcet, {});
    Diagnostics diagnostics;
    return !netlist_from(grafcet, equations, Style::handshake, diagnostics);
}

/// Its netlist, with the form of CDX that the style takes by itself.
inline Netlist netlist_of(const Grafcet& grafcet, Style style, bool modes = true) {
    const CdxForm cdx = style_table[static_cast<std::size_t>(style)].default_cdx;
    const Equations equations = equations_from(grafcet, {cdx, modes});
    Diagnostics diagnostics;
    std::optional<Netlist> netlist = netlist_from(grafcet, equations, style, diagnostics);
    if (!netlist) FAIL("refused: " << diagnostics.items()[0].message.english);
    return std::move(*netlist);
}

}  // namespace grafwire::testing
