#include "s7/offsets.h"

#include "s7/instruction_set.h"

namespace grafwire::s7 {

std::vector<OffsetDeviation> offset_deviations(const Listing& listing) {
    std::vector<OffsetDeviation> deviations;
    std::uint32_t next = 0;
    for (const Network& network : listing.networks) {
        for (const Instruction& instruction : network.instructions) {
            const std::uint32_t printed = instruction.printed_offset;
            if (printed != Instruction::no_offset) {
                if (printed != next) {
                    deviations.push_back({network.number, printed, next, instruction.where});
                }
                next = printed;
            }
            next += size_of(instruction);
        }
    }
    return deviations;
}

void set_offsets(Listing& listing) {
    std::uint32_t next = 0;
    for (Network& network : listing.networks) {
        for (Instruction& instruction : network.instructions) {
            instruction.printed_offset = next;
            next += size_of(instruction);
        }
    }
}

}  // namespace grafwire::s7
