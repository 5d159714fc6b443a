#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace grafwire {

/// A table of bits, 64 to the word, after the tables of the method (there 32 bits at a time).
/// Bits beyond the size are 0 at all times.
class BitTable {
  public:
    BitTable() = default;
    explicit BitTable(std::size_t size) : size_(size), words_((size + 63) / 64) {}

    std::size_t size() const { return size_; }
    bool test(std::size_t bit) const { return (words_[bit / 64] >> (bit % 64) & 1U) != 0; }
    void set(std::size_t bit) { words_[bit / 64] |= std::uint64_t{1} << (bit % 64); }
    void reset(std::size_t bit) { words_[bit / 64] &= ~(std::uint64_t{1} << (bit % 64)); }
    void assign(std::size_t bit, bool value) { value ? set(bit) : reset(bit); }
    void clear() { words_.assign(words_.size(), 0); }

    std::vector<std::uint64_t>& words() { return words_; }
    const std::vector<std::uint64_t>& words() const { return words_; }

    bool operator==(const BitTable&) const = default;

  private:
    std::size_t size_ = 0;
    std::vector<std::uint64_t> words_;
};

}  // namespace grafwire
