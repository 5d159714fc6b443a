// One input at a time, as far as the plant allows it: where a change alone would break an
// assumption, the smallest change that contains it and keeps all assumptions is looked for among
// the pairs of inputs that assumptions mention. Larger ties, of three inputs and more that can only
// change together, are left out; what they leave unexercised is told in the report.

#include "check/change_sets.h"

namespace grafwire {

std::vector<PartialInputs> single_changes(const Assumptions& assumptions,
                                          const PartialInputs& inputs, bool has_modes) {
    const std::size_t count = inputs.size() - (has_modes ? 0 : control_input_count);
    std::vector<PartialInputs> changes;
    std::vector<std::uint32_t> tied;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (inputs[i] == Logic::unknown) continue;
        PartialInputs changed = inputs;
        changed[i] = ~changed[i];
        if (assumptions.can_hold(changed)) {
            changes.push_back(std::move(changed));
        } else {
            tied.push_back(i);
        }
    }
    for (std::size_t i = 0; i < tied.size(); ++i) {
        for (std::size_t j = i + 1; j < tied.size(); ++j) {
            PartialInputs changed = inputs;
            for (const std::uint32_t input : {tied[i], tied[j]}) {
                changed[input] = ~changed[input];
            }
            if (assumptions.can_hold(changed)) changes.push_back(std::move(changed));
        }
    }
    return changes;
}

std::optional<PartialInputs> inputs_before(const Assumptions& assumptions,
                                           const PartialInputs& left, const PartialInputs& inputs) {
    PartialInputs before = left;
    std::vector<std::uint32_t> closed;
    for (std::uint32_t i = 0; i < inputs.size(); ++i) {
        if (left[i] != Logic::unknown || inputs[i] == Logic::unknown) continue;
        before[i] = inputs[i];
        closed.push_back(i);
    }
    if (assumptions.can_hold(before)) return before;
    for (const std::uint32_t input : closed) {
        before[input] = ~before[input];
        if (assumptions.can_hold(before)) return before;
        before[input] = ~before[input];
    }
    return std::nullopt;
}

}  // namespace grafwire
