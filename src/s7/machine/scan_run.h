#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "s7/check_listing.h"
#include "s7/machine/decoded.h"
#include "s7/machine/machine.h"
#include "s7/machine/machine_memory.h"

namespace grafwire::s7 {

/// The stack of nine bits, the top at 0.
class BitStack {
  public:
    /// All levels 0 except the top.
    explicit BitStack(bool top = false) { levels_[0] = Signal::of(top); }

    Signal top() const { return levels_[0]; }
    Signal level(std::size_t i) const { return levels_[i]; }
    void set_top(Signal value) { levels_[0] = value; }

    /// A new top; the lowest level is lost.
    void push(Signal value) {
        for (std::size_t i = levels_.size() - 1; i > 0; --i) levels_[i] = levels_[i - 1];
        levels_[0] = value;
    }
    /// The lowest level becomes 0.
    void pop() {
        for (std::size_t i = 0; i + 1 < levels_.size(); ++i) levels_[i] = levels_[i + 1];
        levels_.back() = Signal::of(false);
    }

  private:
    std::array<Signal, stack_levels> levels_{};
};

/// One scan under way: the instructions, one after the other, until MEND.
class ScanRun {
  public:
    ScanRun(const Decoded& program, MachineMemory& memory, MachineState& state)
        : program_(program), memory_(memory), state_(state) {}

    Machine::ScanEnd run();

  private:
    /// What CALL leaves behind.
    struct Frame {
        std::size_t next = 0;
        BitStack stack;
    };
    /// What became of an instruction: the number of the next, or the end.
    static constexpr std::size_t ended = static_cast<std::size_t>(-1);

    std::size_t execute(const DecodedInstruction& now, std::size_t at);
    std::size_t execute_control(const DecodedInstruction& now, std::size_t at);
    void execute_logic(const DecodedInstruction& now);
    void execute_writing(const DecodedInstruction& now);
    void execute_words(const DecodedInstruction& now);
    void execute_timer(const DecodedInstruction& now);
    void execute_counter(const DecodedInstruction& now);

    Signal bit(const Place& place) const;
    LogicWord word(const Place& place, Width width) const;
    Signal compare(const DecodedInstruction& now) const;
    void set_or_reset(const DecodedInstruction& now);
    void copy_block(const DecodedInstruction& now);
    void combine(const DecodedInstruction& now);
    void calculate(const DecodedInstruction& now);
    /// An input a place depends on some bit of which is not known.
    std::uint16_t cause_in(const Place& place, Width width) const;

    /// Whether an instruction that depends on a bit is executed; where that is not known, the scan
    /// ends.
    bool holds(Signal condition);
    void need(std::uint16_t input) {
        if (!end_.needs) end_.needs = input;
    }
    /// A word that must be known in full, as a signed number of its width; else the scan ends.
    std::int64_t number(const Place& place, Width width);

    const Decoded& program_;
    MachineMemory& memory_;
    MachineState& state_;
    BitStack stack_;
    std::vector<Frame> frames_;
    Machine::ScanEnd end_;
};

/// A word of a width as a signed number (a byte: unsigned).
std::int64_t as_number(std::uint32_t value, Width width);

/// `a relation b` where some bits may not be known: known if every completion gives the same.
Signal compare_words(LogicWord a, LogicWord b, Width width, Compare relation);

}  // namespace grafwire::s7
