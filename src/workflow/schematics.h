#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "draw/draw_schematic.h"
#include "formats/netlist_formats.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"
#include "text/message.h"
#include "text/time.h"
#include "trace/stimuli.h"
#include "workflow/chart.h"
#include "workflow/drawings.h"
#include "workflow/netlists.h"

namespace grafwire {

/// What a netlist is written as, by the name users write: a format of netlists, or one of drawings.
struct NetlistTarget {
    std::string_view name;
    Message<> description;
    std::string options;  ///< those that it heeds
    const NetlistFormat* format = nullptr;
    const DrawingFormat* drawing = nullptr;
};
std::span<const NetlistTarget> netlist_targets();

/// The symbols of gates by the names users write.
struct GateShapesRow {
    std::string_view name;
    GateShapes shapes;
};
inline constexpr GateShapesRow gate_shapes_table[] = {
    {"iec", GateShapes::iec},
    {"us", GateShapes::us},
};

/// By net, what it is once the gates have settled at the last instant that is not later than `at`;
/// where there is a clock, once its cycles change nothing any more. Empty where they do not settle
/// up to there.
std::optional<std::vector<Logic>> net_values_at(const Chart& chart, const Netlist& netlist,
                                                const Stimuli& stimuli, Time at,
                                                const DelayModel& delays);

/// What a schematic says above it: the chart, the style, and the moment if one is shown.
std::string schematic_title(const Chart& chart, Style style, std::optional<Time> at,
                            Language language);

/// The schematic of a netlist in a format of drawings. `standalone`: as chart_drawing().
std::string schematic_drawing(const Netlist& netlist, const SchematicDrawing& how,
                              const DrawingFormat& format, bool standalone);

}  // namespace grafwire
