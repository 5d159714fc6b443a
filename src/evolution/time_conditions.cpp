// Time conditions (SBR 6).
//
// `t1/e/t2` has a value and at most one running delay, kept as the moment `due` at which the value
// changes if e stays as it is. While e differs from the value a delay runs (t1 upwards, t2
// downwards); when e is back at the value the delay is dropped, and the next one starts anew:
//
//   e = value              no delay
//   e ≠ value, none runs   due = now + (e ? t1 : t2)
//   e ≠ value, due <= now  value = e, no delay
//
// A delay of 0 is due at once. Conditions are taken from the inside outwards, so that an outer one
// reads the inner ones as they are after this scan. Scan by scan a delay counts from the scan that
// first saw e, and ends in the first scan that is not before `due` and still sees e.

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

void Evolution::end_delays(EvolutionState& state, Time now) const {
    for (std::size_t i = 0; i < state.due.size(); ++i) {
        if (state.due[i] <= now && is_running(state, i)) end_delay(state, i);
    }
}

void Evolution::end_delay(EvolutionState& state, std::size_t time_condition) const {
    state.time_values.assign(time_condition, !state.time_values.test(time_condition));
    state.due[time_condition] = never;
}

}  // namespace grafwire
