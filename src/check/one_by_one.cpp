// From a path whose inputs are partly open to one with a single change at an instant.
//
// An input that is open in a state can change there without an effect. A path says only what it has
// to be by the time somebody reads it, so several may have to be brought to their values between
// two of its instants. Here each of these changes gets an instant of its own, in an order in which
// the assumptions hold all the way; it is searched for depth first. Where there is none (of two
// complementary contacts neither can change alone), they change together.

#include <algorithm>

#include "check/path.h"

namespace grafwire {

namespace {

constexpr int most_trials = 2000;

/// Puts changes into an order in which the assumptions hold after each; false where none is found.
bool put_in_order(const Assumptions& assumptions, InputValues values,
                  std::vector<Stimuli::Assignment>& changes, std::size_t done, int& trials) {
    if (done == changes.size()) return true;
    for (std::size_t next = done; next < changes.size() && ++trials < most_trials; ++next) {
        std::swap(changes[done], changes[next]);
        InputValues after = values;
        after[changes[done].input] = changes[done].value ? 1 : 0;
        if (assumptions.can_hold(known_inputs(after)) &&
            put_in_order(assumptions, after, changes, done + 1, trials)) {
            return true;
        }
        std::swap(changes[done], changes[next]);
    }
    return false;
}

/// Appends instants that bring the inputs from some values to others without an effect.
void append_changes(const Assumptions& assumptions, const InputValues& from, const InputValues& to,
                    std::vector<PathStep>& path) {
    std::vector<Stimuli::Assignment> changes = differences(from, to);
    int trials = 0;
    if (!put_in_order(assumptions, from, changes, 0, trials)) {
        path.push_back({known_inputs(from), known_inputs(to), {}, {}});
        return;
    }
    InputValues values = from;
    for (const Stimuli::Assignment& change : changes) {
        PathStep step;
        step.before = known_inputs(values);
        values[change.input] = change.value ? 1 : 0;
        step.inputs = known_inputs(values);
        path.push_back(std::move(step));
    }
}

}  // namespace

std::optional<std::vector<PathStep>> one_by_one(const Assumptions& assumptions,
                                                const std::vector<PathStep>& path,
                                                std::size_t input_count) {
    std::vector<PathStep> result;
    std::vector<std::size_t> place;  // per step of the path: where it stands in the result
    InputValues present(input_count, 0);
    for (std::size_t i = 0; i < path.size(); ++i) {
        PathStep step = path[i];
        if (i != 0) {
            const auto before = assumptions.complete(step.before, present);
            if (!before) return std::nullopt;
            append_changes(assumptions, present, *before, result);
            present = *before;
        }
        const auto inputs = assumptions.complete(step.inputs, present);
        if (!inputs) return std::nullopt;
        step.before = known_inputs(present);
        present = *inputs;
        step.inputs = known_inputs(present);
        for (RunningDelay& delay : step.running) delay.begun = place[delay.begun];
        place.push_back(result.size());
        result.push_back(std::move(step));
    }
    return result;
}

}  // namespace grafwire
