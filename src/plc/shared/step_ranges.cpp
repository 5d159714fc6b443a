#include "plc/shared/step_ranges.h"

#include <algorithm>

namespace grafwire {

bool is_step_table(BitKind kind) {
    switch (kind) {
        case BitKind::step:
        case BitKind::previous:
        case BitKind::pulse:
        case BitKind::activate:
        case BitKind::deactivate:
        case BitKind::forced_on:
        case BitKind::forced_off:
            return true;
        default:
            return false;
    }
}

std::vector<StepRange> step_ranges(std::span<const Bit> targets) {
    std::vector<Bit> bits;
    for (const Bit bit : targets) {
        if (is_step_table(bit.kind)) bits.push_back(bit);
    }
    std::sort(bits.begin(), bits.end());
    std::vector<StepRange> ranges;
    for (const Bit bit : bits) {
        if (!ranges.empty() && ranges.back().table == bit.kind &&
            bit.index <= ranges.back().last + 1) {
            ranges.back().last = bit.index;
        } else {
            ranges.push_back({bit.kind, bit.index, bit.index});
        }
    }
    return ranges;
}

std::vector<Bit> single_bits(std::span<const Bit> targets) {
    std::vector<Bit> bits;
    for (const Bit bit : targets) {
        if (!is_step_table(bit.kind)) bits.push_back(bit);
    }
    return bits;
}

}  // namespace grafwire
