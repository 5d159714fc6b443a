#include "s7/generate/addresses.h"

#include <cassert>

#include "s7/make_instruction.h"

namespace grafwire::s7 {

Addresses::Addresses(const ScanProgram& program, const TableLayout& layout, bool wide,
                     const ResolvedAssignment& assignment,
                     const std::vector<TimeConditionTimers>& timers, Width width)
    : program_(program),
      layout_(layout),
      places_(place_in_tables(*program.grafcet, layout, wide, assignment.places)),
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
    const Grafcet& grafcet = *program_.grafcet;
    for (std::uint32_t i = 0; i < grafcet.inputs.size(); ++i) place({BitKind::input, i}, inputs_);
    for (std::uint32_t c = 0; c < control_input_count; ++c) {
        if (!reads_control(program_, static_cast<ControlInput>(c))) continue;
        place({BitKind::control, c}, inputs_);
    }
    for (std::uint32_t o = 0; o < grafcet.outputs.size(); ++o) {
        place({BitKind::output, o}, outputs_);
    }
}

void Addresses::place_bits(const std::vector<TimeConditionTimers>& timers) {
    const Grafcet& grafcet = *program_.grafcet;
    for (std::uint32_t e = 0; e < grafcet.expressions.edges().size(); ++e) {
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
    for (std::uint32_t v = 0; v < grafcet.vars.size(); ++v) place({BitKind::var, v}, variables_);
    for (std::uint32_t s = 0; s < program_.scratch_bits; ++s) {
        place({BitKind::scratch, s}, variables_);
    }
}

void Addresses::place_integers(const ResolvedAssignment& assignment) {
    for (std::uint32_t c = 0; c < program_.grafcet->counters.size(); ++c) {
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
    switch (bit.kind) {
        case BitKind::step:
        case BitKind::previous:
        case BitKind::pulse:
        case BitKind::activate:
        case BitKind::deactivate:
        case BitKind::forced_on:
        case BitKind::forced_off:
            return table_bit(layout_.first_byte(bit.kind), places_.steps[bit.index]);
        case BitKind::transition:
            return table_bit(layout_.transitions, places_.transitions[bit.index]);
        case BitKind::may_evolve:
            return table_bit(layout_.graphs, places_.graphs[bit.index]);
        case BitKind::input:
        case BitKind::control:
        case BitKind::output:
        case BitKind::var:
        case BitKind::edge:
        case BitKind::edge_memory:
        case BitKind::time_value:
        case BitKind::scratch:
            break;
    }
    if (bit.kind == BitKind::scratch && bit.index >= program_.scratch_bits) {
        return working_[bit.index - program_.scratch_bits];
    }
    return bits_.at(bit);
}

Operand Addresses::operator[](IntegerCell integer) const {
    return integers_.at(integer);
}

Operand Addresses::working_bit(std::uint32_t number) {
    while (working_.size() <= number) working_.push_back(variables_.bit());
    return working_[number];
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
