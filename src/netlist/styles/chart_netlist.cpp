// Nets of ports bear the declared names, inner nets are called `owner$role`. A declared name may
// hold a `$` itself, so those that do are kept free from the start; the others cannot be met.
//
// Steps and transitions have gates all over the netlist, so each has one origin, made when the
// first gate asks for it. The others have gates in one or two modules, and an origin for each.

#include "netlist/styles/chart_netlist.h"

#include "grafcet/write_grafcet.h"

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
    builder_.add_module("inputs");
}

std::uint32_t ChartNetlist::origin_of(StepId step) {
    std::uint32_t& origin = step_origins_[index_of(step)];
    if (origin == 0) {
        const Step& item = grafcet_.steps[step];
        origin = builder_.add_origin(Origin::Kind::step, item.name, item.where);
    }
    return origin;
}

std::uint32_t ChartNetlist::origin_of(TransitionId transition) {
    std::uint32_t& origin = transition_origins_[index_of(transition)];
    if (origin == 0) {
        const Transition& item = grafcet_.transitions[transition];
        origin = builder_.add_origin(Origin::Kind::transition, "(" + item.name + ")", item.where);
    }
    return origin;
}

std::uint32_t ChartNetlist::origin_of(OutputId output) {
    const Output& item = grafcet_.outputs[output];
    return builder_.add_origin(Origin::Kind::output, item.name, item.where);
}

std::uint32_t ChartNetlist::origin_of(VarId var) {
    const Var& item = grafcet_.vars[var];
    return builder_.add_origin(Origin::Kind::var, item.name, item.where);
}

std::uint32_t ChartNetlist::origin_of(CounterId counter) {
    const Counter& item = grafcet_.counters[counter];
    return builder_.add_origin(Origin::Kind::counter, item.name, item.where);
}

std::uint32_t ChartNetlist::origin_of(GraphId graph) {
    return builder_.add_origin(Origin::Kind::graph, grafcet_.graphs[graph].name, {});
}

std::uint32_t ChartNetlist::origin_of(const Expressions& pool, ExprId id, Location where) {
    const bool is_time = pool.kind(id) == ExprKind::time_condition;
    return builder_.add_origin(is_time ? Origin::Kind::time_condition : Origin::Kind::edge,
                               write_expression(grafcet_, pool, id), where);
}

std::vector<NetId> ChartNetlist::add_inputs(bool modes) {
    std::vector<NetId> nets;
    for (std::size_t i = 0; i < grafcet_.all_input_count(); ++i) {
        if (i >= grafcet_.inputs.size() && !modes) {
            nets.push_back(no_net);
            continue;
        }
        const std::string name(input_name(grafcet_, i));
        nets.push_back(builder_.add_net(name));
        builder_.add_input(name, nets.back());
    }
    return nets;
}

std::vector<NetId> ChartNetlist::add_steps() {
    std::vector<NetId> nets;
    for (const Step& step : grafcet_.steps) {
        const std::string name = "X" + step.name;
        nets.push_back(builder_.add_net(name));
        builder_.add_output(name, nets.back());
    }
    return nets;
}

std::vector<NetId> ChartNetlist::add_outputs() {
    std::vector<NetId> nets;
    for (const Output& output : grafcet_.outputs) {
        nets.push_back(builder_.add_net(output.name));
        builder_.add_output(output.name, nets.back());
    }
    return nets;
}

std::vector<NetId> ChartNetlist::add_vars() {
    std::vector<NetId> nets;
    for (const Var& var : grafcet_.vars) {
        nets.push_back(builder_.add_net(var.name));
        builder_.add_var({var.name, {nets.back()}, 0});
    }
    return nets;
}

Netlist ChartNetlist::finish(bool modes, NetId clock) {
    Netlist netlist = builder_.finish();
    netlist.has_modes = modes;
    netlist.step_count = grafcet_.steps.size();
    netlist.clock = clock;
    return netlist;
}

}  // namespace grafwire
