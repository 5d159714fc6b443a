// What of a state two explorations compare, and how it is encoded: only what an X or an output can
// ever depend on (a cone of influence, as in model checking: E. M. Clarke, O. Grumberg, D. Peled,
// "Model Checking", 1999, section 13.1).
//
// Backwards from what is compared: the situation depends on every receptivity, an output on its
// conditions or on the writes to it; a var or counter matters once something relevant reads it, and
// then so does all that is written to it. Repeated until nothing is added; each round costs a pass
// over the actions, and there are at most as many rounds as vars and counters.
//
// Dropping the rest from a state is sound only if it has no say in whether an instant becomes
// stable. So what is written on an event or on clearing, which can go on while the situation stays
// as it is, counts as relevant; what is written on activation and deactivation alone changes with
// the situation and rests with it.

#include "check/state_encoding.h"

namespace grafwire {

namespace {

void encode_common_bits(std::string& encoding, const BitTable& bits, const BitTable& mask) {
    for (std::size_t w = 0; w < bits.words().size(); ++w) {
        const std::uint64_t word = bits.words()[w] & mask.words()[w];
        encoding.append(reinterpret_cast<const char*>(&word), sizeof(word));
    }
}

}  // namespace

void encode(std::string& encoding, const BitTable& bits) {
    const auto& words = bits.words();
    encoding.append(reinterpret_cast<const char*>(words.data()), words.size() * sizeof(words[0]));
}

Relevance::Relevance(const Grafcet& grafcet)
    : expressions_(grafcet.expressions.size()),
      vars_(grafcet.vars.size()),
      edges_(grafcet.expressions.edges().size()),
      times_bits_(grafcet.expressions.time_conditions().size()),
      times_(grafcet.expressions.time_conditions().size()),
      counters_(grafcet.counters.size()) {
    for (const Transition& transition : grafcet.transitions) read(grafcet, transition.condition);
    for (const Action& action : grafcet.actions) {
        if (action.kind == ActionKind::continuous) read(grafcet, action.expression);
    }
    for (const Action& action : grafcet.actions) {
        if (action.kind != ActionKind::stored || action.trigger != Trigger::event) continue;
        make_relevant(action.write.target);
    }
    for (const ClearingAction& action : grafcet.clearing_actions) {
        make_relevant(action.write.target);
    }
    do {
        grew_ = false;
        read_writes_to_relevant(grafcet);
    } while (grew_);
}

void Relevance::read_writes_to_relevant(const Grafcet& grafcet) {
    for (const Action& action : grafcet.actions) {
        if (action.kind != ActionKind::stored || !writes_relevant(action.write)) continue;
        if (action.trigger == Trigger::event) read(grafcet, action.expression);
        read_write(grafcet, action.write);
    }
    for (const ClearingAction& action : grafcet.clearing_actions) {
        if (writes_relevant(action.write)) read_write(grafcet, action.write);
    }
}

bool Relevance::writes_relevant(const Write& write) const {
    switch (write.target.kind) {
        case VariableKind::var:
            return vars_.test(write.target.index);
        case VariableKind::counter:
            return counters_[write.target.index] != 0;
        default:
            return true;  // an output
    }
}

void Relevance::read_write(const Grafcet& grafcet, const Write& write) {
    read(grafcet, write.value);
    if (write.sum != none) read_sum(grafcet.sums[write.sum]);
}

void Relevance::read_sum(const Sum& sum) {
    for (const SumTerm& term : sum) {
        if (term.counter == SumTerm::no_counter) continue;
        make_relevant({VariableKind::counter, term.counter});
    }
}

void Relevance::make_relevant(Variable variable) {
    if (variable.kind == VariableKind::var && !vars_.test(variable.index)) {
        vars_.set(variable.index);
        grew_ = true;
    } else if (variable.kind == VariableKind::counter && counters_[variable.index] == 0) {
        counters_[variable.index] = 1;
        grew_ = true;
    }
}

void Relevance::read(const Grafcet& grafcet, ExprId id) {
    if (id == no_expr || expressions_[static_cast<std::size_t>(id)] != 0) return;
    expressions_[static_cast<std::size_t>(id)] = 1;
    const Expressions& pool = grafcet.expressions;
    switch (pool.kind(id)) {
        case ExprKind::variable:
            make_relevant(pool.variable_of(id));
            break;
        case ExprKind::comparison:
            read_sum(pool.comparison_of(id).left);
            read_sum(pool.comparison_of(id).right);
            break;
        case ExprKind::rise:
        case ExprKind::fall:
            edges_.set(pool.ordinal(id));
            break;
        case ExprKind::time_condition:
            times_[pool.ordinal(id)] = 1;
            times_bits_.set(pool.ordinal(id));
            read(grafcet, pool.time_condition_of(id).operand);
            break;
        default:
            break;
    }
    for (const ExprId operand : pool.operands(id)) read(grafcet, operand);
}

void Relevance::encode(std::string& encoding, const EvolutionState& state) const {
    for (const BitTable* bits : {&state.situation, &state.may_evolve, &state.stored_outputs}) {
        grafwire::encode(encoding, *bits);
    }
    encode_common_bits(encoding, state.vars, vars_);
    encode_common_bits(encoding, state.edge_memory, edges_);
    encode_common_bits(encoding, state.time_values, times_bits_);
    for (std::size_t c = 0; c < counters_.size(); ++c) {
        if (counters_[c] == 0) continue;
        encoding.append(reinterpret_cast<const char*>(&state.counters[c]), sizeof(std::int64_t));
    }
}

}  // namespace grafwire
