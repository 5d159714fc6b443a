#include "workflow/schematics.h"

#include <utility>

#include "simulate/simulate.h"
#include "text/shown_duration.h"
#include "workflow/messages.h"

namespace grafwire {

namespace say = messages::workflow;

namespace {

/// What drawings of netlists heed besides what the format of drawings does.
constexpr std::string_view options_of_schematics = "--stim --at --symbols --paper";

Message<> description_of(const DrawingFormat& format) {
    return format.name == "svg" ? say::schematic_svg : say::schematic_tikz;
}

std::vector<NetlistTarget> make_targets() {
    std::vector<NetlistTarget> targets;
    for (const NetlistFormat& format : netlist_formats()) {
        targets.push_back(
            {format.name, format.description, std::string(format.options), &format, nullptr});
    }
    for (const DrawingFormat& format : drawing_formats()) {
        std::string options(options_of_schematics);
        if (!format.options.empty()) options.append(" ").append(format.options);
        targets.push_back(
            {format.name, description_of(format), std::move(options), nullptr, &format});
    }
    return targets;
}

/// The stimuli up to a moment.
Stimuli until(const Stimuli& stimuli, Time at) {
    Stimuli begun;
    for (const Stimuli::Change& change : stimuli.changes) {
        if (change.at <= at) begun.changes.push_back(change);
    }
    begun.end = at;
    return begun;
}

}  // namespace

std::span<const NetlistTarget> netlist_targets() {
    static const std::vector<NetlistTarget> targets = make_targets();
    return targets;
}

std::optional<std::vector<Logic>> net_values_at(const Chart& chart, const Netlist& netlist,
                                                const Stimuli& stimuli, Time at,
                                                const DelayModel& delays) {
    std::vector<Logic> values;
    SimulateOptions options;
    // What they are before the first instant; from then on every change is told.
    options.instant = [&](Time, const Simulator& simulator) {
        if (!values.empty()) return;
        for (std::size_t net = 0; net < netlist.net_count(); ++net) {
            values.push_back(simulator.value(static_cast<NetId>(net)));
        }
    };
    options.observer = [&](Time, NetId net, Logic value) {
        if (!values.empty()) values[index_of(net)] = value;
    };
    const SimulateResult result =
        simulate(chart.grafcet, netlist, cell_delays(netlist, delays), until(stimuli, at), options);
    if (result.unsettled_at || values.empty()) return std::nullopt;
    return values;
}

std::string schematic_title(const Chart& chart, Style style, std::optional<Time> at,
                            Language language) {
    std::string title = chart.grafcet.name;
    if (!chart.grafcet.title.empty()) title += " – " + chart.grafcet.title;
    title += " – ";
    title += style_table[static_cast<std::size_t>(style)].name;
    if (at) title += " – " + say::values_at(shown_duration(*at)).in(language);
    return title;
}

std::string schematic_drawing(const Netlist& netlist, const SchematicDrawing& how,
                              const DrawingFormat& format, bool standalone) {
    return format.write(draw_schematic(netlist, how), how.title, how.paper, how.language,
                        standalone);
}

}  // namespace grafwire
