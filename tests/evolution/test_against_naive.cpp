// Random charts, random inputs: the evolution on bit tables against the plain one, scan by scan and
// until stable, and the promise that inputs which were not consulted did not matter.

#include <doctest/doctest.h>

#include "evolution/run_text.h"
#include "random/random_grafcet.h"
#include "support/naive_evolution.h"

namespace grafwire::testing {

namespace {

std::vector<bool> bits(const BitTable& table) {
    std::vector<bool> result;
    for (std::size_t i = 0; i < table.size(); ++i) result.push_back(table.test(i));
    return result;
}

bool same(const EvolutionState& fast, const NaiveState& naive) {
    for (std::size_t i = 0; i < naive.waiting.size(); ++i) {
        if (naive.waiting[i] != Evolution::is_running(fast, i)) return false;
    }
    return bits(fast.situation) == naive.ts && bits(fast.previous) == naive.tp &&
           bits(fast.may_evolve) == naive.tfig && bits(fast.edges) == naive.edge_values &&
           bits(fast.edge_memory) == naive.edge_memories &&
           bits(fast.stored_outputs) == naive.stored && bits(fast.vars) == naive.vars &&
           fast.counters == naive.counters && bits(fast.time_values) == naive.times;
}

/// Everything but assumptions, which the inputs here would not keep.
Features features() {
    Features features;
    features.steps = 8;
    features.assumptions = false;
    return features;
}

Time milliseconds(std::size_t count) {
    return static_cast<Time>(count) * millisecond;
}

void flip_some(InputValues& inputs, RandomSource& random) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const bool is_control = i + control_input_count >= inputs.size();
        if (is_control) {
            inputs[i] = random.one_in(12) ? 1 : 0;
        } else if (random.one_in(3)) {
            inputs[i] ^= 1;
        }
    }
}

/// The inputs with random values for all those not consulted.
InputValues with_others_changed(const InputValues& inputs,
                                const std::vector<std::uint8_t>& consulted, RandomSource& random) {
    InputValues changed = inputs;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (consulted[i] == 0) changed[i] = static_cast<std::uint8_t>(random.below(2));
    }
    return changed;
}

/// One chart through some fifty scans; false at the first difference.
bool agrees_scan_by_scan(const Grafcet& grafcet, RandomSource& random) {
    const Evolution fast(grafcet);
    const NaiveEvolution naive(grafcet);
    InputValues inputs(grafcet.all_input_count(), 0);
    flip_some(inputs, random);
    EvolutionState state = fast.start({inputs});
    NaiveState expected = naive.start(inputs);
    Time now = 0;
    for (int scan = 0; scan < 50; ++scan, now += milliseconds(random.below(3))) {
        std::vector<bool> cleared(grafcet.transitions.size(), false);
        for (const TransitionId id : fast.cleared_by_scan(state, {inputs}, now)) {
            cleared[index_of(id)] = true;
        }
        if (cleared != naive.cleared(expected, inputs)) return false;

        std::vector<std::uint8_t> consulted(inputs.size());
        const EvolutionState before = state;
        fast.scan(state, {inputs, &consulted}, now);
        naive.scan(expected, inputs, now);
        if (!same(state, expected)) return false;
        std::vector<std::uint8_t> consulted_by_outputs(inputs.size());
        const OutputValues outputs = fast.outputs(state, {inputs, &consulted_by_outputs});
        if (bits(outputs) != naive.outputs(expected, inputs)) return false;
        const std::vector<bool> held = naive.held_vars(expected, inputs);
        for (std::size_t i = 0; i < held.size(); ++i) {
            const VarId var = grafcet.vars.id_at(i);
            if (grafcet.vars[var].is_held() && fast.var(var, state, {inputs}) != held[i])
                return false;
        }

        for (int i = 0; i < 3; ++i) {
            EvolutionState again = before;
            fast.scan(again, {with_others_changed(inputs, consulted, random)}, now);
            if (again != state) return false;
            if (fast.outputs(state, {with_others_changed(inputs, consulted_by_outputs, random)}) !=
                outputs) {
                return false;
            }
        }
        flip_some(inputs, random);
    }
    return true;
}

bool agrees_until_stable(const Grafcet& grafcet, RandomSource& random, int& unstable_count) {
    const Evolution fast(grafcet);
    const NaiveEvolution naive(grafcet);
    InputValues inputs(grafcet.all_input_count(), 0);
    flip_some(inputs, random);
    EvolutionState state = fast.start({inputs});
    NaiveState expected = naive.start(inputs);
    Time now = 0;
    for (int instant = 0; instant < 30; ++instant, now += milliseconds(1 + random.below(3))) {
        fast.end_delays(state, {inputs}, now);
        naive.end_delays(expected, inputs, now);
        if (!same(state, expected)) return false;
        const EvolutionState before = state;
        std::vector<std::uint8_t> consulted(inputs.size());
        const SettleResult result = fast.settle(state, {inputs, &consulted}, now);
        std::vector<std::string> changing;
        const bool stable = naive.settle(expected, inputs, now, changing);
        if (result.stable != stable || result.changing != changing) return false;

        EvolutionState again = before;
        const SettleResult result_again =
            fast.settle(again, {with_others_changed(inputs, consulted, random)}, now);
        if (again != state || result_again.changing != changing) return false;
        if (!stable) {
            ++unstable_count;
            return !changing.empty();
        }
        if (!same(state, expected)) return false;
        flip_some(inputs, random);
    }
    return true;
}

}  // namespace

TEST_CASE("random charts evolve as in the plain method, scan by scan") {
    for (std::uint64_t seed = 0; seed < 1500; ++seed) {
        RandomSource random(seed);
        const std::string text = random_grafcet(random, features());
        const Grafcet grafcet = grafcet_from(text);
        if (!agrees_scan_by_scan(grafcet, random)) FAIL("seed " << seed << "\n" << text);
    }
}

TEST_CASE("random charts evolve as in the plain method, until stable") {
    int unstable_count = 0;
    for (std::uint64_t seed = 0; seed < 1500; ++seed) {
        RandomSource random(seed);
        const std::string text = random_grafcet(random, features());
        const Grafcet grafcet = grafcet_from(text);
        if (!agrees_until_stable(grafcet, random, unstable_count)) {
            FAIL("seed " << seed << "\n" << text);
        }
    }
    CHECK(unstable_count > 50);  // both outcomes occur often
    CHECK(unstable_count < 1450);
}

}  // namespace grafwire::testing
