#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "equations/equations.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"
#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// How the equations become cells.
enum class Style {
    gates,      ///< a step module of AND, OR and NOT gates with feedback per step
    nand,       ///< a set-priority latch of NAND gates per step
    nor,        ///< the reset-priority latch of NOR gates that the course warns of
    clocked,    ///< a D flip-flop per step; transition form of CDX
    rs,         ///< the plain latch of two NAND gates per step, as the course draws it
    handshake,  ///< NAND gates that answer each other: right under any delay of the gates
};

// The makers of style_table, each in a file of its own: style_NAME.cpp.

Netlist make_gates(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays);
Netlist make_nand(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays);
Netlist make_nor(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays);
Netlist make_clocked(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays);
Netlist make_rs(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays);
Netlist make_handshake(const Grafcet& grafcet, const Equations& equations,
                       const DelayModel& delays);
/// Reports what that style cannot hold.
void refuse_handshake(const Grafcet& grafcet, const Equations& equations, Diagnostics& diagnostics);

/// What the program knows of a style.
struct StyleRow {
    Style style;
    std::string_view name;  ///< as users ask for it and as reports call it
    Message<> description;  ///< for the help: what a step is made of
    CdxForm default_cdx;    ///< where the user does not say
    bool has_registers;     ///< for counters
    /// From equations to a netlist without comments.
    Netlist (*make)(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays);
    /// Reports what the style cannot hold beside counters; nullptr where there is nothing.
    void (*refuse)(const Grafcet& grafcet, const Equations& equations,
                   Diagnostics& diagnostics) = nullptr;
};

/// In the order of Style.
extern const std::span<const StyleRow> style_table;

/// The netlist of a GRAFCET in a style. What the style cannot hold (counters in the asynchronous
/// ones) is reported in `diagnostics`, and the result is empty then. The clocked style does not use
/// CDX as such: it computes the situation after the scan from the transitions, whatever the form.
/// Modules are annotated with their equations. `delays`: how long the gates will take; the clocked
/// style does not depend on it.
std::optional<Netlist> netlist_from(const Grafcet& grafcet, const Equations& equations, Style style,
                                    Diagnostics& diagnostics, const DelayModel& delays = {});

}  // namespace grafwire
