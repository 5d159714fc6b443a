#include "grafcet/grafcet.h"

#include <fmt/format.h>

#include <cassert>

namespace grafwire {

namespace {

constexpr std::string_view control_names[control_input_count] = {"Init", "AUdur", "AUdoux"};

}  // namespace

std::string variable_name(const Grafcet& grafcet, Variable variable) {
    const std::uint32_t index = variable.index;
    switch (variable.kind) {
        case VariableKind::input:
            return grafcet.inputs.items()[index].name;
        case VariableKind::control:
            return std::string(control_names[index]);
        case VariableKind::output:
            return grafcet.outputs.items()[index].name;
        case VariableKind::var:
            return grafcet.vars.items()[index].name;
        case VariableKind::counter:
            return grafcet.counters.items()[index].name;
        case VariableKind::step:
            return fmt::format("X{}", grafcet.steps.items()[index].name);
        case VariableKind::macro:
            return fmt::format("X{}", grafcet.macros.items()[index].name);
        case VariableKind::graph:
            return fmt::format("X{}", grafcet.graphs.items()[index].name);
    }
    assert(false);
    return {};
}

std::string_view input_name(const Grafcet& grafcet, std::size_t index) {
    assert(index < grafcet.all_input_count());
    if (index < grafcet.inputs.size()) return grafcet.inputs.items()[index].name;
    return control_names[index - grafcet.inputs.size()];
}

}  // namespace grafwire
