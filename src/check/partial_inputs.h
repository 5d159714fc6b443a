#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "grafcet/grafcet.h"
#include "grafcet/plant_conditions.h"
#include "logic/logic.h"
#include "trace/input_values.h"

namespace grafwire {

/// What a case says of an input. `unassigned` is a don't-care: the case stands for both values. It
/// is not `Logic::unknown`, which is what a simulation makes of a value it cannot tell.
enum class PartialInput : std::uint8_t { zero, one, unassigned };

/// The other value; unassigned stays unassigned.
PartialInput opposite(PartialInput value);
inline PartialInput assigned(bool value) {
    return value ? PartialInput::one : PartialInput::zero;
}

/// A value for every input of a GRAFCET (declared inputs, Init, AUdur, AUdoux), some unassigned.
using PartialInputs = std::vector<PartialInput>;

/// What a simulation in three values is given for them.
Logic logic_of(PartialInput value);
std::vector<Logic> logic_of(const PartialInputs& inputs);

/// All assigned.
PartialInputs assigned_inputs(const InputValues& values);

/// None assigned; but Init, AUdur and AUdoux are 0 where a device has no modes.
PartialInputs unassigned_inputs(const Grafcet& grafcet, bool has_modes);

/// The assumptions of a GRAFCET, asked about partial inputs. The GRAFCET must outlive it.
class Assumptions {
  public:
    explicit Assumptions(const Grafcet& grafcet);

    /// Whether the unassigned inputs can be given values so that every assumption holds.
    bool can_hold(const PartialInputs& inputs) const;

    /// Values for all inputs under which every assumption holds; an unassigned input that no
    /// assumption decides takes its `preferred` value. Empty where there are none.
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
    mutable std::vector<PartialInputs> solutions_;
    mutable std::size_t oldest_ = 0;
};

/// The inputs after each change of a single one that is assigned. Where the assumptions let an
/// input change only together with another (of two complementary contacts), the two change.
/// `has_modes`: whether Init, AUdur and AUdoux can change.
std::vector<PartialInputs> single_changes(const Assumptions& assumptions,
                                          const PartialInputs& inputs, bool has_modes);

/// What the inputs were before a single change led to `inputs`, from a state whose inputs were
/// `left`: those unassigned there had the value they have now, unless the assumptions force one of
/// them to change with it. Nothing where they allow no such change.
std::optional<PartialInputs> inputs_before(const Assumptions& assumptions,
                                           const PartialInputs& left, const PartialInputs& inputs);

}  // namespace grafwire
