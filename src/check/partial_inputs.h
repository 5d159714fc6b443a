#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "grafcet/grafcet.h"
#include "netlist/cell_types.h"
#include "trace/stimuli.h"

namespace grafwire {

/// One value for every input of a GRAFCET (declared inputs, Init, AUdur, AUdoux), some of them left
/// open: `Logic::unknown` stands for "0 or 1, it does not matter which".
using PartialInputs = std::vector<Logic>;

/// All open; but Init, AUdur and AUdoux are 0 where a device has no modes.
PartialInputs open_inputs(const Grafcet& grafcet, bool has_modes);

/// The assumptions of a GRAFCET, asked about inputs that are partly open.
class Assumptions {
  public:
    explicit Assumptions(const Grafcet& grafcet);

    /// Whether the open inputs can be given values so that every assumption holds.
    bool can_hold(const PartialInputs& inputs) const;

    /// Values for all inputs under which every assumption holds; an open input that no assumption
    /// decides takes its `preferred` value. Empty where there are none.
    std::optional<InputValues> complete(const PartialInputs& inputs,
                                        const InputValues& preferred) const;

  private:
    Logic evaluate(ExprId id, const PartialInputs& inputs) const;
    bool search(PartialInputs& inputs, std::size_t next, const InputValues& preferred) const;
    bool is_broken(const PartialInputs& inputs) const;

    const Grafcet& grafcet_;
    std::vector<std::uint32_t> mentioned_;  ///< the inputs that assumptions read
};

}  // namespace grafwire
