#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "equations/equations.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"
#include "text/diagnostics.h"

namespace grafwire {

/// How the equations become cells.
enum class Style {
    gates,    ///< a step module of AND, OR and NOT gates with feedback per step
    nand,     ///< a set-priority latch of NAND gates per step
    nor,      ///< the reset-priority latch of NOR gates that the course warns of
    clocked,  ///< a D flip-flop per step; transition form of CDX
};

struct StyleRow {
    Style style;
    std::string_view name;
    std::string_view description;
    CdxForm default_cdx;
    bool has_registers;  ///< for counters
    Netlist (*make)(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays);
};

/// In the order of Style.
extern const std::array<StyleRow, 4> style_table;

/// The netlist of a GRAFCET in a style. What the style cannot hold (counters in the asynchronous
/// ones) is reported in `diagnostics`, and the result is empty then. The clocked style does not use
/// CDX as such: it computes the situation after the scan from the transitions, whatever the form.
/// Modules are annotated with their equations. `delays`: how long the gates will take; the clocked
/// style does not depend on it.
std::optional<Netlist> netlist_from(const Grafcet& grafcet, const Equations& equations, Style style,
                                    Diagnostics& diagnostics, const DelayModel& delays = {});

}  // namespace grafwire
