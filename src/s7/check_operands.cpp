// Whether each operand of an instruction is of the kind that its place needs (instruction_set.h),
// and within what the controller has of that area (cpu.h).

#include <fmt/format.h>

#include "s7/addresses/messages.h"
#include "s7/addresses/operand_text.h"
#include "s7/check_listing.h"
#include "s7/instruction_set.h"

namespace grafwire::s7 {

namespace {

bool is_memory(Area area) {
    return area == Area::input || area == Area::output || area == Area::variable ||
           area == Area::memento || area == Area::special;
}

bool is_writable(Area area) {
    return is_memory(area) && area != Area::special;
}

bool is_word_or_constant(const Operand& operand, Width width) {
    if (operand.area == Area::constant) return true;
    if (operand.area == Area::timer || operand.area == Area::counter) return width == Width::word;
    return is_memory(operand.area) && operand.width == width;
}

bool fits_kind(const Operand& operand, OperandKind kind, Width width) {
    const bool is_bit = operand.width == Width::bit;
    switch (kind) {
        case OperandKind::none:
            return false;
        case OperandKind::bit:
            return is_bit && operand.area != Area::constant;
        case OperandKind::place_bit:
            return is_bit && is_writable(operand.area);
        case OperandKind::reset_bit:
            return is_bit && (is_writable(operand.area) || operand.area == Area::timer ||
                              operand.area == Area::counter);
        case OperandKind::value:
            return is_word_or_constant(operand, width);
        case OperandKind::place:
            return is_writable(operand.area) && operand.width == width;
        case OperandKind::preset:
            return is_word_or_constant(operand, Width::word);
        case OperandKind::timer:
            return operand.area == Area::timer;
        case OperandKind::counter:
            return operand.area == Area::counter;
        case OperandKind::count:
        case OperandKind::subroutine:
        case OperandKind::label:
        case OperandKind::number:
            return operand.area == Area::constant;
    }
    return false;
}

std::string wanted(OperandKind kind, Width width) {
    const std::string_view memory = width == Width::byte   ? "a byte such as VB100"
                                    : width == Width::word ? "a word such as VW100"
                                                           : "a double word such as VD100";
    switch (kind) {
        case OperandKind::none:
            break;
        case OperandKind::bit:
            return "a bit such as E0.4, V20.1 or T37";
        case OperandKind::place_bit:
            return "a bit that can be written, such as A0.0 or V20.1";
        case OperandKind::reset_bit:
            return "a bit that can be written, a timer or a counter";
        case OperandKind::value:
            return fmt::format("{} or a constant", memory);
        case OperandKind::place:
            return fmt::format("{} that can be written", memory);
        case OperandKind::preset:
            return "a constant or a word";
        case OperandKind::timer:
            return "a timer such as T37";
        case OperandKind::counter:
            return "a counter such as Z0";
        case OperandKind::count:
            return "a constant, the number of bits, bytes or words";
        case OperandKind::subroutine:
            return "the number of a subroutine, such as K10";
        case OperandKind::label:
            return "the number of a label, such as K10";
        case OperandKind::number:
            return "a constant";
    }
    return "nothing";
}

/// The least and the greatest constant that an operand of a kind can be.
struct Bounds {
    std::int64_t low;
    std::int64_t high;
    std::string_view what;
};

Bounds bounds_of(OperandKind kind, Width width, const CpuRow& cpu) {
    switch (kind) {
        case OperandKind::count:
            return {1, 255, "a count"};
        case OperandKind::preset:
            return {0, 32767, "a preset"};
        case OperandKind::subroutine:
            return {0, cpu.subroutines - 1, "the number of a subroutine"};
        case OperandKind::label:
            return {0, cpu.labels - 1, "the number of a label"};
        case OperandKind::number:
            return {0, 255, "the number"};
        default:
            break;
    }
    if (width == Width::byte) return {0, 255, "a byte"};
    if (width == Width::word) return {INT16_MIN, UINT16_MAX, "a word"};
    return {INT32_MIN, INT32_MAX, "a double word"};
}

class OperandCheck {
  public:
    OperandCheck(const Instruction& instruction, const CpuRow& cpu, Diagnostics& diagnostics)
        : instruction_(instruction),
          row_(row_of(instruction.operation, instruction.width)),
          cpu_(cpu),
          diagnostics_(diagnostics) {}

    void check() {
        if (row_ == nullptr || instruction_.operands.size() != row_->operand_count()) {
            error(code::bad_operand, "the instruction is not in the set");
            return;
        }
        bool good = true;
        for (std::size_t i = 0; i < instruction_.operands.size(); ++i) {
            if (instruction_.operands[i].area == Area::text) return;  // reported by the reader
            good = check_operand(i) && good;
        }
        if (good) check_reach();
        if (good && row_->operands[0] == OperandKind::timer) check_timer();
    }

  private:
    void error(Code code, std::string message) {
        diagnostics_.error(code, instruction_.where, std::move(message));
    }

    std::string mnemonic() const { return mnemonic_of(instruction_, Mnemonics::simatic); }

    bool check_operand(std::size_t i) {
        const Operand& operand = instruction_.operands[i];
        const std::string text = write_operand(operand, Mnemonics::simatic);
        if (!fits_kind(operand, row_->operands[i], row_->width)) {
            error(code::bad_operand,
                  fmt::format("operand {} of {} is {}, and {} is wanted", i + 1, mnemonic(), text,
                              wanted(row_->operands[i], row_->width)));
            return false;
        }
        if (operand.area == Area::constant) {
            const Bounds bounds = bounds_of(row_->operands[i], row_->width, cpu_);
            if (operand.address >= bounds.low && operand.address <= bounds.high) return true;
            error(code::address_out_of_range,
                  fmt::format("{}: {} is between {} and {} (the {})", text, bounds.what, bounds.low,
                              bounds.high, cpu_.name));
            return false;
        }
        return check_range(operand, 1);
    }

    /// Whether `count` operands in a row lie within their area.
    bool check_range(const Operand& first, std::int64_t count) {
        const std::int64_t size = size_of_area(cpu_, first.area);
        std::int64_t end = first.address + count;
        const bool is_numbered = first.area == Area::timer || first.area == Area::counter;
        if (!is_numbered && first.width == Width::bit) {
            end = first.address + (first.bit + count + 7) / 8;
        } else if (!is_numbered) {
            end = first.address + count * (first.width == Width::byte   ? 1
                                           : first.width == Width::word ? 2
                                                                        : 4);
        }
        if (end <= size) return true;
        const std::string text = write_operand(first, Mnemonics::simatic);
        error(code::address_out_of_range,
              fmt::format("{}{}: the {} has {} {} of this area", text,
                          count == 1 ? "" : fmt::format(" and the {} behind it", count - 1),
                          cpu_.name, size, is_numbered ? "places" : "bytes"));
        return false;
    }

    /// What an instruction with a count covers.
    void check_reach() {
        const auto& operands = instruction_.operands;
        switch (instruction_.operation) {
            case Operation::set:
            case Operation::reset:
                check_range(operands[0], operands[1].address);
                break;
            case Operation::block_move:
                check_range(operands[0], operands[2].address);
                check_range(operands[1], operands[2].address);
                break;
            case Operation::fill:
                check_range(operands[1], operands[2].address);
                break;
            default:
                break;
        }
    }

    void check_timer() {
        const std::int32_t number = instruction_.operands[0].address;
        const bool wants_retentive = instruction_.operation == Operation::retentive_on_delay;
        if (timer_kind(number).retentive == wants_retentive) return;
        error(
            code::bad_operand,
            fmt::format("T{} is a timer for {}: {} takes T{} … T{}{}", number,
                        wants_retentive ? "TON" : "TONR", mnemonic(), wants_retentive ? 0 : 32,
                        wants_retentive ? 31 : 63,
                        cpu_.timers > 64 ? fmt::format(" and T{} … T{}", wants_retentive ? 64 : 96,
                                                       wants_retentive ? 95 : 127)
                                         : ""));
    }

    const Instruction& instruction_;
    const InstructionRow* row_;
    const CpuRow& cpu_;
    Diagnostics& diagnostics_;
};

}  // namespace

void check_operands(const Instruction& instruction, const CpuRow& cpu, Diagnostics& diagnostics) {
    OperandCheck(instruction, cpu, diagnostics).check();
}

}  // namespace grafwire::s7
