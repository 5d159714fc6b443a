#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace grafwire::testing {

/// Pseudo-random choices that are the same everywhere for the same seed: the engine is fixed by the
/// C++ standard, the distribution is our own.
class RandomSource {
  public:
    explicit RandomSource(std::uint64_t seed) : engine_(seed) {}
    /// Choices that a fuzzer makes: a byte each, so that a small change of the bytes is one of what
    /// is made of them. Where they end, those of a seed follow.
    explicit RandomSource(std::vector<std::uint8_t> choices)
        : engine_(choices.size()), choices_(std::move(choices)) {}

    /// 0 … limit - 1; the limit is positive.
    std::size_t below(std::size_t limit) {
        const std::uint64_t number =
            made_ < choices_.size() ? std::uint64_t{choices_[made_++]} : engine_();
        return static_cast<std::size_t>(number % static_cast<std::uint64_t>(limit));
    }
    /// low … high
    std::size_t between(std::size_t low, std::size_t high) { return low + below(high - low + 1); }
    bool one_in(std::size_t n) { return below(n) == 0; }
    bool flip() { return one_in(2); }

    template <typename Item>
    const Item& pick(const std::vector<Item>& items) {
        return items[below(items.size())];
    }
    /// Up to `count` different items, in random order.
    template <typename Item>
    std::vector<Item> pick_some(std::vector<Item> items, std::size_t count) {
        for (std::size_t i = 0; i < items.size() && i < count; ++i) {
            std::swap(items[i], items[i + below(items.size() - i)]);
        }
        if (items.size() > count) items.resize(count);
        return items;
    }

  private:
    std::mt19937_64 engine_;
    std::vector<std::uint8_t> choices_;
    std::size_t made_ = 0;  ///< so many of these
};

}  // namespace grafwire::testing
