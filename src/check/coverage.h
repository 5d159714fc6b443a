#pragma once

#include <cstdint>
#include <string>
#include <unordered_set>
#include <vector>

#include "check/check_result.h"
#include "check/partial_inputs.h"
#include "check/reference_case.h"
#include "evolution/evolution.h"
#include "grafcet/grafcet.h"

namespace grafwire {

/// Whether anything can ever happen in a GRAFCET: some step is initial, or some transition without
/// preceding steps activates one. Where not, a check would have nothing to say.
bool can_ever_act(const Grafcet& grafcet);

/// Records what an exploration goes through: it counts cases and situations, keeps within the
/// bounds, and notes what of the GRAFCET was exercised.
class CoverageRecorder {
  public:
    /// `has_modes`: whether Init, AUdur and AUdoux can change. All that is referred to must outlive
    /// it.
    CoverageRecorder(const Grafcet& grafcet, const Assumptions& assumptions, bool has_modes,
                     const CheckOptions& options, Coverage& coverage);

    /// One more case, under partial inputs: those unassigned take both values, as far as the
    /// assumptions let them. `waiting`: the states still to be expanded. False where the
    /// exploration has to end with this case.
    bool record_case(const ReferenceOutcome& expected, const PartialInputs& inputs,
                     std::size_t waiting);
    /// The situation of a state that was reached.
    void record_situation(const BitTable& situation);
    /// Reports the progress, and says whether to go on; for work within a case.
    bool goes_on() const;

    NeverExercised never_exercised() const;

  private:
    void note_values(const PartialInputs& inputs, std::uint32_t input);

    const Grafcet& grafcet_;
    const Assumptions& assumptions_;
    const CheckOptions& options_;
    Coverage& coverage_;
    std::unordered_set<std::string> situations_;
    std::size_t input_count_;
    BitTable active_;
    BitTable on_;
    std::vector<std::uint8_t> cleared_;
    std::vector<std::uint8_t> values_seen_;  ///< per input: 1 for 0, 2 for 1, and both
};

}  // namespace grafwire
