#pragma once

#include <cstdint>
#include <vector>

#include "check/partial_inputs.h"
#include "evolution/evolution.h"
#include "grafcet/grafcet.h"

namespace grafwire {

struct ReferenceOutcome;

/// The parts of a GRAFCET that no case of an exploration exercised, each in table order. What a
/// verdict says of them is little.
struct NeverExercised {
    std::vector<StepId> steps;              ///< never active
    std::vector<TransitionId> transitions;  ///< never cleared
    std::vector<std::uint32_t> inputs;      ///< never both 0 and 1; numbered as in Stimuli
    std::vector<OutputId> outputs;          ///< never 1
    bool none() const { return *this == NeverExercised(); }
    bool operator==(const NeverExercised&) const = default;
};

/// Whether anything can ever happen in a GRAFCET: some step is initial, or some transition without
/// preceding steps activates one. Where not, a check would have nothing to say.
bool can_ever_act(const Grafcet& grafcet);

/// Notes what the cases of an exploration exercise.
class Exercised {
  public:
    /// `has_modes`: whether Init, AUdur and AUdoux can change. GRAFCET and assumptions must outlive
    /// it.
    Exercised(const Grafcet& grafcet, const Assumptions& assumptions, bool has_modes);

    /// A case of the reference, under inputs that are partly open: these take both values, as far
    /// as the assumptions let them.
    void note(const ReferenceOutcome& outcome, const PartialInputs& inputs);
    NeverExercised never() const;

  private:
    void note_values(const PartialInputs& inputs, std::uint32_t input);

    const Grafcet& grafcet_;
    const Assumptions& assumptions_;
    std::size_t input_count_;
    BitTable active_;
    BitTable on_;
    std::vector<std::uint8_t> cleared_;
    std::vector<std::uint8_t> values_seen_;  ///< per input: 1 for 0, 2 for 1, and both
};

}  // namespace grafwire
