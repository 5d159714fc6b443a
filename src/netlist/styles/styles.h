#pragma once

#include <span>
#include <string_view>

#include "equations/equations.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"

namespace grafwire {

/// How the equations become cells.
enum class Style {
    gates,    ///< a step module of AND, OR and NOT gates with feedback per step
    nand,     ///< a set-priority latch of NAND gates per step
    nor,      ///< the reset-priority latch of NOR gates that the course warns of
    clocked,  ///< a D flip-flop per step; transition form of CDX
};

// The makers of style_table, each in a file of its own: style_NAME.cpp.

Netlist make_gates(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays);
Netlist make_nand(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays);
Netlist make_nor(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays);
Netlist make_clocked(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays);

struct StyleRow {
    Style style;
    std::string_view name;
    std::string_view description;
    CdxForm default_cdx;
    bool has_registers;  ///< for counters
    Netlist (*make)(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays);
};

/// In the order of Style.
extern const std::span<const StyleRow> style_table;

}  // namespace grafwire
