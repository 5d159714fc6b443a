// Stored outputs and vars of the asynchronous styles: a latch each, set and reset by the pulses of
// their writes. Where several writes happen at once the last one wins, so each write is blocked by
// the triggers of the later ones.

#include <fmt/format.h>

#include <algorithm>

#include "equations/logic.h"
#include "netlist/styles/asynchronous.h"

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

void make_stored_latches(AsynchronousBuild& build) {
    StoredLatches(build).make();
}

}  // namespace grafwire
