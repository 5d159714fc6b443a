#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "program/program.h"
#include "s7/generate/assignment.h"
#include "s7/generate/tables.h"
#include "s7/generate/timers.h"
#include "s7/listing.h"

namespace grafwire::s7 {

/// Hands out bits of one area, from the lowest address on, round what is taken.
class FreeBits {
  public:
    FreeBits(Area area, std::uint32_t first_byte) : area_(area), next_(first_byte * 8) {}

    void take(const Operand& operand);
    /// Nothing from `first` up to, but not including, `end` (bytes) is handed out.
    void keep_clear(std::uint32_t first, std::uint32_t end);
    Operand bit();
    /// A word or double word, at an even address behind everything that keep_clear has named.
    Operand word(Width width);
    /// The first byte that is and remains untouched.
    std::uint32_t end() const { return end_; }

  private:
    bool is_taken(std::uint32_t bit) const;
    void mark(std::uint32_t bit);

    Area area_;
    std::uint32_t next_;             ///< the bit to look at next
    std::uint32_t clear_first_ = 0;  ///< bits
    std::uint32_t clear_end_ = 0;
    std::uint32_t end_ = 0;
    std::set<std::uint32_t> taken_;
};

/// Where every bit and integer of a program lives.
///
/// The tables are those of the layout. Bits around them (memories and edges, values of time
/// conditions, vars, bits within a scan) take V6.0 … V9.7 and then what lies behind the tables,
/// where words stand too (Cordier, section 3.4).
class Addresses {
  public:
    /// `width` is that of all integers: word or dword.
    Addresses(const Grafcet& grafcet, const ScanProgram& program, const TableLayout& layout,
              bool wide, const ResolvedAssignment& assignment,
              const std::vector<TimeConditionTimers>& timers, Width width);

    Operand operator[](Bit bit) const;
    Operand operator[](IntegerCell integer) const;
    /// A bit that holds a part of a condition within one statement, numbered from 0.
    Bit working_bit(std::uint32_t number);
    /// The two places in which sums are worked out: VW2 and VW4; or VD2 and a double word.
    Operand accumulator(std::size_t number);

    Width width() const { return width_; }
    const TableLayout& layout() const { return layout_; }
    /// The number of bytes of V memory in use, counted from VB0.
    std::uint32_t variable_bytes() const { return variables_.end(); }

  private:
    void place_interface(const ResolvedAssignment& assignment);
    void place_bits(const std::vector<TimeConditionTimers>& timers);
    void place_integers(const ResolvedAssignment& assignment);
    void place(Bit bit, FreeBits& memory);
    Operand table_bit(std::uint32_t first_byte, std::uint32_t place) const;

    const Grafcet& grafcet_;
    const ScanProgram& program_;
    TableLayout layout_;
    TablePlaces places_;
    Width width_;
    FreeBits inputs_{Area::input, 0};
    FreeBits outputs_{Area::output, 0};
    FreeBits variables_{Area::variable, 6};
    std::map<Bit, Operand> bits_;  ///< all that are in no table
    std::map<IntegerCell, Operand> integers_;
    std::vector<Operand> accumulators_;
};

}  // namespace grafwire::s7
