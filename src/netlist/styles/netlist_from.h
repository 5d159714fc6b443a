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
    gates,    ///< a phase module of AND, OR and NOT gates with feedback per step
    nand,     ///< a set-priority latch of NAND gates per step
    nor,      ///< the reset-priority latch of NOR gates that the course warns of
    clocked,  ///< a D flip-flop per step; transition form of CDX
};

struct StyleRow {
    Style style;
    std::string_view name;
    std::string_view description;
    CdxForm default_cdx;
};

inline constexpr std::array<StyleRow, 4> style_table{{
    {Style::gates, "gates", "phase modules of AND, OR and NOT gates", CdxForm::successor},
    {Style::nand, "nand", "set-priority latches of NAND gates", CdxForm::successor},
    {Style::nor, "nor", "reset-priority latches of NOR gates", CdxForm::successor},
    {Style::clocked, "clocked", "a D flip-flop per step on a common clock", CdxForm::transition},
}};

/// The netlist of a GRAFCET in a style. What the style cannot hold (counters in the asynchronous
/// ones) is reported in `diagnostics`, and the result is empty then. The clocked style does not use
/// CDX as such: it computes the situation after the scan from the transitions, whatever the form.
/// Expressions for the comments on the modules are added to the equations' pool.
/// `delays`: how long the gates will take; the clocked style does not depend on it.
std::optional<Netlist> netlist_from(Equations& equations, Style style, Diagnostics& diagnostics,
                                    const DelayModel& delays = {});

}  // namespace grafwire
