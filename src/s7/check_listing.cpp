// Whether a listing is a program: the stack of bits within each network, and the flow of control
// over all of them.

#include "s7/check_listing.h"

#include <algorithm>

#include "s7/instruction_set.h"
#include "s7/listing.h"
#include "s7/messages.h"

namespace grafwire::s7 {

namespace {

namespace say = messages::s7;

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

/// Whether each instruction of a network that works on several levels of the stack finds there what
/// the network itself has loaded.
void check_stack(const Network& network, Diagnostics& diagnostics) {
    std::size_t depth = 0;  // what the network has loaded
    std::size_t lost = 0;   // of that, what has been pushed out at the bottom
    for (const Instruction& instruction : network.instructions) {
        const StackEffect effect = effect_of(instruction.operation);
        const std::string mnemonic = mnemonic_of(instruction, Mnemonics::simatic);
        if (effect.needs > depth) {
            diagnostics.error(code::bad_stack, instruction.where,
                              say::stack_too_low(effect.needs, mnemonic, depth));
            return;
        }
        if (effect.needs != 0 && depth - effect.needs < lost) {
            diagnostics.error(code::bad_stack, instruction.where,
                              say::pushed_out(mnemonic, stack_levels));
            return;
        }
        depth = effect.change < 0 ? depth - 1 : depth + static_cast<std::size_t>(effect.change);
        if (depth > stack_levels) lost = std::max(lost, depth - stack_levels);
    }
}

class FlowCheck {
  public:
    FlowCheck(const Listing& listing, Diagnostics& diagnostics)
        : outline_(outline_of(listing)), diagnostics_(diagnostics) {}

    void check() {
        for (const Outline::Block& block : outline_.blocks) {
            check_end(block);
            check_numbers(block);
            for (std::size_t line = block.first; line < block.end; ++line) {
                check_target(block, outline_.at(line));
            }
        }
        depth_.assign(outline_.blocks.size(), unknown_depth);
        for (std::size_t b = 0; b < outline_.blocks.size(); ++b) {
            if (depth_of(b) > deepest_call && b == 0) {
                error(first_line(b), say::calls_too_deep(depth_[b], deepest_call));
            }
        }
    }

  private:
    static constexpr std::size_t unknown_depth = static_cast<std::size_t>(-1);
    static constexpr std::size_t being_found = static_cast<std::size_t>(-2);

    Diagnostic& error(const Instruction& instruction, Localized message) {
        return diagnostics_.error(code::bad_control_flow, instruction.where, std::move(message));
    }

    const Instruction& first_line(std::size_t block) const {
        return outline_.at(outline_.blocks[block].first);
    }

    static Localized name_of(const Outline::Block& block) {
        if (block.number == Outline::Block::main_program) return say::main_program();
        return say::subroutine(block.number);
    }

    /// MEND ends the main program and RET a subroutine, and nothing stands behind them.
    void check_end(const Outline::Block& block) {
        if (block.first == block.end) return;
        const bool is_main = block.number == Outline::Block::main_program;
        const Operation wanted = is_main ? Operation::main_end : Operation::return_;
        const Operation foreign = is_main ? Operation::return_ : Operation::main_end;
        std::size_t end = block.end;
        for (std::size_t line = block.first; line < block.end; ++line) {
            const Operation operation = outline_.at(line).operation;
            if (operation == foreign || (is_main && operation == Operation::conditional_return) ||
                (!is_main && operation == Operation::end)) {
                error(outline_.at(line),
                      say::foreign_instruction(mnemonic_of(outline_.at(line), Mnemonics::simatic),
                                               name_of(block)));
            }
            if (operation == wanted) end = std::min(end, line);
        }
        if (end == block.end) {
            diagnostics_.warning(code::read_leniently, outline_.at(block.end - 1).where,
                                 say::ends_without(name_of(block), is_main ? "MEND" : "RET"));
        } else if (end + 1 < block.end) {
            error(outline_.at(end + 1), say::unreachable(name_of(block)))
                .notes.push_back({outline_.at(end).where, say::here()});
        }
    }

    /// A label or a subroutine twice.
    void check_numbers(const Outline::Block& block) {
        for (std::size_t line = block.first; line < block.end; ++line) {
            const Instruction& instruction = outline_.at(line);
            if (instruction.operation == Operation::subroutine) {
                const auto& named = outline_.blocks[outline_.subroutines.at(block.number)];
                if (named.first != line) {
                    report_twice(say::subroutine_twice, instruction, outline_.at(named.first));
                }
            } else if (instruction.operation == Operation::label) {
                const auto [place, is_new] =
                    labels_.emplace(instruction.operands[0].address, &instruction);
                if (!is_new) report_twice(say::label_twice, instruction, *place->second);
            }
        }
    }

    void report_twice(const Message<std::int32_t>& message, const Instruction& second,
                      const Instruction& first) {
        error(second, message(second.operands[0].address))
            .notes.push_back({first.where, say::here()});
    }

    void check_target(const Outline::Block& block, const Instruction& instruction) {
        if (instruction.operands.empty()) return;
        const std::int32_t number = instruction.operands[0].address;
        if (instruction.operation == Operation::call && !outline_.subroutines.contains(number)) {
            error(instruction, say::no_subroutine(number));
        }
        if (instruction.operation != Operation::jump || block.labels.contains(number)) return;
        for (const Outline::Block& other : outline_.blocks) {
            const auto found = other.labels.find(number);
            if (found == other.labels.end()) continue;
            error(instruction, say::label_elsewhere(number, name_of(other)))
                .notes.push_back({outline_.at(found->second).where, say::label()});
            return;
        }
        error(instruction, say::no_label(number));
    }

    /// How deep calls from a block go; a subroutine that calls itself is reported, once.
    std::size_t depth_of(std::size_t block) {
        if (depth_[block] != unknown_depth) return depth_[block];
        depth_[block] = being_found;
        std::size_t depth = 0;
        for (std::size_t line = outline_.blocks[block].first; line < outline_.blocks[block].end;
             ++line) {
            const Instruction& instruction = outline_.at(line);
            if (instruction.operation != Operation::call) continue;
            const auto called = outline_.subroutines.find(instruction.operands[0].address);
            if (called == outline_.subroutines.end()) continue;
            if (depth_[called->second] == being_found) {
                error(instruction, say::calls_itself(called->first));
                continue;
            }
            depth = std::max(depth, depth_of(called->second) + 1);
        }
        return depth_[block] = depth;
    }

    Outline outline_;
    Diagnostics& diagnostics_;
    std::map<std::int32_t, const Instruction*> labels_;
    std::vector<std::size_t> depth_;
};

}  // namespace

void check_listing(const Listing& listing, Cpu cpu, Diagnostics& diagnostics) {
    const CpuRow& row = row_of(cpu);
    bool is_empty = true;
    for (const Network& network : listing.networks) {
        for (const Instruction& instruction : network.instructions) {
            check_operands(instruction, row, diagnostics);
            is_empty = false;
        }
        check_stack(network, diagnostics);
    }
    // What else is wrong with a listing that has errors may come of them.
    if (diagnostics.has_errors()) return;
    if (is_empty) {
        diagnostics.error(code::bad_network, {}, say::no_instruction());
        return;
    }
    FlowCheck(listing, diagnostics).check();
    const std::uint32_t size = size_of(listing);
    if (size > row.program_bytes) {
        diagnostics.error(code::program_too_long, {},
                          say::program_too_long(size, row.name, row.program_bytes));
    }
}

}  // namespace grafwire::s7
