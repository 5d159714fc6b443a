// The evolution of the situation within one scan of the clocked style: clearing, Ts = Tp./Td + Ta,
// forcing, enclosures, AUdur.

#include <fmt/format.h>

#include <algorithm>

#include "equations/equation_text.h"
#include "grafcet/enclosures.h"
#include "netlist/styles/clocked_build.h"

namespace grafwire {

NetId ClockedBuild::frozen_gate(GraphId graph) {
    if (equations_.frozen[graph] == no_expr) return no_net;
    NetId& gate_net = may_evolve_[index_of(graph)];
    if (gate_net == no_net) {
        gate_net = builder_.add_net("X" + grafcet_.graphs[graph].name, "may_evolve");
    }
    return gate_net;
}

void ClockedBuild::make_clearing() {
    may_evolve_.assign(grafcet_.graphs.size(), no_net);
    for (std::size_t i = 0; i < grafcet_.transitions.size(); ++i) {
        const TransitionId id = grafcet_.transitions.id_at(i);
        const Transition& transition = grafcet_.transitions[id];
        const std::string owner = "T" + transition.name;
        work_on(owner, builder_.origin_of_transition(id));
        role_ = 0;
        std::vector<NetId> pins;
        for (const StepId step : grafcet_.preceding(transition)) {
            pins.push_back(now_.steps[index_of(step)]);
        }
        const ExprId receptivity = equations_.from_grafcet[index_of(transition.receptivity)];
        const bool always =
            pool_.kind(receptivity) == ExprKind::constant && pool_.constant_value(receptivity);
        if (!always) pins.push_back(net(now_, receptivity));
        if (const NetId gate_net = frozen_gate(transition.graph); gate_net != no_net) {
            pins.push_back(gate_net);
        }
        if (not_init_ != no_net) pins.push_back(not_init_);
        if (pins.empty()) pins.push_back(builder_.high());
        clearing_.push_back(gate(CellType::and_gate, pins, "clear"));
    }
}

/// Ts = Tp . /Td + Ta, and Init.
NetId ClockedBuild::scan_end_without_orders(StepId step) {
    const std::size_t controls = grafcet_.inputs.size();
    std::vector<NetId> causes;
    for (const TransitionId into : links_.into_step(step)) {
        causes.push_back(clearing_[index_of(into)]);
    }
    std::vector<NetId> hold{now_.steps[index_of(step)]};
    for (const TransitionId out : links_.out_of_step(step)) {
        hold.push_back(builder_.inverted(clearing_[index_of(out)]));
    }
    const bool initial = grafcet_.steps[step].initial;
    if (!initial && not_init_ != no_net) hold.push_back(not_init_);
    causes.push_back(hold.size() == 1 ? hold[0] : gate(CellType::and_gate, hold, "hold"));
    if (initial && not_init_ != no_net) causes.push_back(inputs_[controls]);
    return causes.size() == 1 ? causes[0] : gate(CellType::or_gate, causes, "evolved");
}

void ClockedBuild::make_evolution() {
    std::vector<NetId> situation;
    std::vector<ModuleId> modules;
    for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
        const StepId step = grafcet_.steps.id_at(i);
        const std::string name = "X" + grafcet_.steps[step].name;
        work_on(name, builder_.origin_of_step(step),
                fmt::format("{} = {}", name,
                            equation_text(equations_, step_expression(equations_, step))));
        modules.push_back(builder_.module());
        situation.push_back(scan_end_without_orders(step));
    }
    after_step_4_ = situation;
    apply_forcing(situation);
    apply_enclosures(situation);
    for (std::size_t i = 0; i < situation.size(); ++i) {
        const StepId step = grafcet_.steps.id_at(i);
        builder_.work_on(modules[i], builder_.origin_of_step(step));
        std::vector<NetId> pins{situation[i]};
        if (not_au_dur_ != no_net) pins.push_back(not_au_dur_);
        builder_.drive(writing_.steps[i], CellType::and_gate, pins);
        flip_flop(now_.steps[i], writing_.steps[i], grafcet_.steps[step].initial);
    }
    for (std::size_t g = 0; g < may_evolve_.size(); ++g) {
        if (may_evolve_[g] == no_net) continue;
        const GraphId graph = grafcet_.graphs.id_at(g);
        work_on("X" + grafcet_.graphs[graph].name + "$freeze",
                builder_.add_origin(Origin::Kind::graph, grafcet_.graphs[graph].name, {}));
        role_ = 0;
        flip_flop(may_evolve_[g], builder_.inverted(net(writing_, equations_.frozen[graph])), true);
    }
}

/// Ts = Ts . /Tf0 + Tf1, with the orders of the steps active before it.
void ClockedBuild::apply_forcing(std::vector<NetId>& situation) {
    std::vector<std::vector<NetId>> off(grafcet_.graphs.size());
    std::vector<std::vector<NetId>> on(grafcet_.steps.size());
    for (const Order& order : grafcet_.orders) {
        if (order.kind == OrderKind::freeze) continue;
        const NetId giver = after_step_4_[index_of(order.step)];
        off[index_of(order.graph)].push_back(giver);
        for (const StepId step : order.steps) on[index_of(step)].push_back(giver);
        if (order.kind != OrderKind::initial) continue;
        const Graph& graph = grafcet_.graphs[order.graph];
        for (std::uint32_t i = 0; i < graph.step_count; ++i) {
            const StepId step = grafcet_.steps.id_at(graph.first_step + i);
            if (grafcet_.steps[step].initial) on[index_of(step)].push_back(giver);
        }
    }
    for (std::size_t g = 0; g < off.size(); ++g) {
        if (off[g].empty()) continue;
        const Graph& graph = grafcet_.graphs[grafcet_.graphs.id_at(g)];
        work_on("X" + graph.name + "$force",
                builder_.add_origin(Origin::Kind::graph, graph.name, {}));
        const NetId forced = gate(CellType::nor_gate, off[g], "free");
        for (std::uint32_t i = graph.first_step; i < graph.first_step + graph.step_count; ++i) {
            owner_ = "X" + grafcet_.steps[grafcet_.steps.id_at(i)].name;
            situation[i] = gate(CellType::and_gate, {situation[i], forced}, "unforced");
            if (on[i].empty()) continue;
            std::vector<NetId> pins = on[i];
            pins.push_back(situation[i]);
            situation[i] = gate(CellType::or_gate, pins, "forced");
        }
    }
}

/// From the outermost enclosures inwards: empty the graph where the enclosing step is inactive, add
/// the activation links where it has just been activated and no order bears on the graph.
void ClockedBuild::apply_enclosures(std::vector<NetId>& situation) {
    for (const std::uint32_t index : enclosures_inwards(grafcet_)) {
        const Enclosure& enclosure = grafcet_.enclosures[index];
        const Graph& graph = grafcet_.graphs[enclosure.graph];
        const NetId enclosing = situation[index_of(enclosure.step)];
        work_on("X" + graph.name + "$enclose", builder_.origin_of_step(enclosure.step));
        std::vector<NetId> pins{enclosing, builder_.inverted(now_.steps[index_of(enclosure.step)])};
        if (not_init_ != no_net) pins.push_back(not_init_);
        for (const Order& other : grafcet_.orders) {
            if (other.graph != enclosure.graph) continue;
            pins.push_back(builder_.inverted(after_step_4_[index_of(other.step)]));
        }
        const NetId link = gate(CellType::and_gate, pins, "link");
        for (std::uint32_t i = graph.first_step; i < graph.first_step + graph.step_count; ++i) {
            owner_ = "X" + grafcet_.steps[grafcet_.steps.id_at(i)].name;
            situation[i] = gate(CellType::and_gate, {situation[i], enclosing}, "enclosed");
        }
        std::vector<StepId> linked = enclosure.links;
        std::sort(linked.begin(), linked.end());
        linked.erase(std::unique(linked.begin(), linked.end()), linked.end());
        for (const StepId step : linked) {
            owner_ = "X" + grafcet_.steps[step].name;
            NetId& active = situation[index_of(step)];
            active = gate(CellType::or_gate, {active, link}, "linked");
        }
    }
}

}  // namespace grafwire
