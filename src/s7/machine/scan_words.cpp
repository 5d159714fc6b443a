// What a scan does with bytes, words and double words. Logic goes bit by bit, known or not;
// comparisons are known where every completion of the unknown bits gives the same; arithmetic needs
// its operands in full.

#include <algorithm>
#include <array>
#include <bit>

#include "s7/machine/scan_run.h"

namespace grafwire::s7 {

namespace {

constexpr std::size_t bits_of(Width width) {
    return 8 * bytes_of(width);
}

constexpr std::uint32_t mask_of(Width width) {
    return width == Width::dword ? 0xffffffffU : (1U << bits_of(width)) - 1;
}

/// The least and the greatest number a word can be, in an order in which signed numbers compare as
/// unsigned ones do.
struct Range {
    std::uint32_t low;
    std::uint32_t high;
};

Range range_of(LogicWord word, Width width) {
    const std::uint32_t mask = mask_of(width);
    const std::uint32_t sign = width == Width::byte ? 0 : 1U << (bits_of(width) - 1);
    const std::uint32_t known = word.known & mask;
    const std::uint32_t value = (word.value ^ sign) & known;
    return {value, value | (mask & ~known)};
}

}  // namespace

std::int64_t as_number(std::uint32_t value, Width width) {
    switch (width) {
        case Width::word:
            return static_cast<std::int16_t>(value);
        case Width::dword:
            return static_cast<std::int32_t>(value);
        default:
            return value & 0xff;
    }
}

Signal compare_words(LogicWord a, LogicWord b, Width width, Compare relation) {
    constexpr Signal unknown{Logic::unknown, 0};
    const Range left = range_of(a, width);
    const Range right = range_of(b, width);
    switch (relation) {
        case Compare::equal: {
            if (((a.value ^ b.value) & a.known & b.known & mask_of(width)) != 0) {
                return Signal::of(false);
            }
            const bool is_known = left.low == left.high && right.low == right.high;
            return is_known ? Signal::of(true) : unknown;
        }
        case Compare::not_equal:
            return ~compare_words(a, b, width, Compare::equal);
        case Compare::less:
            return ~compare_words(a, b, width, Compare::greater_equal);
        case Compare::less_equal:
            return compare_words(b, a, width, Compare::greater_equal);
        case Compare::greater:
            return ~compare_words(b, a, width, Compare::greater_equal);
        case Compare::greater_equal:
            if (left.low >= right.high) return Signal::of(true);
            if (left.high < right.low) return Signal::of(false);
            return unknown;
    }
    return unknown;
}

LogicWord ScanRun::word(const Place& place, Width width) const {
    switch (place.kind) {
        case Place::Kind::memory:
            return memory_.word(place.at, width);
        case Place::Kind::constant:
            return {place.value};
        case Place::Kind::timer:
            return {static_cast<std::uint32_t>(state_.timers[place.at].current)};
        case Place::Kind::counter:
            return {static_cast<std::uint32_t>(state_.counters[place.at].current)};
    }
    return {};
}

std::uint16_t ScanRun::cause_in(const Place& place, Width width) const {
    const LogicWord value = word(place, width);
    const auto first = static_cast<std::uint32_t>(std::countr_one(value.known));
    return memory_.cause(place.at, width, first);
}

std::int64_t ScanRun::number(const Place& place, Width width) {
    const LogicWord value = word(place, width);
    if (~value.known != 0) need(cause_in(place, width));
    return as_number(value.value, width);
}

Signal ScanRun::compare(const DecodedInstruction& now) const {
    for (const Place& place : now.operands) {
        if (memory_.is_recording() && place.kind == Place::Kind::memory) {
            memory_.note_read(place.at, 0, now.width);
        }
    }
    const LogicWord left = word(now.operands[0], now.width);
    const LogicWord right = word(now.operands[1], now.width);
    Signal result = compare_words(left, right, now.width, now.compare);
    if (!result.is_known()) {
        result.cause = cause_in(now.operands[~left.known != 0 ? 0 : 1], now.width);
    }
    return result;
}

void ScanRun::execute_words(const DecodedInstruction& now) {
    switch (now.operation) {
        case Operation::block_move:
        case Operation::fill:
            copy_block(now);
            break;
        case Operation::add:
        case Operation::subtract:
        case Operation::increment:
        case Operation::decrement:
            calculate(now);
            break;
        default:
            combine(now);
            break;
    }
}

void ScanRun::copy_block(const DecodedInstruction& now) {
    const std::size_t to = now.operands[1].at;
    const std::size_t size = bytes_of(now.width);
    if (now.operation == Operation::block_move) {
        memory_.copy(now.operands[0].at, to, now.count * size);
        return;
    }
    if (now.operands[0].kind == Place::Kind::memory) {
        for (std::size_t i = 0; i < now.count; ++i) {
            memory_.copy(now.operands[0].at, to + i * size, size);
        }
        return;
    }
    const LogicWord value = word(now.operands[0], now.width);
    for (std::size_t i = 0; i < now.count; ++i) {
        memory_.set_word(to + i * size, now.width, value, nullptr);
    }
}

/// MOV, INV and the three of logic: each bit of the result depends on the bits in its place.
void ScanRun::combine(const DecodedInstruction& now) {
    const Place& from = now.operands[0];
    const Place& to = now.operands[now.operation == Operation::invert ? 0 : 1];
    const LogicWord a = word(from, now.width);
    const LogicWord b = word(to, now.width);
    LogicWord result = a;
    if (now.operation == Operation::invert) result = ~a;
    if (now.operation == Operation::and_words) result = a & b;
    if (now.operation == Operation::or_words) result = a | b;
    if (now.operation == Operation::xor_words) result = a ^ b;
    if (~result.known == 0) {
        memory_.set_word(to.at, now.width, result, nullptr);
        return;
    }
    std::array<std::uint16_t, 32> causes{};
    for (std::uint32_t bit = 0; bit < bits_of(now.width); ++bit) {
        if ((result.known >> bit & 1U) != 0) continue;
        const Place& source = (a.known >> bit & 1U) == 0 ? from : to;
        causes[bit] = memory_.cause(source.at, now.width, bit);
    }
    memory_.set_word(to.at, now.width, result, causes.data());
}

/// +, -, INC and DEC, round at the end of the width as the controller does.
void ScanRun::calculate(const DecodedInstruction& now) {
    const bool has_one_operand =
        now.operation == Operation::increment || now.operation == Operation::decrement;
    const Place& to = now.operands[has_one_operand ? 0 : 1];
    const std::int64_t change = has_one_operand ? 1 : number(now.operands[0], now.width);
    const std::int64_t value = number(to, now.width);
    if (!end_.is_done()) return;
    const bool is_less =
        now.operation == Operation::subtract || now.operation == Operation::decrement;
    const std::int64_t result = is_less ? value - change : value + change;
    memory_.set_word(to.at, now.width, {static_cast<std::uint32_t>(result)}, nullptr);
}

}  // namespace grafwire::s7
