// A listing made ready for execution: every address looked up, every jump and call turned into the
// place it leads to, and a RET at the end of each block that might run out of it.

#include "s7/machine/decoded.h"

#include <algorithm>

#include "s7/instruction_set.h"
#include "s7/listing.h"

namespace grafwire::s7 {

namespace {

constexpr std::int32_t most_ticks = 32767;

bool is_timer_operation(Operation operation) {
    return operation == Operation::on_delay || operation == Operation::retentive_on_delay;
}

/// The numbers of an area that occur anywhere in a listing, ascending.
std::vector<std::int32_t> numbers_used(const Outline& outline, Area area) {
    std::vector<std::int32_t> numbers;
    for (const Outline::Line& line : outline.lines) {
        const auto& operands = line.instruction->operands;
        for (std::size_t i = 0; i < operands.size(); ++i) {
            if (operands[i].area != area) continue;
            const bool is_reset = line.instruction->operation == Operation::reset;
            const std::int32_t count = is_reset ? operands[1].address : 1;
            for (std::int32_t k = 0; k < count; ++k) numbers.push_back(operands[i].address + k);
        }
    }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

std::vector<UsedTimer> timers_used(const Outline& outline) {
    std::vector<UsedTimer> timers;
    for (const std::int32_t number : numbers_used(outline, Area::timer)) {
        UsedTimer timer{number, timer_kind(number).tick, 0, 0};
        bool value_counts = false;
        for (const Outline::Line& line : outline.lines) {
            const Instruction& instruction = *line.instruction;
            const auto& operands = instruction.operands;
            for (std::size_t i = 0; i < operands.size(); ++i) {
                if (operands[i].area != Area::timer || operands[i].address != number) continue;
                if (!is_timer_operation(instruction.operation)) {
                    value_counts = value_counts || instruction.width != Width::bit;
                } else if (i == 1 || operands[1].area != Area::constant) {
                    value_counts = true;
                } else {
                    timer.preset = std::max(timer.preset, operands[1].address);
                }
            }
        }
        timer.most = (value_counts ? most_ticks : timer.preset) * timer.tick;
        if (value_counts) timer.preset = -1;
        timers.push_back(timer);
    }
    return timers;
}

}  // namespace

Layout::Layout(const CpuRow& cpu) {
    for (std::size_t area = 0; area < begin.size(); ++area) {
        begin[area] = bytes;
        bytes += static_cast<std::size_t>(size_of_area(cpu, static_cast<Area>(area)));
    }
}

Decoded::Decoded(const Listing& listing, Cpu cpu) : layout(row_of(cpu)) {
    const Outline outline = outline_of(listing);
    timers = timers_used(outline);
    counters = numbers_used(outline, Area::counter);
    // One more instruction at the end of each block: its return, should it have none.
    const auto moved = [&](std::size_t block, std::size_t line) { return line + block; };
    for (std::size_t b = 0; b < outline.blocks.size(); ++b) {
        const Outline::Block& block = outline.blocks[b];
        blocks.push_back({code.size(), code.size() + (block.end - block.first) + 1});
        for (std::size_t line = block.first; line < block.end; ++line) {
            const Instruction& instruction = outline.at(line);
            DecodedInstruction decoded;
            decoded.operation = instruction.operation;
            decoded.width = instruction.width;
            decoded.compare = instruction.compare;
            decoded.network = outline.lines[line].network;
            decoded.network_number = listing.networks[decoded.network].number;
            decoded.where = instruction.where;
            const auto& operands = instruction.operands;
            for (std::size_t i = 0; i < operands.size() && i < 2; ++i) {
                decoded.operands[i] = place_of(operands[i]);
            }
            const InstructionRow* row = row_of(instruction.operation, instruction.width);
            for (std::size_t i = 0; i < operands.size(); ++i) {
                if (row->operands[i] == OperandKind::count) {
                    decoded.count = static_cast<std::uint32_t>(operands[i].address);
                }
            }
            switch (instruction.operation) {
                case Operation::call: {
                    const std::size_t called = outline.subroutines.at(operands[0].address);
                    decoded.target = moved(called, outline.blocks[called].first);
                    break;
                }
                case Operation::jump:
                    decoded.target = moved(b, block.labels.at(operands[0].address));
                    break;
                case Operation::rise:
                case Operation::fall:
                    decoded.edge = edges++;
                    break;
                case Operation::count_up:
                case Operation::count_up_down:
                    decoded.edge = edges;
                    edges += 2;
                    break;
                default:
                    break;
            }
            code.push_back(decoded);
        }
        DecodedInstruction last;
        if (!code.empty()) {
            last.network = code.back().network;
            last.network_number = code.back().network_number;
        }
        last.operation = b == 0 ? Operation::main_end : Operation::return_;
        code.push_back(last);
    }
}

Place Decoded::place_of(const Operand& operand) const {
    Place place;
    place.bit = operand.bit;
    switch (operand.area) {
        case Area::timer: {
            const auto found = std::find_if(
                timers.begin(), timers.end(),
                [&](const UsedTimer& timer) { return timer.number == operand.address; });
            place.kind = Place::Kind::timer;
            place.at = static_cast<std::size_t>(found - timers.begin());
            break;
        }
        case Area::counter:
            place.kind = Place::Kind::counter;
            place.at = static_cast<std::size_t>(
                std::find(counters.begin(), counters.end(), operand.address) - counters.begin());
            break;
        case Area::constant:
        case Area::symbol:
        case Area::text:
            place.value = static_cast<std::uint32_t>(operand.address);
            break;
        default:
            place.kind = Place::Kind::memory;
            place.at = layout.byte_of(operand.area, operand.address);
            break;
    }
    return place;
}

}  // namespace grafwire::s7
