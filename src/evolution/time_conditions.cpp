// Time conditions (SBR 6).
//
// `t1/e/t2` has a value and at most one running delay, kept as the time `due` at which the value
// changes if e stays as it is. While e differs from the value a delay runs (t1 upwards, t2
// downwards); when e is back at the value the delay is dropped, and the next one starts from 0:
//
//   e = value              no delay
//   e ≠ value, none runs   due = now + (e ? t1 : t2)
//   e ≠ value, due <= now  value = e, no delay
//
// A delay of 0 is due at once. Conditions are taken from the inside outwards, so that an outer one
// reads the inner ones as they are after this scan. Scan by scan a delay counts from the scan that
// first saw e, and ends in the first scan that is not before `due` and still sees e. Until stable,
// a delay that ends exactly at an instant takes effect at its beginning, before SBR 1, so that the
// receptivities of the first repetition see it beside the inputs that changed with it; again only
// if e still asks for it, under the new inputs. So both ways of running agree on a delay whose
// operand changes at the very time at which it would have ended.

#include "evolution/scan_parts.h"

namespace grafwire {

void update_time_conditions(const ScanContext& scan) {
    const Expressions& expressions = scan.grafcet.expressions;
    EvolutionState& state = scan.state;
    for (std::size_t i = 0; i < expressions.time_conditions().size(); ++i) {
        const TimeCondition& condition =
            expressions.time_condition_of(expressions.time_conditions()[i]);
        const bool operand = scan.read.value(condition.operand);
        Time& due = state.due[i];
        if (operand == state.time_values.test(i)) {
            due = never;
            continue;
        }
        if (due == never) {
            due = add_times(scan.now, operand ? condition.on_delay : condition.off_delay);
        }
        if (due <= scan.now) {
            state.time_values.assign(i, operand);
            due = never;
        }
    }
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

}  // namespace grafwire
