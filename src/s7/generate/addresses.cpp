// Where everything in a listing lives.
//
// The method fixes VB0 to VB99 (tables.h), inputs and outputs have their images, and an assignment
// may fix more. The rest takes the lowest free bits, VB6 to VB9 first, which the method leaves
// free, then what lies behind the tables; words come behind everything, at even addresses. An edge
// has its memory and then its bit, as Cordier numbers them.

#include "s7/generate/addresses.h"

#include <algorithm>
#include <cassert>

#include "program/bit_names.h"
#include "s7/make_instruction.h"

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

Addresses::Addresses(const Grafcet& grafcet, const ScanProgram& program, const TableLayout& layout,
                     bool wide, const ResolvedAssignment& assignment,
                     const std::vector<TimeConditionTimers>& timers, Width width)
    : grafcet_(grafcet),
      program_(program),
      layout_(layout),
      places_(place_in_tables(grafcet, layout, wide, assignment.places)),
      width_(width),
      accumulators_{v_word(width, 2)} {
    variables_.keep_clear(10, layout.end());
    place_interface(assignment);
    place_bits(timers);
    place_integers(assignment);
}

void Addresses::place(Bit bit, FreeBits& memory) {
    if (bits_.count(bit) != 0) return;
    bits_.emplace(bit, memory.bit());
}

/// What is assigned first, so that nothing else is put there.
void Addresses::place_interface(const ResolvedAssignment& assignment) {
    const auto take = [&](const Operand& operand) {
        inputs_.take(operand);
        outputs_.take(operand);
        variables_.take(operand);
    };
    for (const auto& [bit, operand] : assignment.bits) take(operand);
    for (const auto& [counter, operand] : assignment.counters) take(operand);
    bits_ = assignment.bits;
    for (std::uint32_t i = 0; i < grafcet_.inputs.size(); ++i) place({BitKind::input, i}, inputs_);
    for (std::uint32_t c = 0; c < control_input_count; ++c) {
        if (!reads_control(program_, static_cast<ControlInput>(c))) continue;
        place({BitKind::control, c}, inputs_);
    }
    for (std::uint32_t o = 0; o < grafcet_.outputs.size(); ++o) {
        place({BitKind::output, o}, outputs_);
    }
}

void Addresses::place_bits(const std::vector<TimeConditionTimers>& timers) {
    for (std::uint32_t e = 0; e < grafcet_.expressions.edges().size(); ++e) {
        place({BitKind::edge_memory, e}, variables_);
        place({BitKind::edge, e}, variables_);
    }
    for (std::uint32_t t = 0; t < timers.size(); ++t) {
        const Bit value{BitKind::time_value, t};
        if (timers[t].timer_is_value()) {
            bits_.emplace(value, timer_operand(static_cast<std::uint32_t>(timers[t].on->number)));
        } else {
            place(value, variables_);
        }
    }
    for (std::uint32_t v = 0; v < grafcet_.vars.size(); ++v) place({BitKind::var, v}, variables_);
    for (std::uint32_t s = 0; s < program_.scratch_bits; ++s) {
        place({BitKind::scratch, s}, variables_);
    }
}

void Addresses::place_integers(const ResolvedAssignment& assignment) {
    for (std::uint32_t c = 0; c < grafcet_.counters.size(); ++c) {
        const auto assigned = assignment.counters.find(c);
        integers_.emplace(IntegerCell{false, c}, assigned != assignment.counters.end()
                                                     ? assigned->second
                                                     : variables_.word(width_));
    }
    for (std::uint32_t i = 0; i < program_.scratch_integers; ++i) {
        integers_.emplace(IntegerCell{true, i}, variables_.word(width_));
    }
}

Operand Addresses::table_bit(std::uint32_t first_byte, std::uint32_t place) const {
    return v_bit(first_byte + place / 8, place % 8);
}

Operand Addresses::operator[](Bit bit) const {
    if (is_step_table(bit.kind)) {
        return table_bit(layout_.first_byte(bit.kind), places_.steps[bit.index]);
    }
    if (bit.kind == BitKind::transition) {
        return table_bit(layout_.transitions, places_.transitions[bit.index]);
    }
    if (bit.kind == BitKind::may_evolve) {
        return table_bit(layout_.graphs, places_.graphs[bit.index]);
    }
    return bits_.at(bit);
}

Operand Addresses::operator[](IntegerCell integer) const {
    return integers_.at(integer);
}

Bit Addresses::working_bit(std::uint32_t number) {
    const Bit bit{BitKind::auxiliary, number};
    place(bit, variables_);
    return bit;
}

Operand Addresses::accumulator(std::size_t number) {
    assert(number < 2);
    if (accumulators_.size() <= number) {
        accumulators_.push_back(width_ == Width::word ? v_word(width_, 4)
                                                      : variables_.word(width_));
    }
    return accumulators_[number];
}

}  // namespace grafwire::s7
