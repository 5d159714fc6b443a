#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
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

/// Calls `visit(bit)` for every bit of one word of a table, lowest first; `word_index` is the place
/// of the word in its table.
template <typename Visit>
void for_each_bit_of_word(std::uint64_t word, std::size_t word_index, Visit&& visit) {
    for (; word != 0; word &= word - 1) {
        visit(word_index * 64 + static_cast<std::size_t>(std::countr_zero(word)));
    }
}

/// Calls `visit(bit)` for every bit of `table`, in ascending order.
template <typename Visit>
void for_each_bit(const BitTable& table, Visit&& visit) {
    for (std::size_t w = 0; w < table.words().size(); ++w) {
        for_each_bit_of_word(table.words()[w], w, visit);
    }
}

/// Calls `visit(bit)` for every bit of `a . b`, in ascending order.
template <typename Visit>
void for_each_common_bit(const BitTable& a, const BitTable& b, Visit&& visit) {
    assert(a.size() == b.size());
    for (std::size_t w = 0; w < a.words().size(); ++w) {
        for_each_bit_of_word(a.words()[w] & b.words()[w], w, visit);
    }
}

/// The bits `first` … `first + count - 1` as words and masks: calls `visit(word index, mask)` for
/// each word touched, and stops early where it returns false.
template <typename Visit>
void for_each_word_of_range(std::size_t first, std::size_t count, Visit&& visit) {
    for (const std::size_t last = first + count; first < last;) {
        const std::size_t offset = first % 64;
        const std::size_t taken = std::min<std::size_t>(64 - offset, last - first);
        const std::uint64_t mask =
            (taken == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << taken) - 1) << offset;
        if (!visit(first / 64, mask)) return;
        first += taken;
    }
}

inline bool any_in_range(const BitTable& table, std::size_t first, std::size_t count) {
    bool any = false;
    for_each_word_of_range(first, count, [&](std::size_t word, std::uint64_t mask) {
        any = (table.words()[word] & mask) != 0;
        return !any;
    });
    return any;
}

inline void clear_range(BitTable& table, std::size_t first, std::size_t count) {
    for_each_word_of_range(first, count, [&](std::size_t word, std::uint64_t mask) {
        table.words()[word] &= ~mask;
        return true;
    });
}

/// `table = table + other` within the range only.
inline void add_range(BitTable& table, const BitTable& other, std::size_t first,
                      std::size_t count) {
    for_each_word_of_range(first, count, [&](std::size_t word, std::uint64_t mask) {
        table.words()[word] |= other.words()[word] & mask;
        return true;
    });
}

}  // namespace grafwire
