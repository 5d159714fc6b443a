#include "s7/generate/free_memory.h"

#include <algorithm>

namespace grafwire::s7 {

namespace {

std::uint32_t bits_of(Width width) {
    switch (width) {
        case Width::bit:
            return 1;
        case Width::byte:
            return 8;
        case Width::word:
            return 16;
        case Width::dword:
            return 32;
    }
    return 1;
}

}  // namespace

void FreeBits::mark(std::uint32_t bit) {
    taken_.insert(bit);
    end_ = std::max(end_, bit / 8 + 1);
}

bool FreeBits::is_taken(std::uint32_t bit) const {
    return (bit >= clear_first_ && bit < clear_end_) || taken_.count(bit) != 0;
}

void FreeBits::take(const Operand& operand) {
    if (operand.area != area_) return;
    const std::uint32_t first = static_cast<std::uint32_t>(operand.address) * 8 + operand.bit;
    for (std::uint32_t i = 0; i < bits_of(operand.width); ++i) mark(first + i);
}

void FreeBits::keep_clear(std::uint32_t first, std::uint32_t end) {
    clear_first_ = first * 8;
    clear_end_ = end * 8;
    end_ = std::max(end_, end);
}

Operand FreeBits::bit() {
    while (is_taken(next_)) ++next_;
    mark(next_);
    return {area_,
            Width::bit,
            static_cast<std::int32_t>(next_ / 8),
            static_cast<std::uint8_t>(next_ % 8),
            {}};
}

Operand FreeBits::word(Width width) {
    const std::uint32_t size = bits_of(width);
    std::uint32_t first = clear_end_;
    const auto any_taken = [&] {
        for (std::uint32_t i = 0; i < size; ++i) {
            if (is_taken(first + i)) return true;
        }
        return false;
    };
    while (any_taken()) first += 16;
    for (std::uint32_t i = 0; i < size; ++i) mark(first + i);
    return {area_, width, static_cast<std::int32_t>(first / 8), 0, {}};
}

}  // namespace grafwire::s7
