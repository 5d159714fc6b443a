// What an exploration has gone through, and what it has not.
//
// "Equivalent" says little of parts that no case exercised: a step that was never active, a
// transition never cleared, an input that was never both 0 and 1, an output that was never 1. They
// are collected case by case; an input that is unassigned in a case counts with both of its values,
// where the assumptions allow them. Every few cases the caller is asked whether to go on.

#include "check/coverage.h"

#include <algorithm>

#include "check/state_encoding.h"

namespace grafwire {

namespace {

constexpr std::uint64_t cases_between_questions = 16;

void add(BitTable& all, const BitTable& more) {
    for (std::size_t w = 0; w < all.words().size(); ++w) all.words()[w] |= more.words()[w];
}

}  // namespace

bool can_ever_act(const Grafcet& grafcet) {
    return std::any_of(grafcet.steps.begin(), grafcet.steps.end(),
                       [](const Step& step) { return step.initial; }) ||
           std::any_of(grafcet.transitions.begin(), grafcet.transitions.end(),
                       [](const Transition& t) { return t.preceding.count == 0; });
}

CoverageRecorder::CoverageRecorder(const Grafcet& grafcet, const Assumptions& assumptions,
                                   bool has_modes, const CheckOptions& options, Coverage& coverage)
    : grafcet_(grafcet),
      assumptions_(assumptions),
      options_(options),
      coverage_(coverage),
      input_count_(has_modes ? grafcet.all_input_count() : grafcet.inputs.size()),
      active_(grafcet.steps.size()),
      on_(grafcet.outputs.size()),
      cleared_(grafcet.transitions.size()),
      values_seen_(grafcet.all_input_count()) {
    for (std::size_t s = 0; s < grafcet.steps.size(); ++s) {
        if (grafcet.steps.items()[s].initial) active_.set(s);
    }
}

bool CoverageRecorder::record_case(const ReferenceOutcome& expected, const PartialInputs& inputs,
                                   std::size_t waiting) {
    add(active_, expected.state.situation);
    if (expected.stable) add(on_, expected.outputs);
    for (std::size_t t = 0; t < cleared_.size(); ++t) cleared_[t] |= expected.cleared[t];
    for (std::uint32_t i = 0; i < input_count_; ++i) {
        if (values_seen_[i] != 3) note_values(inputs, i);
    }
    ++coverage_.cases;
    if (!expected.stable) ++coverage_.unstable;
    coverage_.waiting = waiting;
    if (options_.max_cases != 0 && coverage_.cases >= options_.max_cases) return false;
    return coverage_.cases % cases_between_questions != 0 || goes_on();
}

void CoverageRecorder::record_situation(const BitTable& situation) {
    std::string encoding;
    encode(encoding, situation);
    if (situations_.insert(std::move(encoding)).second) ++coverage_.situations;
}

bool CoverageRecorder::goes_on() const {
    if (options_.progress) options_.progress(coverage_);
    return !options_.keep_going || options_.keep_going();
}

void CoverageRecorder::note_values(const PartialInputs& inputs, std::uint32_t input) {
    for (const PartialInput value : {PartialInput::zero, PartialInput::one}) {
        const auto bit = static_cast<std::uint8_t>(value == PartialInput::zero ? 1 : 2);
        if ((values_seen_[input] & bit) != 0) continue;
        PartialInputs assigned = inputs;
        if (assigned[input] == PartialInput::unassigned) assigned[input] = value;
        if (assigned[input] == value && assumptions_.can_hold(assigned)) values_seen_[input] |= bit;
    }
}

NeverExercised CoverageRecorder::never_exercised() const {
    // A step may be active for one scan only, on the way to a stable situation.
    BitTable active = active_;
    NeverExercised unexercised;
    for (std::size_t t = 0; t < cleared_.size(); ++t) {
        const TransitionId id = grafcet_.transitions.id_at(t);
        if (cleared_[t] == 0) {
            unexercised.transitions.push_back(id);
            continue;
        }
        for (const StepId step : grafcet_.following(grafcet_.transitions[id])) {
            active.set(index_of(step));
        }
    }
    for (std::size_t s = 0; s < grafcet_.steps.size(); ++s) {
        if (!active.test(s)) unexercised.steps.push_back(grafcet_.steps.id_at(s));
    }
    for (std::uint32_t i = 0; i < input_count_; ++i) {
        if (values_seen_[i] != 3) unexercised.inputs.push_back(i);
    }
    for (std::size_t o = 0; o < grafcet_.outputs.size(); ++o) {
        if (!on_.test(o)) unexercised.outputs.push_back(grafcet_.outputs.id_at(o));
    }
    return unexercised;
}

}  // namespace grafwire
