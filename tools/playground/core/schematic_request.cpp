#include "core/asked_chart.h"
#include "core/asked_schematic.h"
#include "core/messages.h"
#include "core/requests.h"

namespace grafwire::playground {

std::optional<SchematicDrawing> asked_schematic(const Arguments& arguments, const Chart& chart,
                                                const Netlist& netlist,
                                                const NetlistOptions& options, Json& answer) {
    SchematicDrawing how;
    how.language = arguments.language();
    const GateShapesRow* shapes = asked_row(arguments, "symbols", gate_shapes_table, answer);
    if (shapes == nullptr) return std::nullopt;
    how.shapes = shapes->shapes;
    const Paper* paper = asked_row(arguments, "paper", papers, answer);
    if (paper == nullptr) return std::nullopt;
    how.paper = *paper;
    std::optional<Time> at;
    if (arguments.has("at")) {
        const auto stimuli = asked_stimuli(arguments, chart, answer);
        if (!stimuli) return std::nullopt;
        at = asked_moment(arguments, answer);
        if (!at) return std::nullopt;
        auto values = net_values_at(chart, netlist, *stimuli, *at, options.delays);
        if (!values) {
            answer = error_answer(say::no_situation_at(arguments.text("at")), how.language);
            return std::nullopt;
        }
        how.values = std::move(*values);
    }
    how.title = schematic_title(chart, options.style, at, how.language);
    return how;
}

Json answer_schematic(const Arguments& arguments, const Asked&) {
    Json answer;
    const auto chart = asked_chart(arguments, answer);
    if (!chart) return answer;
    const auto options = asked_options(arguments, answer);
    if (!options) return answer;
    const auto netlist = asked_netlist(arguments, *chart, *options, answer);
    if (!netlist) return answer;
    const auto how = asked_schematic(arguments, *chart, *netlist, *options, answer);
    if (!how) return answer;
    return Json{{"svg", schematic_drawing(*netlist, *how, drawing_formats().front(), false)}};
}

}  // namespace grafwire::playground
