// Expressions, edges and time conditions of the clocked style.

#include <fmt/format.h>

#include <cassert>

#include "equations/equation_text.h"
#include "netlist/styles/clocked_build.h"

namespace grafwire {

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

/// Within the operand of another time condition the value at the end of the scan counts, which the
/// timer itself shows only after it.
NetId ClockedBuild::time_net(View& view, ExprId id) {
    const std::size_t ordinal = pool_.ordinal(id);
    const NetId held = times_[ordinal];
    if (!view.is_after) return held;
    const TimeCondition& condition = pool_.time_condition_of(id);
    const NetId operand = net(view, condition.operand);
    if (condition.on_delay == 0 && condition.off_delay == 0) return operand;
    const NetId next = builder_.add_net(fmt::format("timer${}", ordinal), "next");
    const NetId pins[] = {operand, held, clock_};
    const Timing timing = timing_of(ordinal);
    const std::uint32_t reader = builder_.origin();
    builder_.work_on(builder_.module(), time_origin(ordinal));
    builder_.add_cell(CellType::scan_timer_next, next, pins, {Logic::unknown, timing});
    builder_.work_on(builder_.module(), reader);
    return next;
}

Timing ClockedBuild::timing_of(std::size_t ordinal) const {
    const TimeCondition& condition = pool_.time_condition_of(pool_.time_conditions()[ordinal]);
    return {condition.on_delay, condition.off_delay, static_cast<std::uint32_t>(ordinal)};
}

std::uint32_t ClockedBuild::time_origin(std::size_t ordinal) {
    const ExprId id = pool_.time_conditions()[ordinal];
    return builder_.add_origin(Origin::Kind::time_condition, equation_text(equations_, id), {});
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

void ClockedBuild::make_time_conditions() {
    for (std::size_t i = 0; i < times_.size(); ++i) {
        const TimeCondition& condition = pool_.time_condition_of(pool_.time_conditions()[i]);
        work_on(fmt::format("timer${}", i), time_origin(i));
        role_ = 0;
        const NetId pins[] = {net(after_, condition.operand), clock_};
        const Timing timing = timing_of(i);
        builder_.add_cell(CellType::scan_timer, times_[i], pins, {Logic::zero, timing});
    }
}

}  // namespace grafwire
