// Which instructions of a network to show. A network is a run of logic, then what is done with its
// result, then perhaps further logic. Of that the part is wanted which ends in a certain write:
// back from it over what else is done with the same result, then over the logic.

#include "s7check/listing_excerpt.h"

#include <algorithm>

#include "s7check/method_tables.h"

namespace grafwire {

namespace {

using s7::Instruction;
using s7::Operation;

/// Works on the stack alone.
bool is_logic(const Instruction& instruction) {
    return instruction.operation < Operation::assign ||
           (instruction.operation > Operation::reset && instruction.operation < Operation::move);
}

bool leaves(const Instruction& instruction) {
    return instruction.operation == Operation::jump ||
           instruction.operation == Operation::conditional_return ||
           instruction.operation == Operation::call;
}

/// Marks the logic whose result an instruction uses, and the instruction.
void mark_with_logic(const std::vector<Instruction>& instructions, std::size_t index,
                     std::vector<bool>& marked) {
    marked[index] = true;
    std::size_t at = index;
    while (at > 0 && !is_logic(instructions[at - 1])) --at;
    for (; at > 0 && is_logic(instructions[at - 1]); --at) marked[at - 1] = true;
}

}  // namespace

std::vector<const Instruction*> excerpt(const s7::Network& network,
                                        const std::vector<s7::Operand>& places, std::size_t most) {
    const std::vector<Instruction>& instructions = network.instructions;
    std::vector<bool> marked(instructions.size(), false);
    const auto mark_all = [&](const auto& is_wanted) {
        bool found = false;
        for (std::size_t i = 0; i < instructions.size(); ++i) {
            if (!is_wanted(instructions[i])) continue;
            mark_with_logic(instructions, i, marked);
            found = true;
        }
        return found;
    };
    const bool found =
        mark_all([&](const Instruction& instruction) {
            return std::any_of(places.begin(), places.end(), [&](const s7::Operand& place) {
                return may_write(instruction, place);
            });
        }) ||
        mark_all([](const Instruction& instruction) {
            return leaves(instruction) || instruction.operation == Operation::set;
        });
    std::vector<const Instruction*> shown;
    for (std::size_t i = 0; i < instructions.size() && shown.size() < most; ++i) {
        if (marked[i] || !found) shown.push_back(&instructions[i]);
    }
    return shown;
}

}  // namespace grafwire
