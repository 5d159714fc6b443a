// The gates of a wired chart. Every gate is a NAND, and what is said of it here is the list of its
// inputs; style_handshake.cpp says why they are these.
//
//   T  one per product of a transition: 0 while the token is being given
//   U  one per further follower of a divergence: 0 while it is being given on
//   R  one per further step before a convergence: 0 while it is being reset
//   X  and B, its complement (`q`): one pair a step
//
// G and H are no gates but lists of nets that are 1 once the arrival in a step is complete, and
// once a step has gone.

#include "netlist/styles/handover_gates.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <string>

#include "netlist/styles/handover_nets.h"
#include "netlist/styles/nand_logic.h"

namespace grafwire {

namespace {

class HandoverGates {
  public:
    HandoverGates(const Grafcet& grafcet, const Equations& equations, const HandoverChart& wired)
        : grafcet_(grafcet),
          equations_(equations),
          wired_(wired),
          chart_(grafcet),
          variables_(chart_.add_ports(equations.options.modes)),
          logic_(grafcet, equations, chart_, variables_),
          nets_(grafcet, equations, wired, variables_, chart_.builder()) {}

    Netlist make() {
        make_controls();
        add_modules();
        find_polarities();
        for (std::size_t i = 0; i < wired_.links.size(); ++i) make_link(wired_.links.id_at(i));
        for (std::size_t i = 0; i < wired_.forcings.size(); ++i) make_completion(i);
        for (std::size_t i = 0; i < wired_.steps.size(); ++i) make_step(wired_.steps.id_at(i));
        make_ports_of_parts();
        make_outputs();
        make_stored();
        return chart_.finish(equations_.options.modes, no_net);
    }

  private:
    void make_controls();
    void add_modules();
    void find_polarities();
    GateMaker gates_of(const Link& link);
    GateMaker gates_of(WiredStepId step);

    // What a receptivity takes in.
    Nets literal(const WiredLiteral& literal, const GateMaker& gates);
    Nets input_literal(const WiredLiteral& literal, const GateMaker& gates);
    Nets time_literal(const WiredLiteral& literal, bool is_own, const GateMaker& gates);
    NetId behind(NetId complement, const GateMaker& gates);

    // Gates.
    void make_link(LinkId id);
    void make_transition(LinkId id, const GateMaker& gates);
    void make_fork(LinkId id, const GateMaker& gates);
    void make_join(LinkId id, const GateMaker& gates);
    void make_merge(LinkId id, const GateMaker& gates);
    void make_completion(std::size_t forcing);
    void make_step(WiredStepId id);
    void make_writes(WiredStepId id, const GateMaker& gates);
    std::vector<WiredStepId> hidden_between(WiredStepId part,
                                            const std::vector<WiredStepId>& parts) const;
    void make_ports_of_parts();
    void make_outputs();
    void make_stored();

    const Grafcet& grafcet_;
    const Equations& equations_;
    const HandoverChart& wired_;
    ChartNetlist chart_;
    const VariableNets variables_;
    NandLogic logic_;
    HandoverNets nets_;
    std::vector<GateMaker> modules_;  ///< per step of the GRAFCET
    std::map<NetId, NetId> behind_;
    std::vector<std::uint8_t> read_both_ways_;       ///< per input
    std::vector<std::uint8_t> time_read_both_ways_;  ///< per expression
};

void HandoverGates::make_controls() {
    if (!equations_.options.modes) return;
    const GateMaker gates = chart_.at_inputs();
    const NetId init = variables_.control(grafcet_, ControlInput::init);
    nets_.not_au_dur = gates.inverted(variables_.control(grafcet_, ControlInput::au_dur));
    nets_.start = gates.named("Init").gate(CellType::nand_gate, {init, nets_.not_au_dur}, "start");
}

void HandoverGates::add_modules() {
    for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
        const StepId step = grafcet_.steps.id_at(i);
        modules_.push_back(
            chart_.add_module("X" + grafcet_.steps[step].name, chart_.origin_of(step)));
    }
}

/// A transition stands in the module of the step that it leads to.
GateMaker HandoverGates::gates_of(const Link& link) {
    const WiredStepId at = link.following.empty() ? link.preceding[0] : link.following[0];
    return modules_[index_of(wired_.steps[at].home)]
        .made_for(chart_.origin_of(link.transition))
        .named(nets_.owner_of(link));
}

GateMaker HandoverGates::gates_of(WiredStepId id) {
    const WiredStep& step = wired_.steps[id];
    const GateMaker& module = modules_[index_of(step.home)];
    const std::string owner(chart_.builder().name_of(nets_.of(id).x));
    if (!step.is_hidden()) return module.named(owner);
    return module.made_for(chart_.origin_of(step.via)).named(owner);
}

void HandoverGates::find_polarities() {
    std::vector<std::uint8_t> inputs(grafcet_.all_input_count());
    std::vector<std::uint8_t> times(equations_.expressions.size());
    const auto note = [&](const WiredLiteral& literal) {
        const std::uint8_t way = literal.negated ? 2 : 1;
        if (literal.kind == WiredLiteral::Kind::input) inputs[literal.index] |= way;
        if (literal.kind == WiredLiteral::Kind::time) times[literal.index] |= way;
    };
    for (const Link& link : wired_.links) {
        for (const WiredProduct& product : link.products) {
            for (const WiredLiteral& literal : product) {
                note(literal);
                if (literal.kind != WiredLiteral::Kind::time || literal.negated) continue;
                const auto& condition = wired_.conditions.at(static_cast<ExprId>(literal.index));
                std::for_each(condition.begin(), condition.end(), note);
            }
        }
    }
    for (const std::uint8_t ways : inputs) read_both_ways_.push_back(ways == 3 ? 1 : 0);
    for (const std::uint8_t ways : times) time_read_both_ways_.push_back(ways == 3 ? 1 : 0);
}

/// The signal once more, behind its complement: what reads it both ways reads this with it, so as
/// not to act on a complement that is late.
NetId HandoverGates::behind(NetId complement, const GateMaker& gates) {
    const auto [at, is_new] = behind_.emplace(complement, no_net);
    if (is_new) {
        const std::string owner(chart_.builder().name_of(complement));
        at->second = gates.named(owner).gate(CellType::nand_gate, {complement}, "back");
    }
    return at->second;
}

Nets HandoverGates::input_literal(const WiredLiteral& literal, const GateMaker& gates) {
    const NetId net = variables_.inputs[literal.index];
    if (net == no_net) return {literal.negated ? gates.high() : gates.low()};
    const GateMaker at_inputs = chart_.at_inputs();
    if (literal.negated) return {at_inputs.inverted(net)};
    if (read_both_ways_[literal.index] == 0) return {net};
    const NetId complement = at_inputs.inverted(net);
    return {net, behind(complement, at_inputs)};
}

Nets HandoverGates::time_literal(const WiredLiteral& literal, bool is_own, const GateMaker& gates) {
    const auto id = static_cast<ExprId>(literal.index);
    const NetId timer = logic_.timer(id, gates);
    if (literal.negated) return {gates.inverted(timer)};
    Nets result{timer};
    if (time_read_both_ways_[literal.index] != 0) {
        result.push_back(behind(gates.inverted(timer), gates));
    }
    if (is_own) return result;
    for (const WiredLiteral& part : wired_.conditions.at(id))
        add_nets(result, this->literal(part, gates));
    return result;
}

Nets HandoverGates::literal(const WiredLiteral& literal, const GateMaker& gates) {
    if (literal.kind == WiredLiteral::Kind::input) return input_literal(literal, gates);
    if (literal.kind == WiredLiteral::Kind::time) return time_literal(literal, false, gates);
    if (literal.kind == WiredLiteral::Kind::stored) return nets_.stored_literal(literal);
    const auto step = static_cast<WiredStepId>(literal.index);
    if (literal.negated) return nets_.left(step);
    Nets result{nets_.of(step).x};
    add_nets(result, nets_.arrived(step));
    add_nets(result, nets_.completed(step));
    add_nets(result, nets_.enclosing_lines(grafcet_.steps[wired_.steps[step].home].graph));
    return result;
}

void HandoverGates::make_link(LinkId id) {
    const Link& link = wired_.links[id];
    const GateMaker gates = gates_of(link);
    if (link.is_merge) return make_merge(id, gates);
    make_transition(id, gates);
    if (link.following.size() > 1) make_fork(id, gates);
    if (link.preceding.size() > 1) make_join(id, gates);
}

void HandoverGates::make_transition(LinkId id, const GateMaker& gates) {
    const Link& link = wired_.links[id];
    const bool is_fork = link.following.size() > 1;
    for (std::size_t i = 0; i < link.products.size(); ++i) {
        Nets pins;
        for (std::size_t p = 0; p < link.preceding.size(); ++p) {
            const bool is_timed = !is_fork && p == 0 && link.timed_step == 0;
            if (!is_timed) pins.push_back(nets_.of(link.preceding[p]).x);
        }
        for (const WiredLiteral& each : link.products[i]) {
            const bool is_own = each.kind == WiredLiteral::Kind::time && !each.negated &&
                                static_cast<ExprId>(each.index) == link.timer;
            add_nets(pins, is_own ? time_literal(each, true, gates) : literal(each, gates));
        }
        for (const WiredStepId step : link.preceding) {
            add_nets(pins, nets_.arrived(step));
            add_nets(pins, nets_.completed(step));
            add_nets(pins, nets_.written(step));
        }
        if (is_fork) pins.push_back(nets_.of(link.following[0]).b);
        add_nets(pins, nets_.freezing_lines(link));
        add_nets(pins, nets_.lines_of_transitions(link));
        gates.drive(nets_.of(id).t[i], CellType::nand_gate, distinct(pins));
    }
}

/// The token is given on from branch to branch; the last one resets the step before.
void HandoverGates::make_fork(LinkId id, const GateMaker& gates) {
    const Link& link = wired_.links[id];
    const HandoverNets::OfLink& nets = nets_.of(id);
    for (std::size_t j = 1; j < link.following.size(); ++j) {
        const bool is_last = j + 1 == link.following.size();
        Nets pins;
        if (is_last && link.timed_step == 0) {
            pins.push_back(logic_.timer(link.timer, gates));
        } else {
            pins.push_back(nets_.of(link.preceding[0]).x);
        }
        pins.push_back(nets_.of(link.following[j - 1]).x);
        if (j == 1) {
            add_nets(pins, nets.t);
        } else {
            pins.push_back(nets.u[j - 2]);
        }
        if (!is_last) pins.push_back(nets_.of(link.following[j]).b);
        add_nets(pins, nets_.lines_of_transitions(link));
        gates.drive(nets.u[j - 1], CellType::nand_gate, distinct(pins));
    }
}

void HandoverGates::make_join(LinkId id, const GateMaker& gates) {
    const Link& link = wired_.links[id];
    const HandoverNets::OfLink& nets = nets_.of(id);
    for (std::size_t i = 1; i < link.preceding.size(); ++i) {
        Nets pins{nets_.of(link.following[0]).x};
        add_nets(pins, nets.t);
        pins.push_back(link.timed_step == i ? logic_.timer(link.timer, gates)
                                            : nets_.of(link.preceding[i]).x);
        gates.drive(nets.r[i - 1], CellType::nand_gate, distinct(pins));
    }
}

/// The token goes on into an idle step, or into one that is active anyway.
void HandoverGates::make_merge(LinkId id, const GateMaker& gates) {
    const Link& link = wired_.links[id];
    const HandoverNets::OfLink& nets = nets_.of(id);
    const HandoverNets::OfStep& from = nets_.of(link.preceding[0]);
    const HandoverNets::OfStep& to = nets_.of(link.following[0]);
    Nets common{from.x};
    add_nets(common, nets_.arrived(link.preceding[0]));
    Nets give = common;
    give.push_back(to.b);
    add_nets(give, nets_.lines_of_transitions(link));
    gates.drive(nets.t[0], CellType::nand_gate, distinct(give));
    Nets merged = common;
    add_nets(merged, {to.x, nets.t[0]});
    add_nets(merged, nets_.lines_of_transitions(link));
    gates.drive(nets.s, CellType::nand_gate, distinct(merged));
}

void HandoverGates::make_completion(std::size_t number) {
    const WiredForcing& forcing = wired_.forcings[number];
    if (!forcing.has_completion) return;
    const HandoverNets::OfForcing& nets = nets_.of_forcing(number);
    const GateMaker gates = gates_of(forcing.step);
    Nets common{nets_.of(forcing.step).x};
    add_nets(common, nets_.arrived(forcing.step));
    Nets all_off;
    for (std::size_t i = 0; i < forcing.off.size(); ++i) {
        Nets pins = common;
        pins.push_back(nets_.of(forcing.off[i]).x);
        gates.drive(nets.q[i], CellType::nand_gate, distinct(pins));
        add_nets(all_off, {nets_.of(forcing.off[i]).b, nets.q[i]});
    }
    for (std::size_t i = 0; i < forcing.on.size(); ++i) {
        Nets pins = common;
        pins.push_back(nets_.of(forcing.on[i]).b);
        add_nets(pins, all_off);
        gates.drive(nets.v[i], CellType::nand_gate, distinct(pins));
    }
}

void HandoverGates::make_step(WiredStepId id) {
    const WiredStep& step = wired_.steps[id];
    const HandoverNets::OfStep& nets = nets_.of(id);
    const GateMaker gates = gates_of(id);
    Nets x;
    Nets b{nets.x};
    for (const LinkId into : step.into) add_nets(x, nets_.setting(id, into));
    for (const LinkId out : step.out_of) add_nets(b, nets_.resetting(id, out));
    for (std::size_t i = 0; i < wired_.forcings.size(); ++i) {
        add_nets(x, nets_.switching_on(id, i));
        add_nets(b, nets_.switching_off(id, i));
    }
    x.push_back(nets.b);
    add_nets(b, nets_.enclosing_lines(grafcet_.steps[step.home].graph));
    if (nets_.start != no_net) {
        (step.starts ? x : b).push_back(nets_.start);
        (step.outlasts_au_dur ? x : b).push_back(nets_.not_au_dur);
    }
    gates.drive(nets.x, CellType::nand_gate, distinct(x));
    gates.drive(nets.b, CellType::nand_gate, distinct(b));
    make_writes(id, gates);
}

/// A write goes on until the variable has the value.
void HandoverGates::make_writes(WiredStepId id, const GateMaker& gates) {
    const WiredStep& step = wired_.steps[id];
    for (std::size_t i = 0; i < step.writes.size(); ++i) {
        const HandoverNets::OfStored& stored = nets_.of_stored(step.writes[i].first);
        Nets pins{nets_.of(id).x};
        add_nets(pins, nets_.arrived(id));
        pins.push_back(step.writes[i].second ? stored.complement : stored.value);
        gates.drive(nets_.of(id).writes[i], CellType::nand_gate, distinct(pins));
    }
}

void HandoverGates::make_stored() {
    for (std::size_t i = 0; i < equations_.stored.size(); ++i) {
        const StoredEquation& stored = equations_.stored[i];
        const bool is_output = stored.target.kind == VariableKind::output;
        const std::uint32_t origin = is_output ? chart_.origin_of(OutputId{stored.target.index})
                                               : chart_.origin_of(VarId{stored.target.index});
        const HandoverNets::OfStored& nets = nets_.of_stored(i);
        const GateMaker gates =
            chart_.add_module(std::string(chart_.builder().name_of(nets.value)), origin);
        if (stored.writes.empty()) {
            gates.add_cell(CellType::low, nets.value, {});
            continue;
        }
        Nets value = nets.setting;
        value.push_back(nets.complement);
        Nets complement = nets.resetting;
        complement.push_back(nets.value);
        gates.drive(nets.value, CellType::nand_gate, value);
        gates.drive(nets.complement, CellType::nand_gate, complement);
    }
}

/// The hidden steps on the way from one part of a step to another, during which it stays active.
std::vector<WiredStepId> HandoverGates::hidden_between(
    WiredStepId part, const std::vector<WiredStepId>& parts) const {
    std::vector<WiredStepId> result;
    for (const LinkId out : wired_.steps[part].out_of) {
        for (const WiredStepId next : wired_.links[out].following) {
            if (!wired_.steps[next].is_hidden()) continue;
            for (const LinkId on : wired_.steps[next].out_of) {
                const std::vector<WiredStepId>& ends = wired_.links[on].following;
                const bool stays = std::any_of(ends.begin(), ends.end(), [&](WiredStepId end) {
                    return std::find(parts.begin(), parts.end(), end) != parts.end();
                });
                if (stays) result.push_back(next);
            }
        }
    }
    return result;
}

void HandoverGates::make_ports_of_parts() {
    for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
        const std::vector<WiredStepId>& parts = wired_.parts[grafcet_.steps.id_at(i)];
        if (parts.size() == 1) continue;
        Nets pins;
        for (const WiredStepId part : parts) {
            pins.push_back(modules_[i].inverted(nets_.of(part).x));
            for (const WiredStepId between : hidden_between(part, parts)) {
                pins.push_back(modules_[i].inverted(nets_.of(between).x));
            }
        }
        modules_[i].drive(variables_.steps[i], CellType::nand_gate, pins);
    }
}

void HandoverGates::make_outputs() {
    for (const OutputEquation& equation : equations_.outputs) {
        logic_.drive(variables_.outputs[index_of(equation.output)], equation.value,
                     chart_.add_module(grafcet_.outputs[equation.output].name,
                                       chart_.origin_of(equation.output)));
    }
    for (const HeldEquation& equation : equations_.held) {
        logic_.drive(
            variables_.vars[index_of(equation.var)], equation.value,
            chart_.add_module(grafcet_.vars[equation.var].name, chart_.origin_of(equation.var)));
    }
}

}  // namespace

Netlist handover_netlist(const Grafcet& grafcet, const Equations& equations,
                         const HandoverChart& handover) {
    return HandoverGates(grafcet, equations, handover).make();
}

}  // namespace grafwire
