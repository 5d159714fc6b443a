// The search for a stable situation.
//
// With the inputs and the clock held, the state after a repetition is a function of the state
// before it, and there are finitely many states; so the repetitions either come to one that changes
// nothing or go round for ever. Which of the two is decided exactly, without a bound on the number
// of repetitions and without keeping all states: R. P. Brent, "An improved Monte Carlo
// factorization algorithm", BIT 20 (1980), keeps one earlier state, moves it up at the repetitions
// 1, 2, 4, 8, … and compares each new state with it. Once a state comes back, going round the cycle
// once more shows what changes in it.

#include <string>
#include <utility>

#include "evolution/bits.h"
#include "evolution/evolution.h"

namespace grafwire {

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
