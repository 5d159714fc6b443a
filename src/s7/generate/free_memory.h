#pragma once

#include <cstdint>
#include <set>
#include <utility>

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

}  // namespace grafwire::s7
