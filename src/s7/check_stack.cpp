#include "s7/check_stack.h"

#include <fmt/format.h>

#include <algorithm>

#include "s7/instruction_set.h"

namespace grafwire::s7 {

namespace {

/// What an instruction needs of the stack and does to it.
struct StackEffect {
    std::size_t needs = 0;  ///< levels it reads, where that is more than the top alone
    int change = 0;
};

StackEffect effect_of(Operation operation) {
    switch (operation) {
        case Operation::load:
        case Operation::load_not:
        case Operation::load_compare:
            return {0, 1};
        case Operation::push:
            return {1, 1};
        case Operation::read_push:
            return {2, 0};
        case Operation::and_load:
        case Operation::or_load:
        case Operation::pop:
            return {2, -1};
        case Operation::count_up:
            return {2, 0};
        case Operation::count_up_down:
            return {3, 0};
        default:
            return {};
    }
}

}  // namespace

void check_stack(const Network& network, Diagnostics& diagnostics) {
    std::size_t depth = 0;  // what the network has loaded
    std::size_t lost = 0;   // of that, what has been pushed out at the bottom
    for (const Instruction& instruction : network.instructions) {
        const StackEffect effect = effect_of(instruction.operation);
        const std::string mnemonic = mnemonic_of(instruction, Mnemonics::simatic);
        if (effect.needs > depth) {
            diagnostics.error(
                Code::bad_stack, instruction.where,
                fmt::format("{} works on {} level{} of the stack, and the network has loaded {}",
                            mnemonic, effect.needs, effect.needs == 1 ? "" : "s", depth));
            return;
        }
        if (effect.needs != 0 && depth - effect.needs < lost) {
            diagnostics.error(Code::bad_stack, instruction.where,
                              fmt::format("{} comes too late: the stack has {} levels, and what it "
                                          "needs has been pushed out by later loads",
                                          mnemonic, stack_levels));
            return;
        }
        depth = effect.change < 0 ? depth - 1 : depth + static_cast<std::size_t>(effect.change);
        if (depth > stack_levels) lost = std::max(lost, depth - stack_levels);
    }
}

}  // namespace grafwire::s7
