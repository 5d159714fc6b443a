#pragma once

#include <optional>
#include <vector>

#include "check/partial_inputs.h"

namespace grafwire {

/// The inputs after each single change of one that is known; open ones stay open. Where the
/// assumptions let an input change only together with another (of two complementary contacts), the
/// two change. `has_modes`: whether Init, AUdur and AUdoux can change.
std::vector<PartialInputs> single_changes(const Assumptions& assumptions,
                                          const PartialInputs& inputs, bool has_modes);

/// What the inputs were before a single change led to `inputs`, from a state in which those in
/// `left` were known: all others, open there, had the value they have now, unless the assumptions
/// force one of them to change with it. Nothing where they allow no such change.
std::optional<PartialInputs> inputs_before(const Assumptions& assumptions,
                                           const PartialInputs& left, const PartialInputs& inputs);

}  // namespace grafwire
