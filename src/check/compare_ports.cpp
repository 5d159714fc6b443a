// The ports of a netlist from elsewhere, by name: inputs of the GRAFCET, X of every step, outputs.
// What is missing among X and outputs makes a comparison impossible; an input that is missing is
// one that the netlist does not react to, and what is extra is only reported.

#include "check/compare_ports.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "check/messages.h"

namespace grafwire {

namespace {

namespace words = messages::check;

std::vector<std::string> input_names(const Grafcet& grafcet) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < grafcet.all_input_count(); ++i) {
        names.emplace_back(input_name(grafcet, i));
    }
    return names;
}

std::vector<std::string> output_names(const Grafcet& grafcet) {
    std::vector<std::string> names;
    for (const Step& step : grafcet.steps) names.push_back("X" + step.name);
    for (const Output& output : grafcet.outputs) names.push_back(output.name);
    return names;
}

std::unordered_set<std::string> port_names(const std::vector<Port>& ports) {
    std::unordered_set<std::string> names;
    for (const Port& port : ports) names.insert(port.name);
    return names;
}

std::vector<std::string> without(const std::vector<std::string>& names,
                                 const std::unordered_set<std::string>& other) {
    std::vector<std::string> rest;
    for (const std::string& name : names) {
        if (!other.contains(name)) rest.push_back(name);
    }
    return rest;
}

std::vector<std::string> extra(const std::vector<Port>& ports,
                               const std::vector<std::string>& wanted, bool clock_is_known) {
    const std::unordered_set<std::string> known(wanted.begin(), wanted.end());
    std::vector<std::string> names;
    for (const Port& port : ports) {
        const bool is_clock = clock_is_known && port.name == "clk";
        if (!known.contains(port.name) && !is_clock) names.push_back(port.name);
    }
    return names;
}

bool has_some_control(const Grafcet& grafcet, const std::unordered_set<std::string>& ports) {
    for (std::size_t i = 0; i < control_input_count; ++i) {
        if (ports.contains(std::string(input_name(grafcet, grafcet.inputs.size() + i)))) {
            return true;
        }
    }
    return false;
}

}  // namespace

PortComparison compare_ports(const Grafcet& grafcet, const Netlist& netlist) {
    PortComparison comparison;
    const auto inputs = port_names(netlist.inputs);
    std::vector<std::string> wanted = input_names(grafcet);
    comparison.extra_inputs = extra(netlist.inputs, wanted, netlist.is_clocked());
    if (!has_some_control(grafcet, inputs)) wanted.resize(grafcet.inputs.size());
    comparison.missing_inputs = without(wanted, inputs);

    const std::vector<std::string> outputs = output_names(grafcet);
    comparison.missing_outputs = without(outputs, port_names(netlist.outputs));
    comparison.extra_outputs = extra(netlist.outputs, outputs, false);

    for (const Cell& cell : netlist.cells) {
        if (!is_timer(cell.type)) continue;
        if (netlist.timings[cell.timing].ordinal >= grafcet.expressions.time_conditions().size()) {
            comparison.unrelated_timers.emplace_back(netlist.names[cell.output]);
        }
    }
    return comparison;
}

std::string write_port_table(const PortComparison& comparison, Language language) {
    struct Row {
        const std::vector<std::string>& names;
        const Message<>& label;
    };
    const Row rows[] = {
        {comparison.missing_inputs, words::missing_input},
        {comparison.missing_outputs, words::missing_output},
        {comparison.extra_inputs, words::extra_input},
        {comparison.extra_outputs, words::extra_output},
        {comparison.unrelated_timers, words::unrelated_timer},
    };
    std::string text;
    for (const Row& row : rows) {
        for (const std::string& name : row.names) {
            text += fmt::format("  {:<40}{}\n", row.label.in(language), name);
        }
    }
    return text;
}

void adopt_ports(const Grafcet& grafcet, Netlist& netlist) {
    netlist.has_modes = has_some_control(grafcet, port_names(netlist.inputs));
    std::unordered_map<std::string, NetId> nets;
    for (const Port& port : netlist.outputs) nets.emplace(port.name, port.net);
    const std::vector<std::string> wanted = output_names(grafcet);
    std::vector<Port> ordered;
    for (const std::string& name : wanted) ordered.push_back({name, nets.at(name)});
    const std::unordered_set<std::string> known(wanted.begin(), wanted.end());
    for (const Port& port : netlist.outputs) {
        if (!known.contains(port.name)) ordered.push_back(port);
    }
    netlist.outputs = std::move(ordered);
    netlist.step_count = grafcet.steps.size();
}

}  // namespace grafwire
