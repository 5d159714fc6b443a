// The clocked style: one scan of the table method per clock cycle, in gates.
//
// X7 is the output of a flip-flop and stands for Ts at the start of a scan; `X7$next` is Ts at its
// end. In between the nets follow the scan: clearing of the transitions (Ta, Td), Ts = Tp./Td + Ta,
// forcing, enclosures, AUdur. Stored actions compare X7 with X7$next; their right-hand sides read
// steps as they are at the end of the scan and variables as they were, as the reference does, so
// every expression is built for the view in which it is read:
//
//     now      receptivities and edges: everything as the flip-flops hold it
//     writing  right-hand sides and events of stored actions: next steps, variables as held
//     after    operands of time conditions: next steps, next variables
//
// An edge is a flip-flop that remembers its operand and a gate; in the very first scan there are
// none, because a memory holds the present value at the start. The freeze bits are flip-flops that
// start at 1. A time condition is a clocked timer; where it stands in another one, that reads it as
// it will be after this scan, from a cell that looks ahead. All flip-flops have initial values, as
// those of an FPGA have.

#include <algorithm>
#include <cstdlib>

#include "grafcet/grafcet.h"
#include "netlist/styles/clocked_logic.h"
#include "netlist/styles/styles.h"

namespace grafwire {

namespace {

/// The registers of the counters, each of which holds how far its counter stands above the low end
/// (a counter of -3..4 at 0 holds 3), and the values that this makes.
std::vector<Word> add_counters(ClockedNetlist& netlist) {
    std::vector<Word> values;
    for (const Counter& counter : netlist.grafcet.counters) {
        std::size_t width = 0;
        while ((counter.high - counter.low) >> width != 0) ++width;
        const GateMaker gates = netlist.chart.at_inputs().named(counter.name);
        Observed observed{counter.name, {}, counter.low};
        for (std::size_t bit = 0; bit < width; ++bit) {
            observed.bits.push_back(gates.add_net("q" + std::to_string(bit)));
        }
        Word position = observed.bits;
        position.push_back(gates.low());
        Arithmetic arithmetic(gates.named(counter.name + "$value"));
        const Sum offset{{counter.low < 0, SumTerm::no_counter, std::abs(counter.low)},
                         {false, 0, 0}};
        values.push_back(arithmetic.sum(offset, {position}));
        netlist.chart.builder().add_counter(std::move(observed));
    }
    return values;
}

/// The ports and registers, which hold what is read at the beginning of a scan.
View view_now(ClockedNetlist& netlist) {
    View now;
    now.steps = netlist.chart.add_steps();
    now.outputs = netlist.chart.add_outputs();
    now.vars = netlist.chart.add_vars();
    now.counters = add_counters(netlist);
    return now;
}

View with_next_steps(View view, ClockedNetlist& netlist) {
    for (NetId& step : view.steps) step = netlist.chart.builder().add_inner_net(step, "next");
    return view;
}

View at_the_end(View view) {
    view.is_after = true;
    return view;
}

/// One scan in gates while it is being made. The members stand in the order in which their nets are
/// made.
struct ClockedScan {
    ClockedScan(const Grafcet& grafcet, const Equations& equations)
        : netlist(grafcet, equations),
          now(view_now(netlist)),
          logic(netlist),
          writing(with_next_steps(now, netlist)),
          after(at_the_end(writing)) {}

    ClockedNetlist netlist;
    View now;
    ClockedLogic logic;
    View writing;
    View after;                   ///< of what is stored, once make_registers has been called
    std::vector<NetId> clearing;  ///< per transition, once the situation has been made
};

/// The situation after the scan. Each part takes the situation that the one before it has left, in
/// the order of the scan.
class ClockedEvolution {
  public:
    explicit ClockedEvolution(ClockedScan& scan)
        : scan_(scan),
          grafcet_(scan.netlist.grafcet),
          links_(transitions_by_step(grafcet_)),
          may_evolve_(grafcet_.graphs.size(), no_net) {}

    void make() {
        make_clearing();
        std::vector<NetId> situation;
        for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
            const StepId step = grafcet_.steps.id_at(i);
            modules_.push_back(scan_.netlist.chart.add_module("X" + grafcet_.steps[step].name,
                                                              scan_.netlist.chart.origin_of(step)));
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

    ClockedScan& scan_;
    const Grafcet& grafcet_;
    StepTransitions links_;
    std::vector<GateMaker> modules_;  ///< per step
    std::vector<NetId> may_evolve_;   ///< per graph: Tfig, no_net where nothing freezes it
};

NetId ClockedEvolution::may_evolve(GraphId graph) {
    if (scan_.netlist.equations.frozen[graph] == no_expr) return no_net;
    NetId& net = may_evolve_[index_of(graph)];
    if (net == no_net) {
        net = scan_.netlist.chart.builder().add_inner_net("X" + grafcet_.graphs[graph].name,
                                                          "may_evolve");
    }
    return net;
}

void ClockedEvolution::make_clearing() {
    const Expressions& pool = scan_.netlist.equations.expressions;
    for (std::size_t i = 0; i < grafcet_.transitions.size(); ++i) {
        const TransitionId id = grafcet_.transitions.id_at(i);
        const Transition& transition = grafcet_.transitions[id];
        NumberedGates at =
            scan_.netlist.add_module("T" + transition.name, scan_.netlist.chart.origin_of(id));
        std::vector<NetId> pins;
        for (const StepId step : grafcet_.preceding(transition)) {
            pins.push_back(scan_.now.steps[index_of(step)]);
        }
        const ExprId receptivity =
            scan_.netlist.equations.from_grafcet[index_of(transition.condition)];
        const bool always =
            pool.kind(receptivity) == ExprKind::constant && pool.constant_value(receptivity);
        if (!always) pins.push_back(scan_.logic.net(scan_.now, receptivity, at));
        if (const NetId gate = may_evolve(transition.graph); gate != no_net) pins.push_back(gate);
        if (scan_.netlist.not_init != no_net) pins.push_back(scan_.netlist.not_init);
        if (pins.empty()) pins.push_back(at.gates.high());
        scan_.clearing.push_back(at.gates.gate(CellType::and_gate, pins, "clear"));
    }
}

/// Ts = Tp . /Td + Ta, and Init.
NetId ClockedEvolution::cleared(StepId step, const GateMaker& gates) {
    std::vector<NetId> causes;
    for (const TransitionId into : links_.into_step(step)) {
        causes.push_back(scan_.clearing[index_of(into)]);
    }
    std::vector<NetId> hold{scan_.now.steps[index_of(step)]};
    for (const TransitionId out : links_.out_of_step(step)) {
        hold.push_back(gates.inverted(scan_.clearing[index_of(out)]));
    }
    const bool initial = grafcet_.steps[step].initial;
    if (!initial && scan_.netlist.not_init != no_net) hold.push_back(scan_.netlist.not_init);
    causes.push_back(gates.joined(CellType::and_gate, hold, "hold"));
    if (initial && scan_.netlist.init != no_net) causes.push_back(scan_.netlist.init);
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
        const GateMaker gates = scan_.netlist.chart.add_module("X" + graph.name + "$force",
                                                               scan_.netlist.chart.origin_of(id));
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
        const GateMaker gates = scan_.netlist.chart.add_module(
            "X" + graph.name + "$enclose", scan_.netlist.chart.origin_of(enclosure.step));
        std::vector<NetId> pins{enclosing,
                                gates.inverted(scan_.now.steps[index_of(enclosure.step)])};
        if (scan_.netlist.not_init != no_net) pins.push_back(scan_.netlist.not_init);
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
        if (scan_.netlist.not_au_dur != no_net) pins.push_back(scan_.netlist.not_au_dur);
        gates.drive(scan_.writing.steps[i], CellType::and_gate, pins);
        scan_.netlist.add_flip_flop(scan_.now.steps[i], scan_.writing.steps[i],
                                    grafcet_.steps[grafcet_.steps.id_at(i)].initial, gates);
    }
}

/// Whether a graph may evolve in the next scan: the steps that freeze it as they are after this
/// one.
void ClockedEvolution::make_freezing() {
    for (std::size_t g = 0; g < may_evolve_.size(); ++g) {
        if (may_evolve_[g] == no_net) continue;
        const GraphId graph = grafcet_.graphs.id_at(g);
        NumberedGates at = scan_.netlist.add_module("X" + grafcet_.graphs[graph].name + "$freeze",
                                                    scan_.netlist.chart.origin_of(graph));
        const NetId frozen =
            scan_.logic.net(scan_.writing, scan_.netlist.equations.frozen[graph], at);
        scan_.netlist.add_flip_flop(may_evolve_[g], at.gates.inverted(frozen), true, at.gates);
    }
}

// Stored outputs, vars and counters are registers. The writes to one stand in the order of their
// execution, each choosing between its value and what was there: the last one wins.

/// The net that is 1 when a write happens.
NetId trigger_of(ClockedScan& scan, const StoredWrite& write, NumberedGates& at) {
    const GateMaker& gates = at.gates;
    const std::size_t step = index_of(write.step);
    const std::string role = "when" + at.next_role();
    switch (write.cause) {
        case StoredWrite::Cause::deactivation:
            return gates.gate(CellType::and_gate,
                              {scan.now.steps[step], gates.inverted(scan.writing.steps[step])},
                              role);
        case StoredWrite::Cause::activation:
            return gates.gate(CellType::and_gate,
                              {gates.inverted(scan.now.steps[step]), scan.writing.steps[step]},
                              role);
        case StoredWrite::Cause::clearing:
            return scan.clearing[index_of(write.transition)];
        case StoredWrite::Cause::event: {
            const NetId event = scan.logic.net(scan.writing, write.event, at);
            return gates.gate(CellType::and_gate, {scan.writing.steps[step], event}, role);
        }
    }
    return gates.low();
}

/// `held`: what the register holds; returns what it will hold.
NetId make_bit(ClockedScan& scan, const StoredEquation& stored, NetId held, NumberedGates at) {
    Arithmetic arithmetic(at.gates.named(at.gates.owner() + "$next"));
    NetId next = held;
    for (const StoredWrite& write : stored.writes) {
        const NetId value = scan.logic.net(scan.writing, write.value, at);
        const NetId when = trigger_of(scan, write, at);
        next = arithmetic.choose(when, value, next);
    }
    scan.netlist.add_flip_flop(held, next, false, at.gates);
    return next;
}

/// Likewise for the register of a counter; returns the value it will have.
Word make_counter(ClockedScan& scan, const StoredEquation& stored, const Counter& counter,
                  const std::vector<NetId>& bits, NumberedGates at) {
    Arithmetic arithmetic(at.gates.named(at.gates.owner() + "$next"));
    // All words hold the position above the low end.
    Word next = bits;
    next.push_back(at.gates.low());
    for (const StoredWrite& write : stored.writes) {
        const NetId when = trigger_of(scan, write, at);
        const Word low = arithmetic.constant(counter.low, 65);
        Word position = arithmetic.subtract(arithmetic.sum(write.sum, scan.writing.counters), low);
        const NetId below = arithmetic.is_negative(position);
        const Word top = arithmetic.constant(counter.high - counter.low, bits.size() + 1);
        const NetId above = arithmetic.compare(position, Relation::greater, top);
        position.resize(bits.size() + 1);
        position = arithmetic.choose(above, top, position);
        position = arithmetic.choose(below, arithmetic.constant(0, bits.size() + 1), position);
        next = arithmetic.choose(when, position, next);
    }
    for (std::size_t bit = 0; bit < bits.size(); ++bit) {
        scan.netlist.add_flip_flop(bits[bit], next[bit], false, at.gates);
    }
    next.resize(bits.size());
    next.push_back(at.gates.low());
    const Sum offset{{counter.low < 0, SumTerm::no_counter, std::abs(counter.low)}, {false, 0, 0}};
    return arithmetic.sum(offset, {next});
}

/// The registers, and in `after` what they will hold.
void make_registers(ClockedScan& scan) {
    const Grafcet& grafcet = scan.netlist.grafcet;
    const std::vector<Observed>& registers = scan.netlist.chart.builder().netlist().counters;
    std::vector<std::uint8_t> written(grafcet.counters.size());
    for (const StoredEquation& stored : scan.netlist.equations.stored) {
        const std::uint32_t index = stored.target.index;
        if (stored.target.kind == VariableKind::output) {
            const OutputId id{index};
            scan.after.outputs[index] =
                make_bit(scan, stored, scan.now.outputs[index],
                         scan.netlist.add_module(grafcet.outputs[id].name,
                                                 scan.netlist.chart.origin_of(id)));
        } else if (stored.target.kind == VariableKind::var) {
            const VarId id{index};
            scan.after.vars[index] = make_bit(
                scan, stored, scan.now.vars[index],
                scan.netlist.add_module(grafcet.vars[id].name, scan.netlist.chart.origin_of(id)));
        } else {
            const CounterId id{index};
            const Counter& counter = grafcet.counters[id];
            written[index] = 1;
            scan.after.counters[index] = make_counter(
                scan, stored, counter, registers[index].bits,
                scan.netlist.add_module(counter.name, scan.netlist.chart.origin_of(id)));
        }
    }
    for (std::size_t i = 0; i < written.size(); ++i) {
        if (written[i] != 0) continue;
        const CounterId id = grafcet.counters.id_at(i);
        const GateMaker gates = scan.netlist.chart.add_module(grafcet.counters[id].name,
                                                              scan.netlist.chart.origin_of(id));
        for (const NetId bit : registers[i].bits) gates.add_cell(CellType::low, bit, {});
    }
}

/// Continuous outputs read everything as the flip-flops hold it once the scan is over.
void make_outputs(ClockedScan& scan) {
    const Grafcet& grafcet = scan.netlist.grafcet;
    const auto drive = [&scan](NetId net, ExprId value, NumberedGates at) {
        const NetId source = scan.logic.net(scan.now, value, at);
        at.gates.add_cell(CellType::buffer, net, {&source, 1});
    };
    for (const OutputEquation& equation : scan.netlist.equations.outputs) {
        drive(scan.now.outputs[index_of(equation.output)], equation.value,
              scan.netlist.add_module(grafcet.outputs[equation.output].name,
                                      scan.netlist.chart.origin_of(equation.output)));
    }
    for (const HeldEquation& equation : scan.netlist.equations.held) {
        drive(scan.now.vars[index_of(equation.var)], equation.value,
              scan.netlist.add_module(grafcet.vars[equation.var].name,
                                      scan.netlist.chart.origin_of(equation.var)));
    }
}

}  // namespace

Netlist make_clocked(const Grafcet& grafcet, const Equations& equations, const DelayModel&) {
    ClockedScan scan(grafcet, equations);
    scan.logic.make_edges(scan.now);
    ClockedEvolution(scan).make();
    make_registers(scan);
    scan.logic.make_time_conditions(scan.after);
    make_outputs(scan);
    return scan.netlist.chart.finish(equations.options.modes, scan.netlist.clock);
}

}  // namespace grafwire
