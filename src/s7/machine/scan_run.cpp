// One scan of an S7-200: the instructions in their order on a stack of bits, from the first of the
// main program to its MEND.
//
// Bits go on in three values as long as they can; where it depends on an open input whether an
// instruction is executed, or with what number, the scan ends and names it. Words go bit by bit
// through logic; a comparison is known where every completion of the unknown bits gives the same;
// arithmetic needs its operands in full.

#include "s7/machine/scan_run.h"

#include <algorithm>
#include <array>
#include <bit>

#include "s7/machine/messages.h"

namespace grafwire::s7 {

namespace {

/// A scan that executes more than this goes round in a circle: the program memory holds 4096 bytes.
constexpr std::size_t most_instructions = 100'000;

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

Machine::ScanEnd ScanRun::run() {
    std::size_t executed = 0;
    std::size_t at = 0;
    while (at != ended && end_.is_done()) {
        const DecodedInstruction& now = program_.code[at];
        if (++executed > most_instructions) {
            end_.error = {now.network_number, now.where,
                          messages::s7_machine::scan_without_end(most_instructions)};
            break;
        }
        memory_.set_network(now.network);
        at = execute(now, at);
    }
    return end_;
}

bool ScanRun::holds(Signal condition) {
    if (!condition.is_known()) need(condition.cause);
    return condition.is_one();
}

std::size_t ScanRun::execute(const DecodedInstruction& now, std::size_t at) {
    switch (now.operation) {
        case Operation::call:
        case Operation::return_:
        case Operation::conditional_return:
        case Operation::jump:
        case Operation::end:
        case Operation::main_end:
            return execute_control(now, at);
        case Operation::assign:
        case Operation::set:
        case Operation::reset:
            execute_writing(now);
            break;
        case Operation::move:
        case Operation::block_move:
        case Operation::fill:
        case Operation::invert:
        case Operation::and_words:
        case Operation::or_words:
        case Operation::xor_words:
        case Operation::add:
        case Operation::subtract:
        case Operation::increment:
        case Operation::decrement:
            if (holds(stack_.top())) execute_words(now);
            break;
        case Operation::on_delay:
        case Operation::retentive_on_delay:
            execute_timer(now);
            break;
        case Operation::count_up:
        case Operation::count_up_down:
            execute_counter(now);
            break;
        default:
            execute_logic(now);
            break;
    }
    return at + 1;
}

std::size_t ScanRun::execute_control(const DecodedInstruction& now, std::size_t at) {
    const bool is_conditional =
        now.operation != Operation::return_ && now.operation != Operation::main_end;
    if (is_conditional && !holds(stack_.top())) return at + 1;
    switch (now.operation) {
        case Operation::call:
            frames_.push_back({at + 1, stack_});
            stack_ = BitStack(true);
            return now.target;
        case Operation::jump:
            return now.target;
        case Operation::return_:
        case Operation::conditional_return: {
            const Frame frame = frames_.back();
            frames_.pop_back();
            stack_ = frame.stack;
            return frame.next;
        }
        default:
            return ended;
    }
}

void ScanRun::execute_logic(const DecodedInstruction& now) {
    const auto operand = [&] { return bit(now.operands[0]); };
    switch (now.operation) {
        case Operation::load:
            stack_.push(operand());
            break;
        case Operation::load_not:
            stack_.push(~operand());
            break;
        case Operation::load_compare:
            stack_.push(compare(now));
            break;
        case Operation::and_:
            stack_.set_top(stack_.top() & operand());
            break;
        case Operation::and_not:
            stack_.set_top(stack_.top() & ~operand());
            break;
        case Operation::and_compare:
            stack_.set_top(stack_.top() & compare(now));
            break;
        case Operation::or_:
            stack_.set_top(stack_.top() | operand());
            break;
        case Operation::or_not:
            stack_.set_top(stack_.top() | ~operand());
            break;
        case Operation::or_compare:
            stack_.set_top(stack_.top() | compare(now));
            break;
        case Operation::and_load:
        case Operation::or_load: {
            const Signal top = stack_.top();
            stack_.pop();
            stack_.set_top(now.operation == Operation::and_load ? stack_.top() & top
                                                                : stack_.top() | top);
            break;
        }
        case Operation::push:
            stack_.push(stack_.top());
            break;
        case Operation::read_push:
            stack_.set_top(stack_.level(1));
            break;
        case Operation::pop:
            stack_.pop();
            break;
        case Operation::negate:
            stack_.set_top(~stack_.top());
            break;
        case Operation::rise:
        case Operation::fall: {
            const bool top = holds(stack_.top());
            const bool before = state_.edges[now.edge] != 0;
            state_.edges[now.edge] = top ? 1 : 0;
            stack_.set_top(
                Signal::of(now.operation == Operation::rise ? top && !before : !top && before));
            break;
        }
        default:  // SBR, LBL and NOP mark a place.
            break;
    }
}

void ScanRun::execute_writing(const DecodedInstruction& now) {
    if (now.operation == Operation::assign) {
        memory_.set_bit(now.operands[0].at, now.operands[0].bit, stack_.top());
    } else if (holds(stack_.top())) {
        set_or_reset(now);
    }
}

void ScanRun::set_or_reset(const DecodedInstruction& now) {
    const Place& place = now.operands[0];
    for (std::size_t i = 0; i < now.count; ++i) {
        if (place.kind == Place::Kind::memory) {
            const std::size_t bit_number = place.bit + i;
            memory_.set_bit(place.at + bit_number / 8, static_cast<std::uint8_t>(bit_number % 8),
                            Signal::of(now.operation == Operation::set));
        } else if (place.kind == Place::Kind::timer) {
            state_.timers[place.at + i] = TimerState();
        } else {
            state_.counters[place.at + i] = TimerState();
        }
    }
}

void ScanRun::execute_timer(const DecodedInstruction& now) {
    const bool enabled = holds(stack_.top());
    const std::int64_t preset = number(now.operands[1], Width::word);
    if (!end_.is_done()) return;
    TimerState& timer = state_.timers[now.operands[0].at];
    const Time tick = program_.timers[now.operands[0].at].tick;
    if (!enabled && now.operation == Operation::on_delay) {
        timer = TimerState();
        return;
    }
    if (enabled && !timer.running && now.operation == Operation::on_delay) timer.elapsed = 0;
    timer.running = enabled;
    timer.current = static_cast<std::int32_t>(std::min<Time>(timer.elapsed / tick, 32767));
    timer.bit = timer.current >= preset;
}

void ScanRun::execute_counter(const DecodedInstruction& now) {
    const bool counts_down = now.operation == Operation::count_up_down;
    const bool resets = holds(stack_.top());
    const bool down = counts_down && holds(stack_.level(1));
    const bool up = holds(stack_.level(counts_down ? 2 : 1));
    const std::int64_t preset = number(now.operands[1], Width::word);
    if (!end_.is_done()) return;
    std::uint8_t& up_before = state_.edges[now.edge];
    std::uint8_t& down_before = state_.edges[now.edge + 1];
    TimerState& counter = state_.counters[now.operands[0].at];
    if (up && up_before == 0 && counter.current < 32767) ++counter.current;
    if (down && down_before == 0 && counter.current > (counts_down ? -32768 : 0)) {
        --counter.current;
    }
    if (resets) counter.current = 0;
    up_before = up ? 1 : 0;
    down_before = down ? 1 : 0;
    counter.bit = !resets && counter.current >= preset;
}

Signal ScanRun::bit(const Place& place) const {
    switch (place.kind) {
        case Place::Kind::memory:
            if (memory_.is_recording()) memory_.note_read(place.at, place.bit, Width::bit);
            return memory_.bit(place.at, place.bit);
        case Place::Kind::timer:
            return Signal::of(state_.timers[place.at].bit);
        case Place::Kind::counter:
            return Signal::of(state_.counters[place.at].bit);
        case Place::Kind::constant:
            break;
    }
    return Signal::of(false);
}

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
