#include "plc/shared/step_ranges.h"

#include <algorithm>

#include "program/bit_names.h"

namespace grafwire {

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
