// The reference evolution.
//
// The table method of Yves Cordier, "Méthode d'implémentation du GRAFCET" (1998), written there for
// 80 steps on an S7-200 and here for any number: one bit per step in `Tp` (the situation when the
// scan began) and `Ts` (the situation being computed), and the subroutines SBR 1 to SBR 8 in their
// order. It is chosen as the reference because each of the five rules of GRAFCET can be pointed at
// in it: rule 1 is SBR 0, rules 2 to 4 are the test of each transition on the unchanged `Tp`, and
// rule 5 is the order of operations in `Ts = Tp . /Td + Ta`.
//
// Two things are done otherwise for speed, with the same result:
// - A receptivity is read only where it can matter: for an enabled transition of a graph that may
//   evolve, while Init is 0. Reading an expression changes nothing, so the bits of `Tt` that nobody
//   would look at need not be computed.
// - `Td` and `Ta` are not built as tables. All preceding steps of the cleared transitions are
//   switched off in `Ts`, then all following ones on; that is `Tp . /Td + Ta` on the bits
//   concerned.
//
// A scan thus costs a few passes over the words of the step tables plus the work for the active
// steps, the edges and the time conditions.

#include "evolution/evolution.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <string>
#include <utility>

#include "evolution/bit_table.h"
#include "evolution/subroutines.h"
#include "evolution/tables.h"

namespace grafwire {

namespace {

/// SBR 2. With `at_start`, only the memories are filled: nothing has an edge then.
void update_edges(const ScanContext& scan, bool at_start) {
    const Expressions& expressions = scan.grafcet.expressions;
    EvolutionState& state = scan.state;
    for (std::size_t i = 0; i < expressions.edges().size(); ++i) {
        const ExprId edge = expressions.edges()[i];
        const bool now = scan.read.value(expressions.operands(edge).front());
        const bool before = state.edge_memory.test(i);
        const bool is_rise = expressions.kind(edge) == ExprKind::rise;
        state.edges.assign(i, !at_start && now != before && now == is_rise);
        state.edge_memory.assign(i, now);
    }
}

/// SBR 3 for the transitions that are enabled in `Tp`: those that are cleared, in no order.
/// `may_clear`: as of EvolutionInputs.
void list_cleared(const ScanContext& scan, const std::vector<std::uint8_t>* may_clear,
                  ClearedList& cleared) {
    const Grafcet& grafcet = scan.grafcet;
    const BitTable& before = scan.state.previous;
    const auto consider = [&](TransitionId id) {
        if (may_clear != nullptr && (*may_clear)[index_of(id)] == 0) return;
        const Transition& transition = grafcet.transitions[id];
        if (!scan.state.may_evolve.test(index_of(transition.graph))) return;
        for (const StepId step : grafcet.preceding(transition)) {
            if (!before.test(index_of(step))) return;
        }
        if (scan.read.value(transition.condition)) cleared.push_back(id);
    };
    for_each_bit(before, [&](std::size_t step) {
        for (const TransitionId id : scan.tables.answered_by(step)) consider(id);
    });
    for (const TransitionId id : scan.tables.sources) consider(id);
}

std::vector<TransitionId> in_table_order(const ClearedList& cleared) {
    std::vector<TransitionId> result(cleared.begin(), cleared.end());
    std::sort(result.begin(), result.end());
    return result;
}

/// SBR 4: `Ts = Tp . /Td + Ta`. Activation wins (rule 5).
void clear_transitions(const ScanContext& scan, const ClearedList& cleared) {
    const Grafcet& grafcet = scan.grafcet;
    BitTable& situation = scan.state.situation;
    for (const TransitionId id : cleared) {
        for (const StepId step : grafcet.preceding(grafcet.transitions[id])) {
            situation.reset(index_of(step));
        }
    }
    for (const TransitionId id : cleared) {
        for (const StepId step : grafcet.following(grafcet.transitions[id])) {
            situation.set(index_of(step));
        }
    }
}

/// The part of SBR 8 that the next scan needs.
void update_freeze_bits(const ScanContext& scan) {
    if (scan.grafcet.orders.empty()) return;  // all 1 since the start
    scan.state.may_evolve = scan.tables.all_graphs;
    for_each_common_bit(scan.state.situation, scan.tables.freezing, [&](std::size_t s) {
        const Step& step = scan.grafcet.steps[scan.grafcet.steps.id_at(s)];
        for (const Action& action : scan.grafcet.actions_of(step)) {
            if (action.kind != ActionKind::order) continue;
            const Order& order = scan.grafcet.orders[action.order];
            if (order.kind == OrderKind::freeze) scan.state.may_evolve.reset(index_of(order.graph));
        }
    });
}

}  // namespace

Evolution::Evolution(const Grafcet& grafcet)
    : grafcet_(&grafcet), tables_(std::make_unique<Tables>(grafcet)) {}
Evolution::~Evolution() = default;
Evolution::Evolution(Evolution&&) noexcept = default;
Evolution& Evolution::operator=(Evolution&&) noexcept = default;

EvolutionState Evolution::start(const EvolutionInputs& inputs) const {
    const Grafcet& grafcet = *grafcet_;
    EvolutionState state;
    state.situation = tables_->initial;
    state.previous = tables_->initial;
    state.may_evolve = tables_->all_graphs;
    state.stored_outputs = BitTable(grafcet.outputs.size());
    state.vars = BitTable(grafcet.vars.size());
    for (const Counter& counter : grafcet.counters) state.counters.push_back(counter.low);
    state.edge_memory = BitTable(grafcet.expressions.edges().size());
    state.edges = BitTable(grafcet.expressions.edges().size());
    state.time_values = BitTable(grafcet.expressions.time_conditions().size());
    state.due.assign(grafcet.expressions.time_conditions().size(), never);
    update_edges({grafcet, *tables_, state, Evaluator(grafcet, *tables_, state, inputs), 0}, true);
    return state;
}

void Evolution::scan(EvolutionState& state, const EvolutionInputs& inputs, Time now,
                     ScanRecord* record) const {
    const ScanContext scan{
        *grafcet_, *tables_, state, Evaluator(*grafcet_, *tables_, state, inputs), now, record};
    state.previous = state.situation;  // SBR 1
    update_edges(scan, false);         // SBR 2

    const bool init = scan.read.input(tables_->init);  // SBR 3 and 4
    ClearedList cleared;
    if (init) {
        state.situation = tables_->initial;
    } else {
        list_cleared(scan, inputs.may_clear, cleared);
        clear_transitions(scan, cleared);
        if (inputs.cleared != nullptr) {
            for (const TransitionId id : cleared) (*inputs.cleared)[index_of(id)] = 1;
        }
    }
    if (record != nullptr) {
        record->cleared = in_table_order(cleared);
        record->after_clearing = state.situation;
    }

    apply_forcing(scan, init);  // SBR 5
    if (scan.read.input(tables_->au_dur)) state.situation.clear();
    run_stored_actions(scan, cleared);

    update_time_conditions(scan);  // SBR 6
    update_freeze_bits(scan);      // SBR 8
}

void Evolution::end_delays(EvolutionState& state, const EvolutionInputs& inputs, Time now) const {
    const Evaluator read(*grafcet_, *tables_, state, inputs);
    const Expressions& expressions = grafcet_->expressions;
    for (std::size_t i = 0; i < state.due.size(); ++i) {
        if (!is_running(state, i) || state.due[i] > now) continue;
        const ExprId id = expressions.time_conditions()[i];
        const bool operand = read.value(expressions.time_condition_of(id).operand);
        if (operand == state.time_values.test(i)) continue;
        state.time_values.assign(i, operand);
        state.due[i] = never;
    }
}

OutputValues Evolution::outputs(const EvolutionState& state, const EvolutionInputs& inputs) const {
    const Evaluator read(*grafcet_, *tables_, state, inputs);
    OutputValues outputs = state.stored_outputs;
    std::optional<bool> all_off;  // AUdoux, which matters only once something would be on
    for_each_common_bit(state.situation, tables_->continuous, [&](std::size_t s) {
        const Step& step = grafcet_->steps[grafcet_->steps.id_at(s)];
        for (const Action& action : grafcet_->actions_of(step)) {
            if (all_off.value_or(false)) return;
            if (action.kind != ActionKind::continuous) continue;
            if (outputs.test(index_of(action.output))) continue;
            if (action.expression != no_expr && !read.value(action.expression)) continue;
            if (!all_off) all_off = read.input(tables_->au_doux);
            if (!*all_off) outputs.set(index_of(action.output));
        }
    });
    return outputs;
}

bool Evolution::var(VarId var, const EvolutionState& state, const EvolutionInputs& inputs) const {
    const Var& item = grafcet_->vars[var];
    if (!item.is_held()) return state.vars.test(index_of(var));
    return Evaluator(*grafcet_, *tables_, state, inputs).value(item.held);
}

bool Evolution::value(ExprId expression, const EvolutionState& state,
                      const EvolutionInputs& inputs) const {
    return Evaluator(*grafcet_, *tables_, state, inputs).value(expression);
}

std::vector<TransitionId> Evolution::cleared_by_scan(const EvolutionState& state,
                                                     const EvolutionInputs& inputs,
                                                     Time now) const {
    EvolutionState copy = state;
    const ScanContext scan{*grafcet_, *tables_, copy, Evaluator(*grafcet_, *tables_, copy, inputs),
                           now};
    copy.previous = copy.situation;
    update_edges(scan, false);
    ClearedList cleared;
    if (!scan.read.input(tables_->init)) list_cleared(scan, inputs.may_clear, cleared);
    return in_table_order(cleared);
}

// The search for a stable situation.
//
// With the inputs and the clock held, the state after a repetition is a function of the state
// before it, and there are finitely many states; so the repetitions either come to one that changes
// nothing or go round for ever. Which of the two is decided exactly, without a bound on the number
// of repetitions and without keeping all states: R. P. Brent, "An improved Monte Carlo
// factorization algorithm", BIT 20 (1980), keeps one earlier state, moves it up at the repetitions
// 1, 2, 4, 8, … and compares each new state with it. Once a state comes back, going round the cycle
// once more shows what changes in it.

namespace {

constexpr std::uint64_t repetitions_between_questions = 256;

/// Collects the bits in which tables differ from a first one.
class Differences {
  public:
    explicit Differences(const BitTable& first) : first_(first), differing_(first.size()) {}

    void compare(const BitTable& other) {
        for (std::size_t w = 0; w < first_.words().size(); ++w) {
            differing_.words()[w] |= first_.words()[w] ^ other.words()[w];
        }
    }
    const BitTable& differing() const { return differing_; }

  private:
    BitTable first_;
    BitTable differing_;
};

/// What changes while the evolution goes round the cycle that `state` is on.
std::vector<std::string> changing_in_cycle(const Evolution& evolution, EvolutionState state,
                                           const EvolutionInputs& inputs, Time now) {
    const Grafcet& grafcet = evolution.grafcet();
    const EvolutionState first = state;
    Differences steps(first.situation);
    Differences outputs(first.stored_outputs);
    Differences vars(first.vars);
    BitTable counters(first.counters.size());
    do {
        evolution.scan(state, inputs, now);
        steps.compare(state.situation);
        outputs.compare(state.stored_outputs);
        vars.compare(state.vars);
        for (std::size_t c = 0; c < first.counters.size(); ++c) {
            if (first.counters[c] != state.counters[c]) counters.set(c);
        }
    } while (state != first);

    std::vector<std::string> names;
    for_each_bit(steps.differing(), [&](std::size_t i) {
        names.push_back("X" + grafcet.steps[grafcet.steps.id_at(i)].name);
    });
    for_each_bit(outputs.differing(), [&](std::size_t i) {
        names.push_back(grafcet.outputs[grafcet.outputs.id_at(i)].name);
    });
    for_each_bit(vars.differing(),
                 [&](std::size_t i) { names.push_back(grafcet.vars[grafcet.vars.id_at(i)].name); });
    for_each_bit(counters, [&](std::size_t i) {
        names.push_back(grafcet.counters[grafcet.counters.id_at(i)].name);
    });
    return names;
}

}  // namespace

bool Evolution::is_settled(const EvolutionState& before, const EvolutionState& after) {
    for (const std::uint64_t word : after.edges.words()) {
        if (word != 0) return false;
    }
    return before.situation == after.situation && before.may_evolve == after.may_evolve &&
           before.time_values == after.time_values && before.vars == after.vars &&
           before.counters == after.counters && before.stored_outputs == after.stored_outputs;
}

SettleResult Evolution::settle(EvolutionState& state, const EvolutionInputs& inputs, Time now,
                               const KeepGoing& keep_going) const {
    SettleResult result;
    EvolutionState before = state;
    EvolutionState landmark;          // Brent's earlier state
    std::uint64_t next_landmark = 1;  // the repetition after which it is moved up
    for (std::uint64_t repetition = 1;; ++repetition) {
        scan(state, inputs, now);
        if (result.repetitions != UINT32_MAX) ++result.repetitions;
        if (is_settled(before, state)) return result;
        if (repetition > 1 && state == landmark) {
            result.stable = false;
            result.changing = changing_in_cycle(*this, state, inputs, now);
            return result;
        }
        if (repetition == next_landmark) {
            landmark = state;
            next_landmark *= 2;
        }
        if (repetition % repetitions_between_questions == 0 && keep_going && !keep_going()) {
            result.broken_off = true;
            return result;
        }
        before = state;
    }
}

}  // namespace grafwire
