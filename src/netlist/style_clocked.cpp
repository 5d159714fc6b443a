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
// start at 1. All flip-flops have initial values, as those of an FPGA have.

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "equations/write_equations.h"
#include "netlist/arithmetic.h"
#include "netlist/asynchronous.h"

namespace grafwire {

namespace {

/// What an expression reads at one point of the scan.
struct View {
    bool is_after = false;
    std::vector<NetId> steps;
    std::vector<NetId> outputs;
    std::vector<NetId> vars;
    std::vector<Word> counters;
    std::vector<NetId> made;  ///< per expression; no_net where not yet made
};

class ClockedBuild {
  public:
    explicit ClockedBuild(Equations& equations)
        : equations_(equations),
          grafcet_(*equations.grafcet),
          pool_(equations.expressions),
          builder_(grafcet_),
          links_(transitions_by_step(grafcet_)) {}

    Netlist make() {
        make_ports();
        make_edge_nets();
        make_edges();
        make_clearing();
        make_evolution();
        make_stored();
        make_time_conditions();
        make_outputs();
        Netlist& netlist = builder_.netlist();
        netlist.has_modes = equations_.options.modes;
        netlist.step_count = grafcet_.steps.size();
        netlist.clock = clock_;
        return builder_.finish();
    }

  private:
    void make_ports();
    void make_counters();
    void make_edge_nets();
    void make_edges();
    void make_clearing();
    NetId frozen_gate(GraphId graph);
    void make_evolution();
    NetId scan_end_without_orders(StepId step);
    void apply_forcing(std::vector<NetId>& situation);
    void apply_enclosures(std::vector<NetId>& situation);
    void make_stored();
    void write_bit(const StoredEquation& stored);
    void write_counter(const StoredEquation& stored);
    NetId trigger(const StoredWrite& write);
    void make_time_conditions();
    void make_outputs();

    NetId net(View& view, ExprId id);
    NetId make_net(View& view, ExprId id);
    NetId variable_net(const View& view, Variable variable) const;
    NetId time_net(View& view, ExprId id);
    NetId gate(CellType type, std::vector<NetId> pins, std::string_view role) {
        return builder_.gate(type, pins, owner_, role);
    }
    std::string next_role() { return fmt::format("{}", ++role_); }
    void work_on(const std::string& module, std::uint32_t origin, const std::string& comment = {}) {
        builder_.work_on(builder_.add_module(module, comment), origin);
        owner_ = module;
    }
    void flip_flop(NetId output, NetId data, bool initial) {
        const NetId pins[] = {data, clock_};
        builder_.add_memory(CellType::flip_flop, output, pins, initial ? Logic::one : Logic::zero);
    }

    Equations& equations_;
    const Grafcet& grafcet_;
    const Expressions& pool_;
    NetlistBuilder builder_;
    StepTransitions links_;
    std::vector<NetId> inputs_;
    NetId clock_ = no_net;
    NetId not_init_ = no_net;
    NetId not_au_dur_ = no_net;
    View now_;
    View writing_;
    View after_;
    std::vector<NetId> edges_;       ///< per edge of the pool
    std::vector<NetId> times_;       ///< per time condition: the output of its clocked timer
    std::vector<NetId> may_evolve_;  ///< per graph: Tfig, no_net where nothing freezes it
    std::vector<NetId> clearing_;    ///< per transition
    std::vector<NetId> after_step_4_;
    std::string owner_;
    std::uint32_t role_ = 0;
};

void ClockedBuild::make_ports() {
    Netlist& netlist = builder_.netlist();
    const std::size_t controls = grafcet_.inputs.size();
    for (std::size_t i = 0; i < grafcet_.all_input_count(); ++i) {
        if (i >= controls && !equations_.options.modes) {
            inputs_.push_back(no_net);
            continue;
        }
        const std::string name(input_name(grafcet_, i));
        inputs_.push_back(builder_.add_port_net(name));
        netlist.inputs.push_back({name, inputs_.back()});
    }
    clock_ = builder_.add_port_net("clk");
    netlist.inputs.push_back({"clk", clock_});
    if (inputs_[controls] != no_net) {
        not_init_ = builder_.inverted(inputs_[controls]);
        not_au_dur_ = builder_.inverted(inputs_[controls + 1]);
    }
    for (const Step& step : grafcet_.steps) {
        const std::string name = "X" + step.name;
        now_.steps.push_back(builder_.add_port_net(name));
        netlist.outputs.push_back({name, now_.steps.back()});
    }
    for (const Output& output : grafcet_.outputs) {
        now_.outputs.push_back(builder_.add_port_net(output.name));
        netlist.outputs.push_back({output.name, now_.outputs.back()});
    }
    for (const Var& var : grafcet_.vars) {
        now_.vars.push_back(builder_.add_port_net(var.name));
        netlist.vars.push_back({var.name, {now_.vars.back()}, 0});
    }
    make_counters();
    for (std::size_t i = 0; i < pool_.time_conditions().size(); ++i) {
        times_.push_back(builder_.add_net("timer", std::to_string(i)));
    }
    for (const Step& step : grafcet_.steps) {
        writing_.steps.push_back(builder_.add_net("X" + step.name, "next"));
    }
    writing_.outputs = now_.outputs;
    writing_.vars = now_.vars;
    writing_.counters = now_.counters;
    after_ = writing_;
    after_.is_after = true;
}

/// A register holds how far its counter stands above the low end.
void ClockedBuild::make_counters() {
    for (const Counter& counter : grafcet_.counters) {
        std::size_t width = 0;
        while ((counter.high - counter.low) >> width != 0) ++width;
        Observed observed{counter.name, {}, counter.low};
        for (std::size_t bit = 0; bit < width; ++bit) {
            observed.bits.push_back(builder_.add_net(counter.name, "q" + std::to_string(bit)));
        }
        Word position = observed.bits;
        position.push_back(builder_.low());
        Arithmetic arithmetic(builder_, counter.name + "$value");
        const Sum offset{{counter.low < 0, SumTerm::no_counter, std::abs(counter.low)},
                         {false, 0, 0}};
        now_.counters.push_back(arithmetic.sum(offset, {position}));
        builder_.netlist().counters.push_back(std::move(observed));
    }
}

NetId ClockedBuild::variable_net(const View& view, Variable variable) const {
    switch (variable.kind) {
        case VariableKind::input:
            return inputs_[variable.index];
        case VariableKind::control:
            return inputs_[grafcet_.inputs.size() + variable.index];
        case VariableKind::step:
            return view.steps[variable.index];
        case VariableKind::output:
            return view.outputs[variable.index];
        case VariableKind::var:
            return view.vars[variable.index];
        case VariableKind::counter:
        case VariableKind::macro:
        case VariableKind::graph:
            break;
    }
    assert(false && "equations hold no such variable");
    return no_net;
}

NetId ClockedBuild::net(View& view, ExprId id) {
    if (view.made.size() < pool_.size()) view.made.resize(pool_.size(), no_net);
    if (view.made[index_of(id)] == no_net) {
        const NetId made = make_net(view, id);
        view.made[index_of(id)] = made;
    }
    return view.made[index_of(id)];
}

NetId ClockedBuild::make_net(View& view, ExprId id) {
    const ExprKind kind = pool_.kind(id);
    switch (kind) {
        case ExprKind::constant:
            return pool_.constant_value(id) ? builder_.high() : builder_.low();
        case ExprKind::variable: {
            const NetId found = variable_net(view, pool_.variable_of(id));
            return found == no_net ? builder_.low() : found;
        }
        case ExprKind::negation:
            return builder_.inverted(net(view, pool_.operands(id)[0]));
        case ExprKind::conjunction:
        case ExprKind::disjunction:
        case ExprKind::exclusive_or: {
            std::vector<NetId> pins;
            for (const ExprId operand : pool_.operands(id)) pins.push_back(net(view, operand));
            const CellType type = kind == ExprKind::conjunction   ? CellType::and_gate
                                  : kind == ExprKind::disjunction ? CellType::or_gate
                                                                  : CellType::xor_gate;
            return gate(type, std::move(pins), next_role());
        }
        case ExprKind::rise:
        case ExprKind::fall:
            return edges_[pool_.ordinal(id)];
        case ExprKind::time_condition:
            return time_net(view, id);
        case ExprKind::comparison: {
            const Comparison& comparison = pool_.comparison_of(id);
            Arithmetic arithmetic(builder_, fmt::format("{}${}", owner_, next_role()));
            const Word left = arithmetic.sum(comparison.left, view.counters);
            const Word right = arithmetic.sum(comparison.right, view.counters);
            return arithmetic.compare(left, comparison.relation, right);
        }
    }
    return builder_.low();
}

/// Within the operand of another time condition the value at the end of the scan counts. Where a
/// change has no delay that is already known; one that ends in this very scan is seen at the next.
NetId ClockedBuild::time_net(View& view, ExprId id) {
    const NetId held = times_[pool_.ordinal(id)];
    if (!view.is_after) return held;
    const TimeCondition& condition = pool_.time_condition_of(id);
    if (condition.on_delay != 0 && condition.off_delay != 0) return held;
    const NetId operand = net(view, condition.operand);
    if (condition.on_delay == 0 && condition.off_delay == 0) return operand;
    const CellType type = condition.off_delay == 0 ? CellType::and_gate : CellType::or_gate;
    return gate(type, {held, operand}, next_role());
}

// Only the edges that something reads are needed: those of the GRAFCET, whose ordinals are the same
// here. Edges of steps that the equations add are X and X$next compared.
void ClockedBuild::make_edge_nets() {
    const std::size_t count = grafcet_.expressions.edges().size();
    for (std::size_t i = 0; i < count; ++i) {
        edges_.push_back(builder_.add_net("edge", std::to_string(i)));
    }
}

void ClockedBuild::make_edges() {
    if (edges_.empty()) return;
    work_on("edges", builder_.add_origin(Origin::Kind::edge, "edges", {}));
    const NetId running = builder_.add_net("edges", "running");
    flip_flop(running, builder_.high(), false);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
        const ExprId id = pool_.edges()[i];
        owner_ = fmt::format("edge${}", i);
        role_ = 0;
        builder_.work_on(builder_.module(), builder_.add_origin(Origin::Kind::edge,
                                                                equation_text(equations_, id), {}));
        const NetId operand = net(now_, pool_.operands(id)[0]);
        const NetId memory = builder_.add_net(owner_, "memory");
        flip_flop(memory, operand, false);
        const bool rising = pool_.kind(id) == ExprKind::rise;
        const NetId pins[] = {rising ? operand : builder_.inverted(operand),
                              rising ? builder_.inverted(memory) : memory, running};
        builder_.add_cell(CellType::and_gate, edges_[i], pins);
    }
}

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
    std::vector<NetlistBuilder::ModuleId> modules;
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
    const auto depth_of = [&](const Enclosure& enclosure) {
        std::size_t depth = 0;
        const Enclosure* outer = &enclosure;
        for (;;) {
            const Graph& graph = grafcet_.graphs[grafcet_.steps[outer->step].graph];
            if (graph.enclosed_by == none) return depth;
            outer = &grafcet_.enclosures[graph.enclosed_by];
            ++depth;
        }
    };
    std::vector<std::pair<std::size_t, std::size_t>> order;
    for (std::size_t i = 0; i < grafcet_.enclosures.size(); ++i) {
        order.emplace_back(depth_of(grafcet_.enclosures[i]), i);
    }
    std::sort(order.begin(), order.end());
    for (const auto& [depth, index] : order) {
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

NetId ClockedBuild::trigger(const StoredWrite& write) {
    const std::size_t step = index_of(write.step);
    const std::string role = "when" + next_role();
    switch (write.cause) {
        case StoredWrite::Cause::deactivation:
            return gate(CellType::and_gate,
                        {now_.steps[step], builder_.inverted(writing_.steps[step])}, role);
        case StoredWrite::Cause::activation:
            return gate(CellType::and_gate,
                        {builder_.inverted(now_.steps[step]), writing_.steps[step]}, role);
        case StoredWrite::Cause::clearing:
            return clearing_[index_of(write.transition)];
        case StoredWrite::Cause::event: {
            const NetId event = net(writing_, write.event);
            return gate(CellType::and_gate, {writing_.steps[step], event}, role);
        }
    }
    return builder_.low();
}

/// The writes in the order of their execution, each choosing between its value and what was there:
/// the last one wins.
void ClockedBuild::write_bit(const StoredEquation& stored) {
    const bool is_output = stored.target.kind == VariableKind::output;
    const std::uint32_t index = stored.target.index;
    const NetId held = (is_output ? now_.outputs : now_.vars)[index];
    Arithmetic arithmetic(builder_, owner_ + "$next");
    NetId next = held;
    for (const StoredWrite& write : stored.writes) {
        const NetId value = net(writing_, write.value);
        const NetId when = trigger(write);
        next = arithmetic.choose(when, value, next);
    }
    (is_output ? after_.outputs : after_.vars)[index] = next;
    flip_flop(held, next, false);
}

void ClockedBuild::write_counter(const StoredEquation& stored) {
    const std::uint32_t index = stored.target.index;
    const Counter& counter = grafcet_.counters[CounterId{index}];
    const std::vector<NetId>& bits = builder_.netlist().counters[index].bits;
    Arithmetic arithmetic(builder_, owner_ + "$next");
    // All words hold the position above the low end.
    Word next = bits;
    next.push_back(builder_.low());
    for (const StoredWrite& write : stored.writes) {
        const NetId when = trigger(write);
        const Word low = arithmetic.constant(counter.low, 65);
        Word position = arithmetic.subtract(arithmetic.sum(*write.sum, writing_.counters), low);
        const NetId below = arithmetic.is_negative(position);
        const Word top = arithmetic.constant(counter.high - counter.low, bits.size() + 1);
        const NetId above = arithmetic.compare(position, Relation::greater, top);
        position.resize(bits.size() + 1);
        position = arithmetic.choose(above, top, position);
        position = arithmetic.choose(below, arithmetic.constant(0, bits.size() + 1), position);
        next = arithmetic.choose(when, position, next);
    }
    for (std::size_t bit = 0; bit < bits.size(); ++bit) flip_flop(bits[bit], next[bit], false);
    next.resize(bits.size());
    next.push_back(builder_.low());
    const Sum offset{{counter.low < 0, SumTerm::no_counter, std::abs(counter.low)}, {false, 0, 0}};
    after_.counters[index] = arithmetic.sum(offset, {next});
}

void ClockedBuild::make_stored() {
    std::vector<std::uint8_t> written(grafcet_.counters.size());
    for (const StoredEquation& stored : equations_.stored) {
        const std::uint32_t index = stored.target.index;
        role_ = 0;
        switch (stored.target.kind) {
            case VariableKind::output: {
                const Output& output = grafcet_.outputs[OutputId{index}];
                work_on(output.name,
                        builder_.add_origin(Origin::Kind::output, output.name, output.where));
                write_bit(stored);
                break;
            }
            case VariableKind::var: {
                const Var& var = grafcet_.vars[VarId{index}];
                work_on(var.name, builder_.add_origin(Origin::Kind::var, var.name, var.where));
                write_bit(stored);
                break;
            }
            default: {
                const Counter& counter = grafcet_.counters[CounterId{index}];
                work_on(counter.name,
                        builder_.add_origin(Origin::Kind::counter, counter.name, counter.where));
                written[index] = 1;
                write_counter(stored);
                break;
            }
        }
    }
    for (std::size_t i = 0; i < written.size(); ++i) {
        if (written[i] != 0) continue;
        const Counter& counter = grafcet_.counters[grafcet_.counters.id_at(i)];
        work_on(counter.name,
                builder_.add_origin(Origin::Kind::counter, counter.name, counter.where));
        for (const NetId bit : builder_.netlist().counters[i].bits) {
            builder_.add_cell(CellType::low, bit, {});
        }
    }
}

void ClockedBuild::make_time_conditions() {
    for (std::size_t i = 0; i < times_.size(); ++i) {
        const ExprId id = pool_.time_conditions()[i];
        const TimeCondition& condition = pool_.time_condition_of(id);
        work_on(fmt::format("timer${}", i), builder_.add_origin(Origin::Kind::time_condition,
                                                                equation_text(equations_, id), {}));
        role_ = 0;
        const NetId pins[] = {net(after_, condition.operand), clock_};
        const Timing timing{condition.on_delay, condition.off_delay, static_cast<std::uint32_t>(i)};
        builder_.add_memory(CellType::scan_timer, times_[i], pins, Logic::zero, &timing);
    }
}

/// Continuous outputs read everything as the flip-flops hold it once the scan is over.
void ClockedBuild::make_outputs() {
    for (const OutputEquation& equation : equations_.outputs) {
        const Output& output = grafcet_.outputs[equation.output];
        work_on(output.name, builder_.add_origin(Origin::Kind::output, output.name, output.where),
                fmt::format("{} = {}", output.name, equation_text(equations_, equation.value)));
        role_ = 0;
        const NetId source = net(now_, equation.value);
        builder_.add_cell(CellType::buffer, now_.outputs[index_of(equation.output)], {&source, 1});
    }
}

}  // namespace

Netlist make_clocked(Equations& equations) {
    return ClockedBuild(equations).make();
}

}  // namespace grafwire
