#include "netlist/styles/chart_netlist.h"

namespace grafwire {

ChartNetlist::ChartNetlist(const Grafcet& grafcet)
    : grafcet_(grafcet),
      builder_(grafcet.name, InnerNames::by_role),
      step_origins_(grafcet.steps.size()),
      transition_origins_(grafcet.transitions.size()) {
    constexpr std::size_t cells_a_step = 8;
    builder_.reserve(cells_a_step * grafcet.steps.size());
    const auto reserve_name = [&](const std::string& name) {
        if (name.find('$') != std::string::npos) builder_.reserve_name(name);
    };
    for (const Input& input : grafcet.inputs) reserve_name(input.name);
    for (const Output& output : grafcet.outputs) reserve_name(output.name);
    for (const Var& var : grafcet.vars) reserve_name(var.name);
    for (const Step& step : grafcet.steps) reserve_name("X" + step.name);
    place_.module = add_module("inputs");
}

std::uint32_t ChartNetlist::origin_of_step(StepId step) {
    std::uint32_t& origin = step_origins_[index_of(step)];
    if (origin == 0) {
        const Step& item = grafcet_.steps[step];
        origin = add_origin(Origin::Kind::step, item.name, item.where);
    }
    return origin;
}

std::uint32_t ChartNetlist::origin_of_transition(TransitionId transition) {
    std::uint32_t& origin = transition_origins_[index_of(transition)];
    if (origin == 0) {
        const Transition& item = grafcet_.transitions[transition];
        origin = add_origin(Origin::Kind::transition, "(" + item.name + ")", item.where);
    }
    return origin;
}

}  // namespace grafwire
