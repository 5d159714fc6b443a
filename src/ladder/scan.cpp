// One scan of a ladder diagram: the networks from top to bottom, in each the power that flows
// through contacts and comparisons, then the blocks it passes, then the coils it reaches (IEC
// 61131-3:2013, 8.2).
//
// Bits go on in three values as long as they can. What keeps time, counts or calculates has to know
// whether it runs: where the power before it is unknown, the scan ends there and names an input on
// which the power depends. An edge is a bit like others, of the operand and what it was last time.

#include "ladder/scan.h"

#include <algorithm>

#include "grafcet/expression.h"

namespace grafwire::ladder {

namespace {

/// Two's complement, without undefined behaviour.
std::int64_t wrapped(std::uint64_t value) {
    return static_cast<std::int64_t>(value);
}

}  // namespace

Machine::Outcome Scan::run() {
    outcome_.writers.assign(ladder_.variables.size(), Machine::nobody);
    for (rung_ = 0; rung_ < ladder_.rungs.size() && !outcome_.needs; ++rung_) {
        const Rung& rung = ladder_.rungs[rung_];
        next_edge_ = machine_.first_edge_[rung_];
        Signal power = flow(rung.power);
        for (const Block& block : rung.blocks) power = execute(block, power);
        outcome_.powers.push_back(power.value);
        for (const Coil& coil : rung.coils) execute(coil, power);
    }
    return std::move(outcome_);
}

bool Scan::decided(Signal signal) {
    if (!signal.is_known() && !outcome_.needs) outcome_.needs = signal.cause;
    return signal.is_one();
}

void Scan::write(VariableId id, Signal value) {
    cell(id).bit = value;
    outcome_.writers[static_cast<std::size_t>(id)] = rung_;
}

Signal Scan::bit(const Operand& operand) {
    return operand.kind == Operand::Kind::variable ? cell(operand.variable).bit
                                                   : Signal::of(operand.value != 0);
}

std::int64_t Scan::number(const Operand& operand) {
    return operand.kind == Operand::Kind::variable ? cell(operand.variable).number : operand.value;
}

Signal Scan::edge(Signal operand, bool rising) {
    Signal& last = state_.edges[next_edge_++];
    const Signal edge = rising ? operand & ~last : ~operand & last;
    last = operand;
    return edge;
}

Signal Scan::contact(const Power& power) {
    const Signal value = cell(power.variable).bit;
    switch (power.contact) {
        case ContactKind::normal:
            return value;
        case ContactKind::negated:
            return ~value;
        case ContactKind::rising:
            return edge(value, true);
        case ContactKind::falling:
            return edge(value, false);
    }
    return Signal::of(false);
}

bool Scan::compare(const Power& power) {
    return holds(number(power.left), power.relation, number(power.right));
}

Signal Scan::flow(const Power& power) {
    Signal result = Signal::of(true);
    switch (power.kind) {
        case Power::Kind::wire:
            return Signal::of(true);
        case Power::Kind::contact:
            return contact(power);
        case Power::Kind::comparison:
            return Signal::of(compare(power));
        case Power::Kind::series:
            for (const Power& part : power.parts) result = result & flow(part);
            return result;
        case Power::Kind::parallel:
            result = Signal::of(false);
            for (const Power& part : power.parts) result = result | flow(part);
            return result;
    }
    return result;
}

void Scan::execute(const Coil& coil, Signal power) {
    const Signal before = cell(coil.variable).bit;
    switch (coil.kind) {
        case CoilKind::normal:
            write(coil.variable, power);
            return;
        case CoilKind::negated:
            write(coil.variable, ~power);
            return;
        case CoilKind::set:
            if (power.value != Logic::zero) write(coil.variable, before | power);
            return;
        case CoilKind::reset:
            if (power.value != Logic::zero) write(coil.variable, before & ~power);
            return;
        case CoilKind::rising:
            write(coil.variable, edge(power, true));
            return;
        case CoilKind::falling:
            write(coil.variable, edge(power, false));
            return;
    }
}

Signal Scan::execute(const Block& block, Signal power) {
    if (row_of(block.type).is_function) return execute_function(block, power);
    MachineState::Cell& instance = cell(block.target);
    const Signal last = instance.last;
    instance.last = power;
    switch (block.type) {
        case BlockType::rise:
            write(block.target, power & ~last);
            break;
        case BlockType::fall:
            write(block.target, ~power & last);
            break;
        case BlockType::set_dominant:
            write(block.target, power | (instance.bit & ~bit(block.operands[0])));
            break;
        case BlockType::reset_dominant:
            write(block.target, (power | instance.bit) & ~bit(block.operands[0]));
            break;
        case BlockType::on_delay:
            if (!decided(power)) {
                instance.runs = false;
                write(block.target, Signal::of(false));
                break;
            }
            if (!instance.runs) instance.since = now_;
            instance.runs = true;
            write(block.target, Signal::of(now_ - instance.since >= block.operands[0].value));
            break;
        case BlockType::off_delay: {
            if (decided(power) || instance.bit.value != Logic::one) {
                instance.runs = false;
                write(block.target, power);
                break;
            }
            if (!instance.runs) instance.since = now_;
            instance.runs = now_ - instance.since < block.operands[0].value;
            write(block.target, Signal::of(instance.runs));
            break;
        }
        default:
            execute_counter(block, decided(power & ~last));
            break;
    }
    return instance.bit;
}

void Scan::execute_counter(const Block& block, bool counts) {
    MachineState::Cell& instance = cell(block.target);
    const bool loads = decided(bit(block.operands[0]));
    const std::int64_t preset = number(block.operands[1]);
    const bool up = block.type == BlockType::count_up;
    if (loads) {
        instance.number = up ? 0 : preset;
    } else if (counts) {
        instance.number += up ? 1 : -1;
    }
    write(block.target, Signal::of(up ? instance.number >= preset : instance.number <= 0));
}

Signal Scan::execute_function(const Block& block, Signal power) {
    if (!decided(power)) return power;
    std::vector<std::int64_t> in;
    for (const Operand& operand : block.operands) in.push_back(number(operand));
    const auto bits = [&](std::size_t i) { return static_cast<std::uint64_t>(in[i]); };
    std::int64_t result = in[0];
    switch (block.type) {
        case BlockType::add:
            result = wrapped(bits(0) + bits(1));
            break;
        case BlockType::subtract:
            result = wrapped(bits(0) - bits(1));
            break;
        case BlockType::multiply:
            result = wrapped(bits(0) * bits(1));
            break;
        case BlockType::limit:
            result = std::max(in[0], std::min(in[1], in[2]));
            break;
        default:
            break;
    }
    cell(block.target).number = result;
    outcome_.writers[static_cast<std::size_t>(block.target)] = rung_;
    return power;
}

}  // namespace grafwire::ladder
