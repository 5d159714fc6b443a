#include "evolution/run_record.h"

#include <cassert>
#include <utility>

namespace grafwire {

RunRecord::RunRecord(const Grafcet& grafcet)
    : grafcet_(grafcet), is_broken_(grafcet.assumptions.size(), false) {
    result_.trace = empty_trace(grafcet);
}

void RunRecord::check_assumptions(Time now, const InputValues& inputs) {
    for (std::size_t i = 0; i < is_broken_.size(); ++i) {
        if (is_broken_[i] || assumption_holds(grafcet_, i, inputs)) continue;
        is_broken_[i] = true;
        result_.broken_assumptions.push_back({now, i});
    }
}

void RunRecord::add_row(Time now, const Evolution& evolution, const EvolutionState& state,
                        const InputValues& inputs) {
    Trace& trace = result_.trace;
    trace.times.push_back(now);
    trace.values.insert(trace.values.end(), inputs.begin(), inputs.end());
    add_bits(state.situation);
    add_bits(evolution.outputs(state, {inputs}));
    for (std::size_t i = 0; i < grafcet_.vars.size(); ++i) {
        const bool value = evolution.var(grafcet_.vars.id_at(i), state, {inputs});
        trace.values.push_back(value ? 1 : 0);
    }
    trace.values.insert(trace.values.end(), state.counters.begin(), state.counters.end());
    assert(trace.values.size() == trace.times.size() * trace.columns.size());
}

void RunRecord::add_bits(const BitTable& table) {
    for (std::size_t i = 0; i < table.size(); ++i) {
        result_.trace.values.push_back(table.test(i) ? 1 : 0);
    }
}

void RunRecord::end_unstable(Time now, std::vector<std::string> changing) {
    result_.unstable_at = now;
    result_.changing = std::move(changing);
}

}  // namespace grafwire
