// Where the bits, tables and integers of a program live.
//
// The tables come first and as whole words, because the formulas of the method work on them word by
// word, with 17 steps or more by double words. All that begins as 0 lies in one stretch, from MB 10
// to program_end(), which the first scan clears. What is taken after that (the bit that tells the
// first scan, bits of timers, auxiliary bits) is no memory of the chart.

#include "plc/step7/stl_memory.h"

#include <fmt/format.h>

#include <set>

#include "grafcet/write_grafcet.h"
#include "plc/shared/program_needs.h"
#include "plc/step7/messages.h"
#include "program/bit_names.h"
#include "program/messages.h"

namespace grafwire {

namespace {

namespace say = messages::plc_step7;

/// The tables with a bit per step that the program uses.
std::vector<BitKind> step_tables(const ScanProgram& program) {
    std::vector<BitKind> kinds = {BitKind::step, BitKind::previous, BitKind::activate,
                                  BitKind::deactivate};
    if (has_forcing(program)) {
        kinds.push_back(BitKind::forced_on);
        kinds.push_back(BitKind::forced_off);
    }
    if (uses(program, BitKind::pulse)) kinds.push_back(BitKind::pulse);
    return kinds;
}

}  // namespace

StlMemory::StlMemory(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                     bool wide_integers, Diagnostics& diagnostics)
    : grafcet_(grafcet), program_(program), language_(options.language) {
    place_interface(options.io, diagnostics);
    place_tables();
    place_integers(wide_integers);
    place_bits();
    program_end_ = end_;
}

void StlMemory::check_size(Diagnostics& diagnostics) const {
    if (end_ <= last_byte + 1) return;
    diagnostics.error(code::unsupported_by_language, {},
                      say::too_much_bit_memory(end_ - 1, last_byte));
}

/// Inputs without an assignment come after those with one, in order.
void StlMemory::place_interface(const s7::IoAssignment* io, Diagnostics& diagnostics) {
    std::set<StlAddress> taken;
    std::vector<std::pair<Bit, std::string>> names;
    for (std::uint32_t i = 0; i < grafcet_.inputs.size(); ++i) {
        names.emplace_back(Bit{BitKind::input, i}, grafcet_.inputs[InputId{i}].name);
    }
    for (std::uint32_t c = 0; c < control_input_count && program_.has_modes; ++c) {
        names.emplace_back(Bit{BitKind::control, c},
                           input_name(grafcet_, grafcet_.inputs.size() + c));
    }
    for (std::uint32_t o = 0; o < grafcet_.outputs.size(); ++o) {
        names.emplace_back(Bit{BitKind::output, o}, grafcet_.outputs[OutputId{o}].name);
    }
    const auto area_of = [](Bit bit) { return bit.kind == BitKind::output ? 'A' : 'E'; };
    for (const auto& [bit, name] : names) {
        const s7::Operand* operand = io == nullptr ? nullptr : io->operand_of(name);
        if (operand == nullptr) continue;
        const s7::Area wanted = area_of(bit) == 'A' ? s7::Area::output : s7::Area::input;
        if (operand->area != wanted || operand->width != s7::Width::bit) {
            diagnostics.error(code::unsupported_by_language, {},
                              wanted == s7::Area::output ? say::output_elsewhere(name)
                                                         : say::input_elsewhere(name));
            continue;
        }
        const StlAddress address{area_of(bit), static_cast<std::uint32_t>(operand->address),
                                 operand->bit};
        bits_.emplace(bit, address);
        taken.insert(address);
    }
    for (const auto& [bit, name] : names) {
        if (bits_.count(bit) != 0) continue;
        StlAddress address{area_of(bit), area_of(bit) == 'A' ? 4U : 0U, 0};
        while (taken.count(address) != 0) {
            address.bit = (address.bit + 1) % 8;
            if (address.bit == 0) ++address.byte;
        }
        bits_.emplace(bit, address);
        taken.insert(address);
    }
}

std::uint32_t StlMemory::take_bytes(std::uint32_t count, std::uint32_t alignment) {
    end_ = (end_ + alignment - 1) / alignment * alignment;
    const std::uint32_t first = end_;
    end_ += count;
    return first;
}

void StlMemory::place_tables() {
    const auto steps = static_cast<std::uint32_t>(grafcet_.steps.size());
    if (steps == 0) return;
    table_bytes_ = steps <= 16 ? 2 : (steps + 31) / 32 * 4;
    for (const BitKind kind : step_tables(program_)) {
        tables_[static_cast<std::size_t>(kind)] = take_bytes(table_bytes_, 2);
    }
}

void StlMemory::place_integers(bool wide) {
    integer_bytes_ = wide ? 4 : 2;
    for (std::uint32_t c = 0; c < grafcet_.counters.size(); ++c) {
        integers_[{false, c}] = take_bytes(integer_bytes_, 2);
    }
    for (std::uint32_t i = 0; i < program_.scratch_integers; ++i) {
        integers_[{true, i}] = take_bytes(integer_bytes_, 2);
    }
}

/// Each kind begins with a byte of its own.
void StlMemory::take_bits(BitKind kind, std::size_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t byte = i % 8 == 0 ? take_bytes(1, 1) : end_ - 1;
        bits_[{kind, i}] = {'M', byte, i % 8};
    }
}

void StlMemory::place_bits() {
    take_bits(BitKind::var, grafcet_.vars.size());
    take_bits(BitKind::transition, grafcet_.transitions.size());
    if (uses(program_, BitKind::may_evolve)) take_bits(BitKind::may_evolve, grafcet_.graphs.size());
    take_bits(BitKind::edge, grafcet_.expressions.edges().size());
    take_bits(BitKind::edge_memory, grafcet_.expressions.edges().size());
    take_bits(BitKind::time_value, grafcet_.expressions.time_conditions().size());
    take_bits(BitKind::scratch, program_.scratch_bits);
}

StlAddress StlMemory::of(Bit bit) const {
    const auto found = bits_.find(bit);
    if (found != bits_.end()) return found->second;
    return {'M', table(bit.kind) + bit.index / 8, bit.index % 8};
}

std::uint32_t StlMemory::of(IntegerCell cell) const {
    return integers_.at(cell);
}

StlAddress StlMemory::new_bit() {
    if (last_new_bit_ && last_new_bit_->bit < 7) {
        ++last_new_bit_->bit;
    } else {
        last_new_bit_ = StlAddress{'M', take_bytes(1, 1), 0};
    }
    return *last_new_bit_;
}

Bit StlMemory::auxiliary_bit(std::uint32_t number) {
    const Bit bit{BitKind::auxiliary, number};
    if (bits_.count(bit) == 0) bits_.emplace(bit, new_bit());
    return bit;
}

std::uint32_t StlMemory::auxiliary_integer() {
    if (!auxiliary_integer_) auxiliary_integer_ = take_bytes(integer_bytes_, 2);
    return *auxiliary_integer_;
}

std::string StlMemory::symbol(Bit bit) const {
    const std::string name = name_in_chart(grafcet_, bit);
    switch (bit.kind) {
        case BitKind::step:
            return "X" + name;
        case BitKind::transition:
            return fmt::format("({})", name);
        case BitKind::edge_memory:
            return say::edge_memory.in(language_, name);
        case BitKind::scratch:
            return say::held_bit.in(language_, name);
        case BitKind::auxiliary:
            return auxiliary_name();
        default:
            break;
    }
    const std::string_view table = table_name(bit.kind);
    return table.empty() ? name : fmt::format("{}[{}]", table, name);
}

std::string StlMemory::auxiliary_name() const {
    return say::auxiliary.in(language_);
}

std::string StlMemory::symbol(IntegerCell cell) const {
    if (cell.is_scratch) return say::held_integer.in(language_, cell.index);
    return grafcet_.counters[CounterId{cell.index}].name;
}

}  // namespace grafwire
