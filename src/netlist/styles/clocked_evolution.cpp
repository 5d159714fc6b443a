// The evolution of the situation within one scan of the clocked style: clearing, Ts = Tp./Td + Ta,
// forcing, enclosures, AUdur. Each part takes the situation that the one before it has left, in the
// order of the scan.

#include <algorithm>

#include "grafcet/grafcet.h"
#include "netlist/styles/clocked.h"

namespace grafwire {

namespace {

class ClockedEvolution {
  public:
    explicit ClockedEvolution(ClockedBuild& build)
        : build_(build),
          grafcet_(build.grafcet),
          links_(transitions_by_step(grafcet_)),
          may_evolve_(grafcet_.graphs.size(), no_net) {}

    void make() {
        make_clearing();
        std::vector<NetId> situation;
        for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
            const StepId step = grafcet_.steps.id_at(i);
            modules_.push_back(build_.chart.add_module("X" + grafcet_.steps[step].name,
                                                       build_.chart.origin_of(step)));
            situation.push_back(cleared(step, modules_.back()));
        }
        const std::vector<NetId> before_orders = situation;
        apply_forcing(before_orders, situation);
        apply_enclosures(before_orders, situation);
        make_steps(situation);
        make_freezing();
    }

  private:
    void make_clearing();
    NetId may_evolve(GraphId graph);
    NetId cleared(StepId step, const GateMaker& gates);
    void apply_forcing(const std::vector<NetId>& before_orders, std::vector<NetId>& situation);
    void force(const Graph& graph, const GateMaker& gates, NetId free,
               const std::vector<std::vector<NetId>>& forced_on, std::vector<NetId>& situation);
    void apply_enclosures(const std::vector<NetId>& before_orders, std::vector<NetId>& situation);
    void make_steps(const std::vector<NetId>& situation);
    void make_freezing();
    std::string x_of(std::size_t step) const {
        return "X" + grafcet_.steps[grafcet_.steps.id_at(step)].name;
    }

    ClockedBuild& build_;
    const Grafcet& grafcet_;
    StepTransitions links_;
    std::vector<GateMaker> modules_;  ///< per step
    std::vector<NetId> may_evolve_;   ///< per graph: Tfig, no_net where nothing freezes it
};

NetId ClockedEvolution::may_evolve(GraphId graph) {
    if (build_.equations.frozen[graph] == no_expr) return no_net;
    NetId& net = may_evolve_[index_of(graph)];
    if (net == no_net) {
        net = build_.chart.builder().add_inner_net("X" + grafcet_.graphs[graph].name, "may_evolve");
    }
    return net;
}

void ClockedEvolution::make_clearing() {
    const Expressions& pool = build_.equations.expressions;
    for (std::size_t i = 0; i < grafcet_.transitions.size(); ++i) {
        const TransitionId id = grafcet_.transitions.id_at(i);
        const Transition& transition = grafcet_.transitions[id];
        NumberedGates at = build_.add_module("T" + transition.name, build_.chart.origin_of(id));
        std::vector<NetId> pins;
        for (const StepId step : grafcet_.preceding(transition)) {
            pins.push_back(build_.now.steps[index_of(step)]);
        }
        const ExprId receptivity = build_.equations.from_grafcet[index_of(transition.condition)];
        const bool always =
            pool.kind(receptivity) == ExprKind::constant && pool.constant_value(receptivity);
        if (!always) pins.push_back(build_.net(build_.now, receptivity, at));
        if (const NetId gate = may_evolve(transition.graph); gate != no_net) pins.push_back(gate);
        if (build_.not_init != no_net) pins.push_back(build_.not_init);
        if (pins.empty()) pins.push_back(at.gates.high());
        build_.clearing.push_back(at.gates.gate(CellType::and_gate, pins, "clear"));
    }
}

/// Ts = Tp . /Td + Ta, and Init.
NetId ClockedEvolution::cleared(StepId step, const GateMaker& gates) {
    std::vector<NetId> causes;
    for (const TransitionId into : links_.into_step(step)) {
        causes.push_back(build_.clearing[index_of(into)]);
    }
    std::vector<NetId> hold{build_.now.steps[index_of(step)]};
    for (const TransitionId out : links_.out_of_step(step)) {
        hold.push_back(gates.inverted(build_.clearing[index_of(out)]));
    }
    const bool initial = grafcet_.steps[step].initial;
    if (!initial && build_.not_init != no_net) hold.push_back(build_.not_init);
    causes.push_back(gates.joined(CellType::and_gate, hold, "hold"));
    if (initial && build_.init != no_net) causes.push_back(build_.init);
    return gates.joined(CellType::or_gate, causes, "evolved");
}

/// Ts = Ts . /Tf0 + Tf1, with the orders of the steps active before it.
void ClockedEvolution::apply_forcing(const std::vector<NetId>& before_orders,
                                     std::vector<NetId>& situation) {
    std::vector<std::vector<NetId>> off(grafcet_.graphs.size());
    std::vector<std::vector<NetId>> on(grafcet_.steps.size());
    for (const Order& order : grafcet_.orders) {
        if (order.kind == OrderKind::freeze) continue;
        const NetId giver = before_orders[index_of(order.step)];
        off[index_of(order.graph)].push_back(giver);
        for (const StepId step : order.steps) on[index_of(step)].push_back(giver);
        if (order.kind != OrderKind::initial) continue;
        const Graph& graph = grafcet_.graphs[order.graph];
        for (const StepId step : graph.steps) {
            if (grafcet_.steps[step].initial) on[index_of(step)].push_back(giver);
        }
    }
    for (std::size_t g = 0; g < off.size(); ++g) {
        if (off[g].empty()) continue;
        const GraphId id = grafcet_.graphs.id_at(g);
        const Graph& graph = grafcet_.graphs[id];
        const GateMaker gates =
            build_.chart.add_module("X" + graph.name + "$force", build_.chart.origin_of(id));
        force(graph, gates, gates.gate(CellType::nor_gate, off[g], "free"), on, situation);
    }
}

void ClockedEvolution::force(const Graph& graph, const GateMaker& gates, NetId free,
                             const std::vector<std::vector<NetId>>& forced_on,
                             std::vector<NetId>& situation) {
    for (std::uint32_t i = graph.steps.first; i < graph.steps.first + graph.steps.count; ++i) {
        const GateMaker own = gates.named(x_of(i));
        situation[i] = own.gate(CellType::and_gate, {situation[i], free}, "unforced");
        if (forced_on[i].empty()) continue;
        std::vector<NetId> pins = forced_on[i];
        pins.push_back(situation[i]);
        situation[i] = own.gate(CellType::or_gate, pins, "forced");
    }
}

/// From the outermost enclosures inwards: empty the graph where the enclosing step is inactive, add
/// the activation links where it has just been activated and no order bears on the graph.
void ClockedEvolution::apply_enclosures(const std::vector<NetId>& before_orders,
                                        std::vector<NetId>& situation) {
    for (const EnclosureId index : enclosures_inwards(grafcet_)) {
        const Enclosure& enclosure = grafcet_.enclosures[index];
        const Graph& graph = grafcet_.graphs[enclosure.graph];
        const NetId enclosing = situation[index_of(enclosure.step)];
        const GateMaker gates = build_.chart.add_module("X" + graph.name + "$enclose",
                                                        build_.chart.origin_of(enclosure.step));
        std::vector<NetId> pins{enclosing,
                                gates.inverted(build_.now.steps[index_of(enclosure.step)])};
        if (build_.not_init != no_net) pins.push_back(build_.not_init);
        for (const Order& other : grafcet_.orders) {
            if (other.graph != enclosure.graph) continue;
            pins.push_back(gates.inverted(before_orders[index_of(other.step)]));
        }
        const NetId link = gates.gate(CellType::and_gate, pins, "link");
        for (std::uint32_t i = graph.steps.first; i < graph.steps.first + graph.steps.count; ++i) {
            situation[i] = gates.named(x_of(i)).gate(CellType::and_gate, {situation[i], enclosing},
                                                     "enclosed");
        }
        std::vector<StepId> linked = enclosure.links;
        std::sort(linked.begin(), linked.end());
        linked.erase(std::unique(linked.begin(), linked.end()), linked.end());
        for (const StepId step : linked) {
            NetId& active = situation[index_of(step)];
            active =
                gates.named(x_of(index_of(step))).gate(CellType::or_gate, {active, link}, "linked");
        }
    }
}

void ClockedEvolution::make_steps(const std::vector<NetId>& situation) {
    for (std::size_t i = 0; i < situation.size(); ++i) {
        const GateMaker& gates = modules_[i];
        std::vector<NetId> pins{situation[i]};
        if (build_.not_au_dur != no_net) pins.push_back(build_.not_au_dur);
        gates.drive(build_.writing.steps[i], CellType::and_gate, pins);
        build_.add_flip_flop(build_.now.steps[i], build_.writing.steps[i],
                             grafcet_.steps[grafcet_.steps.id_at(i)].initial, gates);
    }
}

/// Whether a graph may evolve in the next scan: the steps that freeze it as they are after this
/// one.
void ClockedEvolution::make_freezing() {
    for (std::size_t g = 0; g < may_evolve_.size(); ++g) {
        if (may_evolve_[g] == no_net) continue;
        const GraphId graph = grafcet_.graphs.id_at(g);
        NumberedGates at = build_.add_module("X" + grafcet_.graphs[graph].name + "$freeze",
                                             build_.chart.origin_of(graph));
        const NetId frozen = build_.net(build_.writing, build_.equations.frozen[graph], at);
        build_.add_flip_flop(may_evolve_[g], at.gates.inverted(frozen), true, at.gates);
    }
}

}  // namespace

void make_evolution(ClockedBuild& build) {
    ClockedEvolution(build).make();
}

}  // namespace grafwire
