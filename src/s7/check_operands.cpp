// Whether each operand of an instruction is of the kind that its place needs (instruction_set.h),
// and within what the controller has of that area (cpu.h).

#include "s7/addresses/messages.h"
#include "s7/addresses/operand.h"
#include "s7/check_listing.h"
#include "s7/instruction_set.h"
#include "s7/messages.h"

namespace grafwire::s7 {

namespace {

namespace say = messages::s7;

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

/// One of three, by the width of an operand.
Localized of_width(Width width, const Message<>& byte, const Message<>& word,
                   const Message<>& dword) {
    return width == Width::byte ? byte() : width == Width::word ? word() : dword();
}

Localized wanted(OperandKind kind, Width width) {
    switch (kind) {
        case OperandKind::none:
            break;
        case OperandKind::bit:
            return say::any_bit();
        case OperandKind::place_bit:
            return say::writable_bit();
        case OperandKind::reset_bit:
            return say::resettable_bit();
        case OperandKind::value:
            return of_width(width, say::byte_or_constant, say::word_or_constant,
                            say::dword_or_constant);
        case OperandKind::place:
            return of_width(width, say::writable_byte, say::writable_word, say::writable_dword);
        case OperandKind::preset:
            return say::constant_or_word();
        case OperandKind::timer:
            return say::timer();
        case OperandKind::counter:
            return say::counter();
        case OperandKind::count:
            return say::count_constant();
        case OperandKind::subroutine:
            return say::subroutine_number();
        case OperandKind::label:
            return say::label_number();
        case OperandKind::number:
            return say::constant();
    }
    return say::nothing();
}

/// The least and the greatest constant that an operand of a kind can be.
struct Bounds {
    std::int64_t low;
    std::int64_t high;
    Localized what;
};

Bounds bounds_of(OperandKind kind, Width width, const CpuRow& cpu) {
    switch (kind) {
        case OperandKind::count:
            return {1, 255, say::bound_of_count()};
        case OperandKind::preset:
            return {0, 32767, say::bound_of_preset()};
        case OperandKind::subroutine:
            return {0, cpu.subroutines - 1, say::bound_of_subroutine()};
        case OperandKind::label:
            return {0, cpu.labels - 1, say::bound_of_label()};
        case OperandKind::number:
            return {0, 255, say::bound_of_number()};
        default:
            break;
    }
    if (width == Width::byte) return {0, 255, say::bound_of_byte()};
    if (width == Width::word) return {INT16_MIN, UINT16_MAX, say::bound_of_word()};
    return {INT32_MIN, INT32_MAX, say::bound_of_dword()};
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
            error(code::bad_operand, say::not_in_the_set());
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
    void error(Code code, Localized message) {
        diagnostics_.error(code, instruction_.where, std::move(message));
    }

    std::string mnemonic() const { return mnemonic_of(instruction_, Mnemonics::simatic); }

    bool check_operand(std::size_t i) {
        const Operand& operand = instruction_.operands[i];
        const std::string text = write_operand(operand, Mnemonics::simatic);
        if (!fits_kind(operand, row_->operands[i], row_->width)) {
            error(code::bad_operand, say::wrong_operand(i + 1, mnemonic(), text,
                                                        wanted(row_->operands[i], row_->width)));
            return false;
        }
        if (operand.area == Area::constant) {
            const Bounds bounds = bounds_of(row_->operands[i], row_->width, cpu_);
            if (operand.address >= bounds.low && operand.address <= bounds.high) return true;
            error(code::address_out_of_range,
                  say::out_of_bounds(text, bounds.what, bounds.low, bounds.high, cpu_.name));
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
        if (count == 1) {
            const auto& message = is_numbered ? say::beyond_places : say::beyond_bytes;
            error(code::address_out_of_range, message(text, cpu_.name, size));
        } else {
            const auto& message = is_numbered ? say::run_beyond_places : say::run_beyond_bytes;
            error(code::address_out_of_range,
                  message(static_cast<std::size_t>(count - 1), text, cpu_.name, size));
        }
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
        const std::string_view other = wants_retentive ? "TON" : "TONR";
        const int first = wants_retentive ? 0 : 32;  // in each 64
        error(code::bad_operand,
              cpu_.timers > 64 ? say::wrong_timer_of_214(number, other, mnemonic(), first,
                                                         first + 31, first + 64, first + 95)
                               : say::wrong_timer(number, other, mnemonic(), first, first + 31));
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
