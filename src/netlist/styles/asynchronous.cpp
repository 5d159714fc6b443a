// The frame of the asynchronous styles: inputs, one module per step as the style makes it (the
// "module de phase" of the course "Mise en œuvre du GRAFCET"), outputs, stored outputs and vars.
//
// The module of a step is where all that bears on it meets: the transitions into it, CDX, Init,
// AUdur, forcing orders and enclosures. Its parts come from the equations; what a style decides is
// only how a memory is made of gates. Clearing conditions are made once and shared by the steps
// that a transition activates, so that these are set by one and the same signal.
//
// Edges are pulse cells. The width of a pulse equals the delay from the pulse to the X it sets: any
// shorter and the memory would not hold by itself, any longer and the pulse would still be there
// when the next step becomes active, and clear the transition after it as well.

#include "netlist/styles/asynchronous.h"

#include <fmt/format.h>

#include <algorithm>

#include "equations/logic.h"

namespace grafwire {

namespace {

/// Per step: 1 where its activation, or the clearing of a transition before it, writes a stored
/// output or var.
std::vector<std::uint8_t> steps_with_writes(const Grafcet& grafcet, const Equations& equations) {
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

}  // namespace

AsynchronousBuild::AsynchronousBuild(const Grafcet& chart_of, const Equations& equations_of,
                                     const DelayModel& delays_for, Time pulse_width)
    : grafcet(chart_of),
      equations(equations_of),
      delays(delays_for),
      chart(grafcet),
      nets(chart.add_ports(equations.options.modes)),
      logic(grafcet, equations, chart, nets, delays, pulse_width),
      links(transitions_by_step(grafcet)),
      clearing_(grafcet.transitions.size(), no_net),
      writing_steps_(steps_with_writes(grafcet, equations)) {}

/// Whether a step after the transition leads straight back to one before it.
bool AsynchronousBuild::is_in_loop_of_two(TransitionId transition) const {
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
std::vector<NetId> AsynchronousBuild::clearing_factors(TransitionId transition,
                                                       const GateMaker& gates) {
    const ExprId frozen = equations.frozen[grafcet.transitions[transition].graph];
    const bool freezes_late = frozen != no_expr && is_in_loop_of_two(transition);
    std::vector<NetId> factors = logic.clearing_factors(
        equations.clearing[transition], writing_steps_, freezes_late ? frozen : no_expr, gates);
    if (factors.empty()) factors.push_back(gates.high());
    return factors;
}

NetId AsynchronousBuild::clearing_net(TransitionId transition, const GateMaker& gates) {
    NetId& net = clearing_[index_of(transition)];
    if (net == no_net) {
        const GateMaker own = gates.made_for(chart.origin_of(transition))
                                  .named("T" + grafcet.transitions[transition].name);
        net = own.joined(CellType::and_gate, clearing_factors(transition, own), "clear");
    }
    return net;
}

namespace {

std::vector<ExprId> terms_of(const Expressions& pool, ExprId id) {
    if (pool.kind(id) != ExprKind::disjunction) return {id};
    const std::span<const ExprId> operands = pool.operands(id);
    return {operands.begin(), operands.end()};
}

/// CDX of a step as products of nets; none where it is constant, for a step that nothing follows.
std::vector<std::vector<NetId>> cdx_of(AsynchronousBuild& build, StepId step,
                                       const GateMaker& gates) {
    std::vector<std::vector<NetId>> products;
    const Equations& equations = build.equations;
    const ExprId cdx = equations.steps[step].cdx;
    if (equations.expressions.kind(cdx) == ExprKind::constant) return products;
    // A term of the transition form is a clearing condition that has its gate already.
    for (const ExprId term : terms_of(equations.expressions, cdx)) {
        std::vector<NetId> factors;
        for (const TransitionId out : build.links.out_of_step(step)) {
            if (equations.clearing[out] == term) factors = {build.clearing_net(out, gates)};
        }
        if (factors.empty()) factors = build.logic.factors(term, gates);
        products.push_back(std::move(factors));
    }
    return products;
}

StepSignals signals_of(AsynchronousBuild& build, StepId step, const GateMaker& gates) {
    const StepEquation& equation = build.equations.steps[step];
    LogicBuilder& logic = build.logic;
    StepSignals signals;
    signals.step = step;
    signals.x = build.nets.steps[index_of(step)];
    signals.initial = equation.initial;
    signals.init = build.control(ControlInput::init);
    if (signals.init != no_net) {
        signals.not_init = gates.inverted(signals.init);
        signals.not_au_dur = gates.inverted(build.control(ControlInput::au_dur));
    }
    if (equation.forced_off != no_expr) {
        signals.forced_off = logic.signal(equation.forced_off, gates);
    }
    if (equation.forced_on != no_expr) signals.forced_on = logic.signal(equation.forced_on, gates);
    if (equation.enclosing != no_expr) signals.enclosing = logic.net(equation.enclosing, gates);
    if (equation.link != no_expr) signals.link = logic.factors(equation.link, gates);
    for (const TransitionId into : build.links.into_step(step)) {
        const ExprId clearing = build.equations.clearing[into];
        if (!is_constant(build.equations.expressions, clearing, false)) {
            signals.into.push_back(into);
        }
    }
    signals.cdx = cdx_of(build, step, gates);
    return signals;
}

void make_steps(AsynchronousBuild& build, const AsynchronousStyle& style) {
    const Grafcet& grafcet = build.grafcet;
    for (std::size_t i = 0; i < grafcet.steps.size(); ++i) {
        const StepId step = grafcet.steps.id_at(i);
        const GateMaker gates =
            build.chart.add_module("X" + grafcet.steps[step].name, build.chart.origin_of(step));
        const StepSignals signals = signals_of(build, step, gates);
        style.make_step(build, signals, gates);
        if (!build.equations.options.modes) {
            build.chart.builder().set_initial(signals.x, signals.initial);
        }
    }
}

/// Drives a net with the value of an equation: a sum of products, or one product.
void drive(AsynchronousBuild& build, NetId net, ExprId value, const GateMaker& gates) {
    const Expressions& pool = build.equations.expressions;
    if (is_constant(pool, value, false)) {
        gates.add_cell(CellType::low, net, {});
    } else if (pool.kind(value) == ExprKind::disjunction) {
        std::vector<NetId> terms;
        for (const ExprId term : terms_of(pool, value)) {
            terms.push_back(build.logic.net(term, gates));
        }
        gates.drive(net, CellType::or_gate, terms);
    } else {
        gates.drive(net, CellType::and_gate, build.logic.factors(value, gates));
    }
}

/// Outputs, then the vars that steps hold: nothing reads their nets, whoever reads such a var has
/// its equation in place; they are there to be seen.
void make_outputs(AsynchronousBuild& build) {
    for (const OutputEquation& equation : build.equations.outputs) {
        drive(build, build.nets.outputs[index_of(equation.output)], equation.value,
              build.chart.add_module(build.grafcet.outputs[equation.output].name,
                                     build.chart.origin_of(equation.output)));
    }
    for (const HeldEquation& equation : build.equations.held) {
        drive(build, build.nets.vars[index_of(equation.var)], equation.value,
              build.chart.add_module(build.grafcet.vars[equation.var].name,
                                     build.chart.origin_of(equation.var)));
    }
}

// Stored outputs and vars: a latch each, set and reset by the pulses of
// their writes. Where several writes happen at once the last one wins, so each write is blocked by
// the triggers of the later ones.

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

class StoredLatches {
  public:
    explicit StoredLatches(AsynchronousBuild& build)
        : build_(build),
          grafcet_(build.grafcet),
          pool_(build.equations.expressions),
          held_{std::vector<NetId>(grafcet_.outputs.size(), no_net),
                std::vector<NetId>(grafcet_.vars.size(), no_net)} {}

    void make() {
        // The hold latches have modules of their own: all are made before what reads them.
        make_holds();
        for (const StoredEquation& stored : build_.equations.stored) {
            if (!stored.writes.empty()) make_latch(stored, module_of(stored.target, ""));
        }
        for (const StoredEquation& stored : build_.equations.stored) {
            if (!stored.writes.empty() || stored.target.kind != VariableKind::var) continue;
            const GateMaker gates = module_of(stored.target, "");
            gates.add_cell(CellType::low, net_of(stored.target), {});
        }
    }

  private:
    GateMaker module_of(Variable target, std::string_view part) {
        const std::uint32_t origin = target.kind == VariableKind::output
                                         ? build_.chart.origin_of(OutputId{target.index})
                                         : build_.chart.origin_of(VarId{target.index});
        return build_.chart.add_module(name_of(target) + std::string(part), origin);
    }
    std::string name_of(Variable target) const {
        return target.kind == VariableKind::output ? grafcet_.outputs[OutputId{target.index}].name
                                                   : grafcet_.vars[VarId{target.index}].name;
    }
    NetId net_of(Variable target) const {
        const VariableNets& nets = build_.nets;
        return (target.kind == VariableKind::output ? nets.outputs : nets.vars)[target.index];
    }

    void make_holds();
    void make_hold(const StoredEquation& stored, const GateMaker& gates);
    void make_latch(const StoredEquation& stored, const GateMaker& gates);

    AsynchronousBuild& build_;
    const Grafcet& grafcet_;
    const Expressions& pool_;
    LogicBuilder::HeldNets held_;
};

void StoredLatches::make_holds() {
    std::vector<std::uint8_t> output_read(grafcet_.outputs.size());
    std::vector<std::uint8_t> var_read(grafcet_.vars.size());
    for (const StoredEquation& stored : build_.equations.stored) {
        for (const StoredWrite& write : stored.writes) {
            mark_read(pool_, write.value, output_read, var_read);
        }
    }
    for (const StoredEquation& stored : build_.equations.stored) {
        const bool is_output = stored.target.kind == VariableKind::output;
        if (stored.writes.empty()) continue;
        if ((is_output ? output_read : var_read)[stored.target.index] == 0) continue;
        make_hold(stored, module_of(stored.target, "$hold"));
    }
}

/// A stored variable that is read by the right-hand side of a write is read through a hold latch
/// that closes while a write to it is under way: right-hand sides see variables as they were.
void StoredLatches::make_hold(const StoredEquation& stored, const GateMaker& gates) {
    std::vector<NetId> triggers;
    for (const StoredWrite& write : stored.writes) {
        triggers.push_back(build_.logic.net(write.trigger, gates));
    }
    const NetId source = net_of(stored.target);
    const GateMaker own = gates.named(name_of(stored.target));
    const NetId idle = own.gate(CellType::nor_gate, triggers, "idle");
    const NetId held = own.add_net("held");
    const NetId pins[] = {source, idle};
    own.add_cell(CellType::hold_latch, held, pins, {Logic::zero, {}});
    const bool is_output = stored.target.kind == VariableKind::output;
    (is_output ? held_.outputs : held_.vars)[stored.target.index] = held;
}

void StoredLatches::make_latch(const StoredEquation& stored, const GateMaker& gates) {
    // set = OR of trigger . value . /(later triggers), reset likewise with /value.
    std::vector<NetId> later;
    std::vector<NetId> sets;
    std::vector<NetId> resets;
    for (std::size_t i = stored.writes.size(); i-- != 0;) {
        const StoredWrite& write = stored.writes[i];
        const NetId trigger = build_.logic.net(write.trigger, gates);
        std::vector<NetId> base{trigger};
        for (const NetId other : later) {
            if (other != trigger) base.push_back(gates.inverted(other));
        }
        const bool hidden = std::find(later.begin(), later.end(), trigger) != later.end();
        later.push_back(trigger);
        if (hidden || is_constant(pool_, write.trigger, false)) continue;
        const bool constant = pool_.kind(write.value) == ExprKind::constant;
        const NetId value =
            constant ? no_net : build_.logic.held_signal(write.value, held_, gates).net;
        for (const bool wanted : {true, false}) {
            if (constant && pool_.constant_value(write.value) != wanted) continue;
            std::vector<NetId> pins = base;
            if (!constant) pins.push_back(wanted ? value : gates.inverted(value));
            (wanted ? sets : resets)
                .push_back(gates.joined(CellType::and_gate, pins,
                                        fmt::format("{}{}", wanted ? "set" : "reset", i)));
        }
    }
    const auto sum = [&](std::vector<NetId>& terms, std::string_view role) {
        std::reverse(terms.begin(), terms.end());
        return terms.empty() ? gates.low() : gates.joined(CellType::or_gate, terms, role);
    };
    const NetId set = sum(sets, "set");
    const NetId reset = sum(resets, "reset");
    const NetId pins[] = {set, reset};
    gates.add_cell(CellType::latch, net_of(stored.target), pins, {Logic::zero, {}});
}

}  // namespace

Netlist make_asynchronous(const Grafcet& grafcet, const Equations& equations,
                          const AsynchronousStyle& style, const DelayModel& delays) {
    AsynchronousBuild build(grafcet, equations, delays, delays.of_path(style.path_of_set));
    if (equations.options.modes) {
        // The complements that every module shares stand with the inputs.
        const GateMaker gates = build.chart.at_inputs();
        gates.inverted(build.control(ControlInput::init));
        gates.inverted(build.control(ControlInput::au_dur));
    }
    make_steps(build, style);
    make_outputs(build);
    StoredLatches(build).make();
    return build.chart.finish(equations.options.modes, no_net);
}

}  // namespace grafwire
