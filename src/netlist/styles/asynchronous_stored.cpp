// Stored outputs and vars of the asynchronous styles: a latch each, set and reset by the pulses of
// their writes. Where several writes happen at once the last one wins, so each write is blocked by
// the triggers of the later ones.

#include <fmt/format.h>

#include <algorithm>

#include "equations/equation_text.h"
#include "equations/logic.h"
#include "netlist/styles/asynchronous_frame.h"

namespace grafwire {

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

}  // namespace

NetId AsynchronousFrame::stored_net(Variable target) const {
    return target.kind == VariableKind::output ? logic_.outputs[target.index]
                                               : logic_.vars[target.index];
}

NetId AsynchronousFrame::trigger_net(const StoredWrite& write) {
    return logic_.net(write.trigger);
}

/// A stored variable that is read by the right-hand side of a write is read through a hold latch
/// that closes while a write to it is under way: right-hand sides see variables as they were.
void AsynchronousFrame::make_hold(const StoredEquation& stored) {
    std::vector<NetId> triggers;
    for (const StoredWrite& write : stored.writes) triggers.push_back(trigger_net(write));
    const NetId source = stored_net(stored.target);
    const std::string name(builder_.netlist().names[source]);
    const NetId idle = builder_.gate(CellType::nor_gate, triggers, name, "idle");
    const NetId held = builder_.add_net(name, "held");
    const NetId pins[] = {source, idle};
    builder_.add_cell(CellType::hold_latch, held, pins, {Logic::zero, {}});
    auto& table = stored.target.kind == VariableKind::output ? held_outputs_ : held_vars_;
    table[stored.target.index] = held;
}

void AsynchronousFrame::make_latch(const StoredEquation& stored) {
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
    builder_.add_cell(CellType::latch, stored_net(stored.target), pins, {Logic::zero, {}});
}

void AsynchronousFrame::make_stored() {
    held_outputs_.assign(grafcet_.outputs.size(), no_net);
    held_vars_.assign(grafcet_.vars.size(), no_net);
    // The hold latches have modules of their own: all are made before what reads them.
    const auto work_on = [&](const StoredEquation& stored, std::string_view part) {
        const bool is_output = stored.target.kind == VariableKind::output;
        const std::string name(builder_.netlist().names[stored_net(stored.target)]);
        const Location where = is_output ? grafcet_.outputs[OutputId{stored.target.index}].where
                                         : grafcet_.vars[VarId{stored.target.index}].where;
        const std::string comment =
            fmt::format("{}: set {} reset {}", name, equation_text(equations_, stored.set),
                        equation_text(equations_, stored.reset));
        const auto origin =
            builder_.add_origin(is_output ? Origin::Kind::output : Origin::Kind::var, name, where);
        builder_.work_on(builder_.add_module(name + std::string(part), comment), origin);
        logic_.owner = name + std::string(part);
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
        work_on(stored, "$hold");
        make_hold(stored);
    }
    for (const StoredEquation& stored : equations_.stored) {
        if (stored.writes.empty()) continue;
        if (stored.target.kind == VariableKind::var) driven[stored.target.index] = 1;
        work_on(stored, "");
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

}  // namespace grafwire
