// The run until stable is nothing but scans repeated at every instant: here they are repeated by
// hand, with our own idea of when an instant is over and of when a state has come back.

#include <doctest/doctest.h>

#include <algorithm>

#include "evolution/run.h"
#include "random/random_cases.h"
#include "random/read_text.h"

namespace grafwire::testing {

namespace {

bool is_over(const EvolutionState& before, const EvolutionState& after) {
    const BitTable no_edges(after.edges.size());
    return after.edges == no_edges && before.situation == after.situation &&
           before.may_evolve == after.may_evolve && before.time_values == after.time_values &&
           before.vars == after.vars && before.counters == after.counters &&
           before.stored_outputs == after.stored_outputs;
}

/// The scans of one instant; false where a state comes back.
bool repeat_scans(const Evolution& evolution, EvolutionState& state, const EvolutionInputs& inputs,
                  Time now) {
    std::vector<EvolutionState> seen;
    for (;;) {
        const EvolutionState before = state;
        evolution.scan(state, inputs, now);
        if (is_over(before, state)) return true;
        if (std::find(seen.begin(), seen.end(), state) != seen.end()) return false;
        seen.push_back(state);
    }
}

void append_bits(std::vector<std::int64_t>& row, const BitTable& bits) {
    for (std::size_t i = 0; i < bits.size(); ++i) row.push_back(bits.test(i) ? 1 : 0);
}

/// The trace by hand, and where it ends early.
RunResult run_by_hand(const Grafcet& grafcet, const Stimuli& stimuli) {
    const Evolution evolution(grafcet);
    RunResult result;
    result.trace = empty_trace(grafcet);
    InputValues inputs(grafcet.all_input_count(), 0);
    EvolutionState state;
    std::size_t next = 0;
    for (Time now = 0;;) {
        for (; next < stimuli.changes.size() && stimuli.changes[next].at <= now; ++next) {
            for (const auto& set : stimuli.changes[next].assignments) inputs[set.input] = set.value;
        }
        if (now == 0) {
            state = evolution.start({inputs});
        } else {
            evolution.end_delays(state, {inputs}, now);
        }
        if (!repeat_scans(evolution, state, {inputs}, now)) {
            result.unstable_at = now;
            return result;
        }
        result.trace.times.push_back(now);
        std::vector<std::int64_t>& row = result.trace.values;
        row.insert(row.end(), inputs.begin(), inputs.end());
        append_bits(row, state.situation);
        append_bits(row, evolution.outputs(state, {inputs}));
        for (std::size_t i = 0; i < grafcet.vars.size(); ++i) {
            row.push_back(evolution.var(grafcet.vars.id_at(i), state, {inputs}) ? 1 : 0);
        }
        row.insert(row.end(), state.counters.begin(), state.counters.end());

        if (now >= stimuli.end) return result;
        Time later = stimuli.end;
        for (const Time due : state.due) later = std::min(later, due);
        if (next < stimuli.changes.size()) later = std::min(later, stimuli.changes[next].at);
        now = later;
    }
}

std::string settles_as_by_hand(const RandomCase& item) {
    const auto grafcet = read_grafcet(item.chart);
    const auto stimuli = read_stimuli(item.stimuli, *grafcet);
    const RunResult expected = run_by_hand(*grafcet, *stimuli);
    const RunResult got = run_until_stable(*grafcet, *stimuli);
    if (got.unstable_at != expected.unstable_at) return "one is unstable, the other not";
    if (got.unstable_at.has_value() == got.changing.empty()) return "nothing changes, or all does";
    if (write_csv(got.trace) != write_csv(expected.trace)) {
        return "run until stable\n" + write_csv(got.trace) + "by hand\n" +
               write_csv(expected.trace);
    }
    return {};
}

/// Inputs that no scan of an instant consulted do not matter: flipped one by one and all at once.
std::string unread_inputs_do_not_matter(const RandomCase& item) {
    const auto grafcet = read_grafcet(item.chart);
    const auto stimuli = read_stimuli(item.stimuli, *grafcet);
    const Evolution evolution(*grafcet);
    InputValues inputs(grafcet->all_input_count(), 0);
    EvolutionState state = evolution.start({inputs});
    for (const Stimuli::Change& change : stimuli->changes) {
        for (const auto& set : change.assignments) inputs[set.input] = set.value;
        evolution.end_delays(state, {inputs}, change.at);
        const EvolutionState before = state;
        std::vector<std::uint8_t> consulted(inputs.size());
        const bool stable = evolution.settle(state, {inputs, &consulted}, change.at).stable;
        const OutputValues outputs = evolution.outputs(state, {inputs, &consulted});
        InputValues all_flipped = inputs;
        for (std::size_t i = 0; i <= inputs.size(); ++i) {
            InputValues flipped = i < inputs.size() ? inputs : all_flipped;
            if (i < inputs.size()) {
                if (consulted[i] != 0) continue;
                flipped[i] ^= 1;
                all_flipped[i] ^= 1;
            }
            EvolutionState again = before;
            const bool still = evolution.settle(again, {flipped}, change.at).stable;
            if (still != stable || again != state) {
                return "input " +
                       std::string(input_name(*grafcet, std::min(i, inputs.size() - 1))) +
                       " (or all) was not consulted at " + format_milliseconds(change.at) +
                       " ms, but matters";
            }
            if (evolution.outputs(again, {flipped}) != outputs) return "outputs read it unnoticed";
        }
        if (!stable) break;
    }
    return {};
}

}  // namespace

TEST_CASE("the run until stable is the run of repeated scans") {
    check_property(settles_as_by_hand, Features(), 300'000, 6000, 20);
}

TEST_CASE("inputs that were not consulted do not matter") {
    check_property(unread_inputs_do_not_matter, Features(), 400'000, 6000, 20);
}

}  // namespace grafwire::testing
