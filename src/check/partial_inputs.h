#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "grafcet/grafcet.h"
#include "grafcet/plant_conditions.h"
#include "logic/logic.h"
#include "trace/stimuli.h"

namespace grafwire {

/// One value for every input of a GRAFCET (declared inputs, Init, AUdur, AUdoux), some of them left
/// open: `Logic::unknown` stands for "0 or 1, it does not matter which".
using PartialInputs = std::vector<Logic>;

/// All open; but Init, AUdur and AUdoux are 0 where a device has no modes.
PartialInputs open_inputs(const Grafcet& grafcet, bool has_modes);

/// The assumptions of a GRAFCET, asked about inputs that are partly open. The GRAFCET must outlive
/// it.
class Assumptions {
  public:
    explicit Assumptions(const Grafcet& grafcet);

    /// Whether the open inputs can be given values so that every assumption holds.
    bool can_hold(const PartialInputs& inputs) const;

    /// Values for all inputs under which every assumption holds; an open input that no assumption
    /// decides takes its `preferred` value. Empty where there are none.
    std::optional<InputValues> complete(const PartialInputs& inputs,
                                        const InputValues& preferred) const;

    /// The inputs that assumptions read, in order.
    const std::vector<std::uint32_t>& mentioned() const { return mentioned_; }

  private:
    Logic evaluate(ExprId id, const PartialInputs& inputs) const;
    Logic evaluate_all(const PartialInputs& inputs) const;
    bool is_known_to_hold(const PartialInputs& inputs) const;
    bool can_be_completed(const PartialInputs& inputs) const;

    const Grafcet& grafcet_;
    std::vector<std::uint32_t> mentioned_;
    mutable PlantConditions plant_;
    /// The last solutions found, each with a value for every mentioned input: most questions are
    /// answered by one of them.
    mutable std::vector<std::vector<Logic>> solutions_;
    mutable std::size_t oldest_ = 0;
};

}  // namespace grafwire
