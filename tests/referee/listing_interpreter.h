#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "referee/scanned_program.h"
#include "s7/addresses/io_assignment.h"
#include "s7/listing.h"

namespace grafwire::testing {

/// Executes an instruction list for the S7-200, one instruction after the other, as the README of
/// src/s7 says; apart from the machine there. All memory is 0 at first. The assignment tells where
/// inputs, steps and outputs are.
class ListingInterpreter : public ScannedProgram {
  public:
    ListingInterpreter(const Grafcet& grafcet, const s7::Listing& listing,
                       const s7::IoAssignment& assignment);

    void start() override;
    void scan(Time now, const InputValues& inputs) override;
    std::vector<bool> shown() const override;

  private:
    struct Timer {
        std::int64_t current = 0;  ///< ticks; the count of a counter
        bool bit = false;
        bool runs = false;
        Time elapsed = 0;
    };
    using Stack = std::vector<bool>;  ///< nine levels, the top last

    /// The place of the next instruction; that of the end where the scan is over.
    std::size_t execute(std::size_t at);
    std::size_t control(std::size_t at);
    void logic(std::size_t at);
    void set_or_reset(const s7::Instruction& now);
    void words(const s7::Instruction& now);
    void timer(const s7::Instruction& now);
    void counter(const s7::Instruction& now, std::size_t at);

    std::size_t find(s7::Operation operation, std::int32_t number) const;
    void push(bool value);
    bool pop();
    bool level(std::size_t below) const { return stack_[stack_.size() - below]; }
    bool rises(bool now, std::size_t edge);

    bool bit(const s7::Operand& operand) const;
    void set_bit(const s7::Operand& operand, std::size_t further, bool value);
    std::int64_t number(const s7::Operand& operand, s7::Width width) const;
    void set_number(const s7::Operand& operand, s7::Width width, std::size_t further,
                    std::int64_t value);
    bool compared(const s7::Instruction& now) const;

    const Grafcet& grafcet_;
    const s7::IoAssignment& assignment_;
    std::vector<const s7::Instruction*> code_;
    std::map<s7::Area, std::vector<std::uint8_t>> memory_;
    std::map<std::int32_t, Timer> timers_;
    std::map<std::int32_t, Timer> counters_;
    std::map<std::size_t, bool> edges_;  ///< by the place of the instruction, twice that and one
    bool top_ = false;
    Stack stack_;  ///< the eight levels below the top
    std::vector<std::pair<std::size_t, std::pair<bool, Stack>>> calls_;
    bool is_first_ = true;
    Time last_scan_ = 0;
};

}  // namespace grafwire::testing
