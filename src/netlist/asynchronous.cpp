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

#include "netlist/asynchronous.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "equations/logic.h"
#include "equations/write_equations.h"

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

namespace {

/// Notes which stored outputs and vars an expression reads now (not through an edge or a delay).
void mark_read(const Expressions& pool, ExprId id, std::vector<std::uint8_t>& outputs,
               std::vector<std::uint8_t>& vars) {
    if (id == no_expr) return;
    if (pool.kind(id) == ExprKind::variable) {
        const Variable variable = pool.variable_of(id);
        if (variable.kind == VariableKind::output) outputs[variable.index] = 1;
        if (variable.kind == VariableKind::var) vars[variable.index] = 1;
    }
    if (pool.kind(id) == ExprKind::rise || pool.kind(id) == ExprKind::fall) return;
    for (const ExprId operand : pool.operands(id)) mark_read(pool, operand, outputs, vars);
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

/// Builds one netlist; the members are what its parts share.
class Frame {
  public:
    Frame(Equations& equations, PhaseMaker make_phase, unsigned set_depth)
        : equations_(equations),
          grafcet_(*equations.grafcet),
          builder_(grafcet_),
          logic_(equations, builder_),
          build_{equations,
                 builder_,
                 logic_,
                 transitions_by_step(grafcet_),
                 std::vector<NetId>(grafcet_.transitions.size(), no_net),
                 writing_steps(equations)},
          make_phase_(make_phase) {
        logic_.pulse_width = set_depth * nanosecond;
    }

    Netlist make() {
        make_ports();
        make_steps();
        make_outputs();
        make_stored();
        Netlist& netlist = builder_.netlist();
        netlist.has_modes = equations_.options.modes;
        netlist.step_count = grafcet_.steps.size();
        return builder_.finish();
    }

  private:
    void make_ports();
    void make_steps();
    PhaseSignals phase_of(StepId step);
    std::vector<std::vector<NetId>> cdx_of(StepId step);
    void make_outputs();
    void make_stored();
    void make_latch(const StoredEquation& stored);
    void make_hold(const StoredEquation& stored);
    NetId trigger_net(const StoredWrite& write);
    NetId stored_net(Variable target) const;

    Equations& equations_;
    const Grafcet& grafcet_;
    NetlistBuilder builder_;
    LogicBuilder logic_;
    AsynchronousBuild build_;
    PhaseMaker make_phase_;
    NetId init_ = no_net;
    NetId au_dur_ = no_net;
    NetId au_doux_ = no_net;
    std::vector<NetId> held_outputs_;
    std::vector<NetId> held_vars_;
};

void Frame::make_ports() {
    Netlist& netlist = builder_.netlist();
    for (std::size_t i = 0; i < grafcet_.all_input_count(); ++i) {
        if (i >= grafcet_.inputs.size() && !equations_.options.modes) {
            logic_.inputs.push_back(no_net);
            continue;
        }
        const std::string name(input_name(grafcet_, i));
        const NetId net = builder_.add_port_net(name);
        netlist.inputs.push_back({name, net});
        logic_.inputs.push_back(net);
    }
    const std::size_t controls = grafcet_.inputs.size();
    init_ = logic_.inputs[controls];
    au_dur_ = logic_.inputs[controls + 1];
    au_doux_ = logic_.inputs[controls + 2];
    for (const Step& step : grafcet_.steps) {
        const std::string name = "X" + step.name;
        const NetId net = builder_.add_port_net(name);
        netlist.outputs.push_back({name, net});
        logic_.steps.push_back(net);
    }
    for (const Output& output : grafcet_.outputs) {
        const NetId net = builder_.add_port_net(output.name);
        netlist.outputs.push_back({output.name, net});
        logic_.outputs.push_back(net);
    }
    for (const Var& var : grafcet_.vars) {
        const NetId net = builder_.add_port_net(var.name);
        netlist.vars.push_back({var.name, {net}, 0});
        logic_.vars.push_back(net);
    }
    // The complements that every module shares stand with the inputs.
    if (init_ != no_net) builder_.inverted(init_);
    if (au_dur_ != no_net) builder_.inverted(au_dur_);
}

std::vector<std::vector<NetId>> Frame::cdx_of(StepId step) {
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

PhaseSignals Frame::phase_of(StepId step) {
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

void Frame::make_steps() {
    for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
        const StepId step = grafcet_.steps.id_at(i);
        const std::string name = "X" + grafcet_.steps[step].name;
        const std::string comment = fmt::format(
            "{} = {}", name, equation_text(equations_, step_expression(equations_, step)));
        builder_.work_on(builder_.add_module(name, comment), builder_.origin_of_step(step));
        logic_.owner = name;
        const PhaseSignals phase = phase_of(step);
        logic_.owner = name;
        make_phase_(build_, phase);
        if (!equations_.options.modes) {
            builder_.netlist().initial_values.push_back({phase.x, phase.initial});
        }
    }
}

void Frame::make_outputs() {
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

NetId Frame::stored_net(Variable target) const {
    return target.kind == VariableKind::output ? logic_.outputs[target.index]
                                               : logic_.vars[target.index];
}

NetId Frame::trigger_net(const StoredWrite& write) {
    return logic_.net(write.trigger);
}

/// A stored variable that is read by the right-hand side of a write is read through a hold latch
/// that closes while a write to it is under way: right-hand sides see variables as they were.
void Frame::make_hold(const StoredEquation& stored) {
    std::vector<NetId> triggers;
    for (const StoredWrite& write : stored.writes) triggers.push_back(trigger_net(write));
    const NetId source = stored_net(stored.target);
    const std::string name(builder_.netlist().names[source]);
    const NetId idle = builder_.gate(CellType::nor_gate, triggers, name, "idle");
    const NetId held = builder_.add_net(name, "held");
    const NetId pins[] = {source, idle};
    builder_.add_memory(CellType::hold_latch, held, pins, Logic::zero);
    auto& table = stored.target.kind == VariableKind::output ? held_outputs_ : held_vars_;
    table[stored.target.index] = held;
}

void Frame::make_latch(const StoredEquation& stored) {
    // set = OR of trigger . value . /(later triggers), reset likewise with /value.
    const Expressions& pool = equations_.expressions;
    std::vector<NetId> later;
    std::vector<NetId> sets;
    std::vector<NetId> resets;
    const std::string name(builder_.netlist().names[stored_net(stored.target)]);
    for (std::size_t i = stored.writes.size(); i-- != 0;) {
        const StoredWrite& write = stored.writes[i];
        const NetId trigger = trigger_net(write);
        std::vector<NetId> base{trigger};
        for (const NetId other : later) {
            if (other != trigger) base.push_back(builder_.inverted(other));
        }
        const bool hidden = std::find(later.begin(), later.end(), trigger) != later.end();
        later.push_back(trigger);
        if (hidden || is_constant(pool, write.trigger, false)) continue;
        const bool constant = pool.kind(write.value) == ExprKind::constant;
        const NetId value =
            constant ? no_net : logic_.held_signal(write.value, held_outputs_, held_vars_).net;
        for (const bool wanted : {true, false}) {
            if (constant && pool.constant_value(write.value) != wanted) continue;
            std::vector<NetId> pins = base;
            if (!constant) pins.push_back(wanted ? value : builder_.inverted(value));
            const NetId product =
                pins.size() == 1 ? pins[0]
                                 : builder_.gate(CellType::and_gate, pins, name,
                                                 fmt::format("{}{}", wanted ? "set" : "reset", i));
            (wanted ? sets : resets).push_back(product);
        }
    }
    const auto sum = [&](std::vector<NetId>& terms, std::string_view role) {
        std::reverse(terms.begin(), terms.end());
        if (terms.empty()) return builder_.low();
        return terms.size() == 1 ? terms[0] : builder_.gate(CellType::or_gate, terms, name, role);
    };
    const NetId set = sum(sets, "set");
    const NetId reset = sum(resets, "reset");
    const NetId pins[] = {set, reset};
    builder_.add_memory(CellType::latch, stored_net(stored.target), pins, Logic::zero);
}

void Frame::make_stored() {
    held_outputs_.assign(grafcet_.outputs.size(), no_net);
    held_vars_.assign(grafcet_.vars.size(), no_net);
    const auto work_on = [&](const StoredEquation& stored) {
        const bool is_output = stored.target.kind == VariableKind::output;
        const std::string name(builder_.netlist().names[stored_net(stored.target)]);
        const Location where = is_output ? grafcet_.outputs[OutputId{stored.target.index}].where
                                         : grafcet_.vars[VarId{stored.target.index}].where;
        const std::string comment =
            fmt::format("{}: set {} reset {}", name, equation_text(equations_, stored.set),
                        equation_text(equations_, stored.reset));
        const auto origin =
            builder_.add_origin(is_output ? Origin::Kind::output : Origin::Kind::var, name, where);
        builder_.work_on(builder_.add_module(name, comment), origin);
        logic_.owner = name;
    };
    std::vector<std::uint8_t> output_read(grafcet_.outputs.size());
    std::vector<std::uint8_t> var_read(grafcet_.vars.size());
    for (const StoredEquation& stored : equations_.stored) {
        for (const StoredWrite& write : stored.writes) {
            mark_read(equations_.expressions, write.value, output_read, var_read);
        }
    }
    std::vector<std::uint8_t> driven(grafcet_.vars.size());
    for (const StoredEquation& stored : equations_.stored) {
        const bool is_output = stored.target.kind == VariableKind::output;
        if (stored.writes.empty()) continue;
        if ((is_output ? output_read : var_read)[stored.target.index] == 0) continue;
        work_on(stored);
        make_hold(stored);
    }
    for (const StoredEquation& stored : equations_.stored) {
        if (stored.writes.empty()) continue;
        if (stored.target.kind == VariableKind::var) driven[stored.target.index] = 1;
        work_on(stored);
        make_latch(stored);
    }
    for (std::size_t i = 0; i < driven.size(); ++i) {
        if (driven[i] != 0) continue;
        const Var& var = grafcet_.vars[grafcet_.vars.id_at(i)];
        builder_.work_on(builder_.add_module(var.name, var.name + " = 0"),
                         builder_.add_origin(Origin::Kind::var, var.name, var.where));
        builder_.add_cell(CellType::low, logic_.vars[i], {});
    }
}

}  // namespace

Netlist make_asynchronous(Equations& equations, PhaseMaker make_phase, unsigned set_depth) {
    return Frame(equations, make_phase, set_depth).make();
}

}  // namespace grafwire
