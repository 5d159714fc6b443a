// A listing as what is executed: one row of instructions, and the blocks that they form. The check
// of the flow of control, the machine and the search for a mistake all start from it.

#include "s7/listing.h"

namespace grafwire::s7 {

Outline outline_of(const Listing& listing) {
    Outline outline;
    outline.blocks.emplace_back();
    for (std::uint32_t n = 0; n < listing.networks.size(); ++n) {
        bool begins = true;
        for (const Instruction& instruction : listing.networks[n].instructions) {
            const std::size_t line = outline.lines.size();
            const std::int32_t number =
                instruction.operands.empty() ? 0 : instruction.operands[0].address;
            if (instruction.operation == Operation::subroutine) {
                outline.subroutines.emplace(number, outline.blocks.size());
                outline.blocks.push_back({number, line, line, {}});
            } else if (instruction.operation == Operation::label) {
                outline.blocks.back().labels.emplace(number, line);
            }
            outline.lines.push_back({&instruction, n, begins});
            outline.blocks.back().end = line + 1;
            begins = false;
        }
    }
    return outline;
}

}  // namespace grafwire::s7
