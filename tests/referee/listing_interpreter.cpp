#include "referee/listing_interpreter.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace grafwire::testing {

using s7::Area;
using s7::Compare;
using s7::Instruction;
using s7::IoAssignment;
using s7::Listing;
using s7::Network;
using s7::Operation;
using s7::Width;

namespace {

constexpr std::size_t memory_size = 8192;
constexpr std::size_t levels_below_top = 8;
/// A scan that takes more goes round in a circle.
constexpr std::size_t most_instructions = 100'000;

std::size_t bytes_of_width(Width width) {
    return width == Width::dword ? 4 : width == Width::word ? 2 : 1;
}

/// In each 64 timers 0 and 32 count by 1 ms, the four after them by 10 ms, the others by 100 ms.
Time tick_of(std::int32_t timer) {
    const std::int32_t place = timer % 32;
    return place == 0 ? millisecond : place < 5 ? 10 * millisecond : 100 * millisecond;
}

std::int64_t signed_number(std::uint64_t value, Width width) {
    if (width == Width::dword) return static_cast<std::int32_t>(static_cast<std::uint32_t>(value));
    if (width == Width::word) return static_cast<std::int16_t>(static_cast<std::uint16_t>(value));
    return static_cast<std::uint8_t>(value);
}

}  // namespace

ListingInterpreter::ListingInterpreter(const Grafcet& grafcet, const Listing& listing,
                                       const IoAssignment& assignment)
    : grafcet_(grafcet), assignment_(assignment) {
    for (const Network& network : listing.networks) {
        for (const Instruction& instruction : network.instructions) code_.push_back(&instruction);
    }
}

void ListingInterpreter::start() {
    memory_.clear();
    for (const Area area :
         {Area::input, Area::output, Area::variable, Area::memento, Area::special}) {
        memory_[area].assign(memory_size, 0);
    }
    timers_.clear();
    counters_.clear();
    edges_.clear();
    is_first_ = true;
    last_scan_ = 0;
}

std::vector<bool> ListingInterpreter::shown() const {
    std::vector<bool> values;
    const auto add = [&](const std::string& name) {
        const s7::Operand* operand = assignment_.operand_of(name);
        if (operand == nullptr) FAIL("no address for " << name);
        values.push_back(bit(*operand));
    };
    for (const Step& step : grafcet_.steps) add("X" + step.name);
    for (const Output& output : grafcet_.outputs) add(output.name);
    return values;
}

void ListingInterpreter::scan(Time now, const InputValues& inputs) {
    for (auto& [number, timer] : timers_) {
        if (timer.runs && !is_first_) timer.elapsed += now - last_scan_;
    }
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const s7::Operand* operand = assignment_.operand_of(input_name(grafcet_, i));
        if (operand != nullptr) set_bit(*operand, 0, inputs[i] != 0);
    }
    memory_[Area::special][0] = is_first_ ? 3 : 1;
    top_ = false;
    stack_.assign(levels_below_top, false);
    calls_.clear();
    std::size_t executed = 0;
    for (std::size_t at = 0; at < code_.size(); at = execute(at)) {
        if (++executed > most_instructions) FAIL("a scan that does not end");
    }
    is_first_ = false;
    last_scan_ = now;
}

// The stack.

void ListingInterpreter::push(bool value) {
    stack_.push_back(top_);
    stack_.erase(stack_.begin());
    top_ = value;
}

bool ListingInterpreter::pop() {
    const bool value = top_;
    top_ = stack_.back();
    stack_.pop_back();
    stack_.insert(stack_.begin(), false);
    return value;
}

bool ListingInterpreter::rises(bool now, std::size_t edge) {
    const bool before = edges_[edge];
    edges_[edge] = now;
    return now && !before;
}

// Memory.

bool ListingInterpreter::bit(const s7::Operand& operand) const {
    if (operand.area == Area::timer || operand.area == Area::counter) {
        const auto& all = operand.area == Area::timer ? timers_ : counters_;
        const auto found = all.find(operand.address);
        return found != all.end() && found->second.bit;
    }
    const std::uint8_t byte = memory_.at(operand.area)[static_cast<std::size_t>(operand.address)];
    return (byte >> operand.bit & 1) != 0;
}

void ListingInterpreter::set_bit(const s7::Operand& operand, std::size_t further, bool value) {
    const std::size_t number = operand.bit + further;
    std::uint8_t& byte =
        memory_.at(operand.area)[static_cast<std::size_t>(operand.address) + number / 8];
    const auto mask = static_cast<std::uint8_t>(1U << number % 8);
    byte = static_cast<std::uint8_t>(value ? byte | mask : byte & ~mask);
}

std::int64_t ListingInterpreter::number(const s7::Operand& operand, Width width) const {
    if (operand.area == Area::constant) {
        return signed_number(static_cast<std::uint64_t>(operand.address), width);
    }
    if (operand.area == Area::timer || operand.area == Area::counter) {
        const auto& all = operand.area == Area::timer ? timers_ : counters_;
        const auto found = all.find(operand.address);
        return found == all.end() ? 0 : found->second.current;
    }
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes_of_width(width); ++i) {
        value =
            value * 256 + memory_.at(operand.area)[static_cast<std::size_t>(operand.address) + i];
    }
    return signed_number(value, width);
}

/// The high byte first; `further`: the number of places of this width behind the operand.
void ListingInterpreter::set_number(const s7::Operand& operand, Width width, std::size_t further,
                                    std::int64_t value) {
    const std::size_t size = bytes_of_width(width);
    auto rest = static_cast<std::uint64_t>(value);
    for (std::size_t i = size; i-- > 0; rest /= 256) {
        memory_.at(operand.area)[static_cast<std::size_t>(operand.address) + further * size + i] =
            static_cast<std::uint8_t>(rest % 256);
    }
}

bool ListingInterpreter::compared(const Instruction& now) const {
    const std::int64_t left = number(now.operands[0], now.width);
    const std::int64_t right = number(now.operands[1], now.width);
    switch (now.compare) {
        case Compare::equal:
            return left == right;
        case Compare::not_equal:
            return left != right;
        case Compare::less:
            return left < right;
        case Compare::less_equal:
            return left <= right;
        case Compare::greater:
            return left > right;
        default:
            return left >= right;
    }
}

// Instructions.

std::size_t ListingInterpreter::find(Operation operation, std::int32_t number) const {
    for (std::size_t at = 0; at < code_.size(); ++at) {
        if (code_[at]->operation == operation && code_[at]->operands[0].address == number) {
            return at;
        }
    }
    FAIL("no label or subroutine " << number);
    return code_.size();
}

std::size_t ListingInterpreter::execute(std::size_t at) {
    const Instruction& now = *code_[at];
    switch (now.operation) {
        case Operation::call:
        case Operation::return_:
        case Operation::conditional_return:
        case Operation::jump:
        case Operation::end:
        case Operation::main_end:
            return control(at);
        case Operation::assign:
            set_bit(now.operands[0], 0, top_);
            break;
        case Operation::set:
        case Operation::reset:
            if (top_) set_or_reset(now);
            break;
        case Operation::on_delay:
        case Operation::retentive_on_delay:
            timer(now);
            break;
        case Operation::count_up:
        case Operation::count_up_down:
            counter(now, at);
            break;
        default:
            if (now.operation >= Operation::move && now.operation <= Operation::decrement) {
                if (top_) words(now);
            } else {
                logic(at);
            }
            break;
    }
    return at + 1;
}

std::size_t ListingInterpreter::control(std::size_t at) {
    const Instruction& now = *code_[at];
    const bool always = now.operation == Operation::return_ || now.operation == Operation::main_end;
    if (!always && !top_) return at + 1;
    switch (now.operation) {
        case Operation::call:
            calls_.push_back({at + 1, {top_, stack_}});
            top_ = true;
            stack_.assign(levels_below_top, false);
            return find(Operation::subroutine, now.operands[0].address);
        case Operation::jump:
            return find(Operation::label, now.operands[0].address);
        case Operation::return_:
        case Operation::conditional_return: {
            const auto [back, saved] = calls_.back();
            calls_.pop_back();
            top_ = saved.first;
            stack_ = saved.second;
            return back;
        }
        default:
            return code_.size();
    }
}

void ListingInterpreter::logic(std::size_t at) {
    const Instruction& now = *code_[at];
    switch (now.operation) {
        case Operation::load:
            return push(bit(now.operands[0]));
        case Operation::load_not:
            return push(!bit(now.operands[0]));
        case Operation::load_compare:
            return push(compared(now));
        case Operation::and_:
            top_ = top_ && bit(now.operands[0]);
            return;
        case Operation::and_not:
            top_ = top_ && !bit(now.operands[0]);
            return;
        case Operation::and_compare:
            top_ = top_ && compared(now);
            return;
        case Operation::or_:
            top_ = top_ || bit(now.operands[0]);
            return;
        case Operation::or_not:
            top_ = top_ || !bit(now.operands[0]);
            return;
        case Operation::or_compare:
            top_ = top_ || compared(now);
            return;
        case Operation::and_load: {
            const bool upper = pop();
            top_ = top_ && upper;
            return;
        }
        case Operation::or_load: {
            const bool upper = pop();
            top_ = top_ || upper;
            return;
        }
        case Operation::push:
            return push(top_);
        case Operation::read_push:
            top_ = level(1);
            return;
        case Operation::pop:
            pop();
            return;
        case Operation::negate:
            top_ = !top_;
            return;
        case Operation::rise:
            top_ = rises(top_, 2 * at);
            return;
        case Operation::fall: {
            const bool before = edges_[2 * at];
            edges_[2 * at] = top_;
            top_ = !top_ && before;
            return;
        }
        default:  // SBR, LBL and NOP mark a place.
            return;
    }
}

void ListingInterpreter::set_or_reset(const Instruction& now) {
    const s7::Operand& first = now.operands[0];
    for (std::int32_t i = 0; i < now.operands[1].address; ++i) {
        if (first.area == Area::timer) {
            timers_[first.address + i] = {};
        } else if (first.area == Area::counter) {
            counters_[first.address + i] = {};
        } else {
            set_bit(first, static_cast<std::size_t>(i), now.operation == Operation::set);
        }
    }
}

void ListingInterpreter::words(const Instruction& now) {
    const s7::Operand& first = now.operands[0];
    const s7::Operand& last = now.operands.size() > 1 ? now.operands[1] : first;
    const std::int64_t a = number(first, now.width);
    const std::int64_t b = number(last, now.width);
    switch (now.operation) {
        case Operation::block_move: {
            std::vector<std::int64_t> block;
            for (std::int32_t i = 0; i < now.operands[2].address; ++i) {
                s7::Operand from = first;
                from.address += i * static_cast<std::int32_t>(bytes_of_width(now.width));
                block.push_back(number(from, now.width));
            }
            for (std::size_t i = 0; i < block.size(); ++i) set_number(last, now.width, i, block[i]);
            return;
        }
        case Operation::fill:
            for (std::int32_t i = 0; i < now.operands[2].address; ++i) {
                set_number(last, now.width, static_cast<std::size_t>(i), a);
            }
            return;
        case Operation::move:
            return set_number(last, now.width, 0, a);
        case Operation::invert:
            return set_number(first, now.width, 0, ~a);
        case Operation::and_words:
            return set_number(last, now.width, 0, a & b);
        case Operation::or_words:
            return set_number(last, now.width, 0, a | b);
        case Operation::xor_words:
            return set_number(last, now.width, 0, a ^ b);
        case Operation::add:
            return set_number(last, now.width, 0, b + a);
        case Operation::subtract:
            return set_number(last, now.width, 0, b - a);
        case Operation::increment:
            return set_number(first, now.width, 0, a + 1);
        default:
            return set_number(first, now.width, 0, a - 1);
    }
}

void ListingInterpreter::timer(const Instruction& now) {
    const std::int32_t timer_number = now.operands[0].address;
    Timer& timer = timers_[timer_number];
    if (now.operation == Operation::on_delay) {
        if (!top_) {
            timer = {};
            return;
        }
        if (!timer.runs) timer.elapsed = 0;
    }
    timer.runs = top_;
    timer.current = std::min<Time>(timer.elapsed / tick_of(timer_number), 32767);
    timer.bit = timer.current >= number(now.operands[1], Width::word);
}

/// CTU: the top resets, the level below counts up. CTUD: between them one that counts down.
void ListingInterpreter::counter(const Instruction& now, std::size_t at) {
    const bool counts_down = now.operation == Operation::count_up_down;
    Timer& counter = counters_[now.operands[0].address];
    const bool up = rises(level(counts_down ? 2 : 1), 2 * at);
    const bool down = counts_down && rises(level(1), 2 * at + 1);
    if (up) counter.current = std::min<std::int64_t>(counter.current + 1, 32767);
    if (down) counter.current = std::max<std::int64_t>(counter.current - 1, -32768);
    if (top_) counter.current = 0;
    counter.bit = !top_ && counter.current >= number(now.operands[1], Width::word);
}

}  // namespace grafwire::testing
