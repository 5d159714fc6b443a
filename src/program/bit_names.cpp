#include "program/bit_names.h"

#include "grafcet/write_grafcet.h"
#include "program/messages.h"

namespace grafwire {

std::string titled_name(const std::string& name, const std::string& title, Language language) {
    return title.empty() ? name : messages::program::titled.in(language, name, title);
}

std::string_view table_name(BitKind kind) {
    switch (kind) {
        case BitKind::step:
            return "Ts";
        case BitKind::previous:
            return "Tp";
        case BitKind::pulse:
            return "Tpulse";
        case BitKind::activate:
            return "Ta";
        case BitKind::deactivate:
            return "Td";
        case BitKind::forced_on:
            return "Tf1";
        case BitKind::forced_off:
            return "Tf0";
        case BitKind::transition:
            return "Tt";
        case BitKind::may_evolve:
            return "Tfig";
        default:
            return {};
    }
}

bool is_step_table(BitKind kind) {
    return kind != BitKind::transition && kind != BitKind::may_evolve && !table_name(kind).empty();
}

std::string name_in_chart(const Grafcet& grafcet, Bit bit) {
    const auto text_of = [&](ExprId id) {
        return write_expression(grafcet, grafcet.expressions, id);
    };
    switch (bit.kind) {
        case BitKind::input:
            return grafcet.inputs[InputId{bit.index}].name;
        case BitKind::control:
            return std::string(input_name(grafcet, grafcet.inputs.size() + bit.index));
        case BitKind::output:
            return grafcet.outputs[OutputId{bit.index}].name;
        case BitKind::var:
            return grafcet.vars[VarId{bit.index}].name;
        case BitKind::transition:
            return grafcet.transitions[TransitionId{bit.index}].name;
        case BitKind::may_evolve:
            return grafcet.graphs[GraphId{bit.index}].name;
        case BitKind::edge:
        case BitKind::edge_memory:
            return text_of(grafcet.expressions.edges()[bit.index]);
        case BitKind::time_value:
            return text_of(grafcet.expressions.time_conditions()[bit.index]);
        case BitKind::scratch:
        case BitKind::auxiliary:
            return std::to_string(bit.index);
        default:
            return grafcet.steps[StepId{bit.index}].name;
    }
}

}  // namespace grafwire
