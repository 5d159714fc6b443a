// The frame of the asynchronous styles: inputs, one phase module per step as the style makes it,
// outputs, stored outputs and vars.
//
// A phase module is where all that bears on a step meets: the transitions into it, CDX, Init,
// AUdur, forcing orders and enclosures. Its parts come from the equations; what a style decides is
// only how a memory is made of gates. Clearing conditions are made once and shared by the steps
// that a transition activates, so that these are set by one and the same signal.
//
// Edges are pulse cells. The width of a pulse equals the delay from the pulse to the X it sets: any
// shorter and the memory would not hold by itself, any longer and the pulse would still be there
// when the next step becomes active, and clear the transition after it as well.

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "equations/equation_text.h"
#include "equations/logic.h"
#include "equations/step_texts.h"
#include "netlist/styles/asynchronous_frame.h"

namespace grafwire {

bool AsynchronousBuild::is_in_loop_of_two(TransitionId transition) const {
    const Grafcet& grafcet = *equations.grafcet;
    const auto before = grafcet.preceding(grafcet.transitions[transition]);
    for (const StepId after : grafcet.following(grafcet.transitions[transition])) {
        for (const TransitionId back : links.out_of_step(after)) {
            for (const StepId step : grafcet.following(grafcet.transitions[back])) {
                if (std::find(before.begin(), before.end(), step) != before.end()) return true;
            }
        }
    }
    return false;
}

// In a loop of two steps the clearing condition must last until the step before has fallen, because
// that step is what resets the one after. So a freezing order, which may come at the same instant,
// is let in only then.
std::vector<NetId> AsynchronousBuild::clearing_factors(TransitionId transition) {
    const Transition& item = equations.grafcet->transitions[transition];
    const ExprId frozen = equations.frozen[item.graph];
    ExprId late = no_expr;
    if (frozen != no_expr && is_in_loop_of_two(transition)) {
        late = not_of(equations.expressions, frozen);
    }
    std::vector<NetId> nets =
        logic.clearing_factors(equations.clearing[transition], writing_steps, late);
    if (nets.empty()) nets.push_back(builder.high());
    return nets;
}

NetId AsynchronousBuild::clearing_net(TransitionId transition) {
    NetId& net = clearing[index_of(transition)];
    if (net == no_net) {
        const Transition& item = equations.grafcet->transitions[transition];
        const std::uint32_t before = builder.origin();
        builder.work_on(builder.module(), builder.origin_of_transition(transition));
        const std::string owner = "T" + item.name;
        logic.owner = owner;
        const std::vector<NetId> nets = clearing_factors(transition);
        net = nets.size() == 1 ? nets[0] : builder.gate(CellType::and_gate, nets, owner, "clear");
        builder.work_on(builder.module(), before);
    }
    return net;
}

std::vector<std::uint8_t> writing_steps(const Equations& equations) {
    const Grafcet& grafcet = *equations.grafcet;
    std::vector<std::uint8_t> writing(grafcet.steps.size());
    for (const StoredEquation& stored : equations.stored) {
        for (const StoredWrite& write : stored.writes) {
            if (write.cause != StoredWrite::Cause::clearing) {
                writing[index_of(write.step)] = 1;
                continue;
            }
            for (const StepId step : grafcet.following(grafcet.transitions[write.transition])) {
                writing[index_of(step)] = 1;
            }
        }
    }
    return writing;
}

void AsynchronousFrame::make_ports() {
    for (std::size_t i = 0; i < grafcet_.all_input_count(); ++i) {
        if (i >= grafcet_.inputs.size() && !equations_.options.modes) {
            logic_.inputs.push_back(no_net);
            continue;
        }
        const std::string name(input_name(grafcet_, i));
        const NetId net = builder_.add_port_net(name);
        builder_.add_input(name, net);
        logic_.inputs.push_back(net);
    }
    const std::size_t controls = grafcet_.inputs.size();
    init_ = logic_.inputs[controls];
    au_dur_ = logic_.inputs[controls + 1];
    au_doux_ = logic_.inputs[controls + 2];
    for (const Step& step : grafcet_.steps) {
        const std::string name = "X" + step.name;
        const NetId net = builder_.add_port_net(name);
        builder_.add_output(name, net);
        logic_.steps.push_back(net);
    }
    for (const Output& output : grafcet_.outputs) {
        const NetId net = builder_.add_port_net(output.name);
        builder_.add_output(output.name, net);
        logic_.outputs.push_back(net);
    }
    for (const Var& var : grafcet_.vars) {
        const NetId net = builder_.add_port_net(var.name);
        builder_.add_var({var.name, {net}, 0});
        logic_.vars.push_back(net);
    }
    // The complements that every module shares stand with the inputs.
    if (init_ != no_net) builder_.inverted(init_);
    if (au_dur_ != no_net) builder_.inverted(au_dur_);
}

std::vector<std::vector<NetId>> AsynchronousFrame::cdx_of(StepId step) {
    std::vector<std::vector<NetId>> products;
    const ExprId cdx = equations_.steps[step].cdx;
    const Expressions& pool = equations_.expressions;
    if (pool.kind(cdx) == ExprKind::constant) return products;
    const bool is_sum = pool.kind(cdx) == ExprKind::disjunction;
    const std::span<const ExprId> terms =
        is_sum ? pool.operands(cdx) : std::span<const ExprId>(&cdx, 1);
    // A term of the transition form is a clearing condition that has its gate already.
    for (const ExprId term : std::vector<ExprId>(terms.begin(), terms.end())) {
        std::vector<NetId> factors;
        for (const TransitionId out : build_.links.out_of_step(step)) {
            if (equations_.clearing[out] == term) factors = {build_.clearing_net(out)};
        }
        if (factors.empty()) factors = logic_.factors(term);
        products.push_back(std::move(factors));
    }
    return products;
}

PhaseSignals AsynchronousFrame::phase_of(StepId step) {
    const StepEquation& equation = equations_.steps[step];
    PhaseSignals phase;
    phase.step = step;
    phase.x = logic_.steps[index_of(step)];
    phase.initial = grafcet_.steps[step].initial;
    phase.init = init_;
    if (init_ != no_net) phase.not_init = builder_.inverted(init_);
    if (au_dur_ != no_net) phase.not_au_dur = builder_.inverted(au_dur_);
    if (equation.forced_off != no_expr) phase.forced_off = logic_.net(equation.forced_off);
    if (equation.forced_on != no_expr) phase.forced_on = logic_.net(equation.forced_on);
    if (equation.enclosing != no_expr) phase.enclosing = logic_.net(equation.enclosing);
    if (equation.link != no_expr) phase.link = logic_.factors(equation.link);
    for (const TransitionId into : build_.links.into_step(step)) {
        const ExprId clearing = equations_.clearing[into];
        if (!is_constant(equations_.expressions, clearing, false)) phase.into.push_back(into);
    }
    phase.cdx = cdx_of(step);
    return phase;
}

void AsynchronousFrame::make_steps() {
    // A module whose equation is too long to be read goes without a comment.
    StepTexts texts(equations_);
    for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
        const StepId step = grafcet_.steps.id_at(i);
        const std::string name = "X" + grafcet_.steps[step].name;
        builder_.work_on(builder_.add_module(name, texts.equation(step)),
                         builder_.origin_of_step(step));
        logic_.owner = name;
        const PhaseSignals phase = phase_of(step);
        logic_.owner = name;
        make_phase_(build_, phase);
        if (!equations_.options.modes) {
            builder_.set_initial(phase.x, phase.initial);
        }
    }
}

void AsynchronousFrame::make_outputs() {
    for (const OutputEquation& equation : equations_.outputs) {
        const Output& output = grafcet_.outputs[equation.output];
        const NetId net = logic_.outputs[index_of(equation.output)];
        const auto origin = builder_.add_origin(Origin::Kind::output, output.name, output.where);
        builder_.work_on(builder_.add_module(
                             output.name, fmt::format("{} = {}", output.name,
                                                      equation_text(equations_, equation.value))),
                         origin);
        logic_.owner = output.name;
        if (is_constant(equations_.expressions, equation.value, false)) {
            builder_.add_cell(CellType::low, net, {});
            continue;
        }
        const Expressions& pool = equations_.expressions;
        if (pool.kind(equation.value) == ExprKind::disjunction) {
            std::vector<NetId> terms;
            const auto operands = pool.operands(equation.value);
            for (const ExprId term : std::vector<ExprId>(operands.begin(), operands.end())) {
                terms.push_back(logic_.net(term));
            }
            builder_.drive(net, CellType::or_gate, terms);
        } else {
            builder_.drive(net, CellType::and_gate, logic_.factors(equation.value));
        }
    }
}

Netlist make_asynchronous(Equations& equations, PhaseMaker make_phase, Time set_time) {
    return AsynchronousFrame(equations, make_phase, set_time).make();
}

}  // namespace grafwire
