#include "check/exercised.h"

#include <algorithm>

#include "check/reference_case.h"

namespace grafwire {

namespace {

void add(BitTable& all, const BitTable& more) {
    for (std::size_t w = 0; w < all.words().size(); ++w) all.words()[w] |= more.words()[w];
}

}  // namespace

bool can_ever_act(const Grafcet& grafcet) {
    return std::any_of(grafcet.steps.begin(), grafcet.steps.end(),
                       [](const Step& step) { return step.initial; }) ||
           std::any_of(grafcet.transitions.begin(), grafcet.transitions.end(),
                       [](const Transition& t) { return t.preceding_count == 0; });
}

Exercised::Exercised(const Grafcet& grafcet, const Assumptions& assumptions, bool has_modes)
    : grafcet_(grafcet),
      assumptions_(assumptions),
      input_count_(has_modes ? grafcet.all_input_count() : grafcet.inputs.size()),
      active_(grafcet.steps.size()),
      on_(grafcet.outputs.size()),
      cleared_(grafcet.transitions.size()),
      values_seen_(grafcet.all_input_count()) {
    for (std::size_t s = 0; s < grafcet.steps.size(); ++s) {
        if (grafcet.steps.items()[s].initial) active_.set(s);
    }
}

void Exercised::note(const ReferenceOutcome& outcome, const PartialInputs& inputs) {
    add(active_, outcome.state.situation);
    if (outcome.stable) add(on_, outcome.outputs);
    for (std::size_t t = 0; t < cleared_.size(); ++t) cleared_[t] |= outcome.cleared[t];
    for (std::uint32_t i = 0; i < input_count_; ++i) {
        if (values_seen_[i] != 3) note_values(inputs, i);
    }
}

void Exercised::note_values(const PartialInputs& inputs, std::uint32_t input) {
    for (const Logic value : {Logic::zero, Logic::one}) {
        const auto bit = static_cast<std::uint8_t>(value == Logic::zero ? 1 : 2);
        if ((values_seen_[input] & bit) != 0) continue;
        PartialInputs closed = inputs;
        if (closed[input] == Logic::unknown) closed[input] = value;
        if (closed[input] == value && assumptions_.can_hold(closed)) values_seen_[input] |= bit;
    }
}

NeverExercised Exercised::never() const {
    // A step may be active for one scan only, on the way to a stable situation.
    BitTable active = active_;
    NeverExercised never;
    for (std::size_t t = 0; t < cleared_.size(); ++t) {
        const TransitionId id = grafcet_.transitions.id_at(t);
        if (cleared_[t] == 0) {
            never.transitions.push_back(id);
            continue;
        }
        for (const StepId step : grafcet_.following(grafcet_.transitions[id])) {
            active.set(index_of(step));
        }
    }
    for (std::size_t s = 0; s < grafcet_.steps.size(); ++s) {
        if (!active.test(s)) never.steps.push_back(grafcet_.steps.id_at(s));
    }
    for (std::uint32_t i = 0; i < input_count_; ++i) {
        if (values_seen_[i] != 3) never.inputs.push_back(i);
    }
    for (std::size_t o = 0; o < grafcet_.outputs.size(); ++o) {
        if (!on_.test(o)) never.outputs.push_back(grafcet_.outputs.id_at(o));
    }
    return never;
}

}  // namespace grafwire
