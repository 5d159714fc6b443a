// What a ladder diagram remembers between two scans, and how little of it counts: a variable that
// is always written before it is read in a scan carries nothing over, so states that differ in such
// variables alone are one (the liveness of compilers, for programs without jumps).

#include "ladder/machine.h"

#include <algorithm>

#include "ladder/scan.h"
#include "text/packed_bytes.h"

namespace grafwire::ladder {

namespace {

std::size_t edges_in(const Power& power) {
    std::size_t count =
        power.kind == Power::Kind::contact &&
                (power.contact == ContactKind::rising || power.contact == ContactKind::falling)
            ? 1
            : 0;
    for (const Power& part : power.parts) count += edges_in(part);
    return count;
}

std::size_t edges_in(const Rung& rung) {
    std::size_t count = edges_in(rung.power);
    for (const Coil& coil : rung.coils) {
        if (coil.kind == CoilKind::rising || coil.kind == CoilKind::falling) ++count;
    }
    return count;
}

std::size_t index_of(VariableId id) {
    return static_cast<std::size_t>(id);
}

}  // namespace

Machine::Machine(const Ladder& ladder) : ladder_(ladder) {
    longest_.resize(ladder.variables.size());
    for (const Rung& rung : ladder.rungs) {
        first_edge_.push_back(edge_count_);
        edge_count_ += edges_in(rung);
        for (const Block& block : rung.blocks) {
            if (block.type != BlockType::on_delay && block.type != BlockType::off_delay) continue;
            Time& longest = longest_[index_of(block.target)];
            longest = std::max(longest, block.operands.front().value);
        }
    }
    find_memory();
}

/// A variable is remembered where a scan may read it before an ordinary coil or a function has
/// written it. Set and reset coils leave it as it was, which is reading it.
void Machine::find_memory() {
    remembered_.assign(ladder_.variables.size(), false);
    std::vector<bool> written(ladder_.variables.size(), false);
    const auto read = [&](VariableId id) {
        if (!written[index_of(id)]) remembered_[index_of(id)] = true;
    };
    const auto read_operand = [&](const Operand& operand) {
        if (operand.kind == Operand::Kind::variable) read(operand.variable);
    };
    const auto read_power = [&](const Power& power, const auto& self) -> void {
        if (power.kind == Power::Kind::contact) read(power.variable);
        if (power.kind == Power::Kind::comparison) {
            read_operand(power.left);
            read_operand(power.right);
        }
        for (const Power& part : power.parts) self(part, self);
    };
    for (const Rung& rung : ladder_.rungs) {
        read_power(rung.power, read_power);
        for (const Block& block : rung.blocks) {
            for (const Operand& operand : block.operands) read_operand(operand);
            const bool always =
                row_of(block.type).is_function && rung.power.kind == Power::Kind::wire;
            if (always) {
                written[index_of(block.target)] = true;
            } else {
                read(block.target);
            }
        }
        for (const Coil& coil : rung.coils) {
            if (coil.kind == CoilKind::set || coil.kind == CoilKind::reset) read(coil.variable);
            written[index_of(coil.variable)] = true;
        }
    }
    for (std::size_t v = 0; v < remembered_.size(); ++v) {
        if (ladder_.variables[v].role == Role::input) remembered_[v] = false;
    }
}

MachineState Machine::start() const {
    MachineState state;
    state.edges.resize(edge_count_);
    for (const Variable& variable : ladder_.variables) {
        MachineState::Cell cell;
        if (variable.type == Type::bit && variable.initial != 0) cell.bit.value = Logic::one;
        if (variable.type == Type::integer) cell.number = variable.initial;
        state.cells.push_back(cell);
    }
    return state;
}

void Machine::set(MachineState& state, VariableId variable, Logic value) const {
    state.cells[index_of(variable)].bit = {value, variable};
}

Machine::Outcome Machine::scan(MachineState& state, Time now) const {
    Scan scan(*this, state, now);
    return scan.run();
}

std::optional<VariableId> Machine::open_memory(const MachineState& state) const {
    for (std::size_t v = 0; v < state.cells.size(); ++v) {
        if (!remembered_[v]) continue;
        for (const Signal& signal : {state.cells[v].bit, state.cells[v].last}) {
            if (signal.value == Logic::unknown) return signal.cause;
        }
    }
    for (const Signal& signal : state.edges) {
        if (signal.value == Logic::unknown) return signal.cause;
    }
    return std::nullopt;
}

std::string Machine::key(const MachineState& state, Time now) const {
    std::string key;
    for (std::size_t v = 0; v < state.cells.size(); ++v) {
        if (!remembered_[v]) continue;
        const MachineState::Cell& cell = state.cells[v];
        append_packed(key, cell.bit.value);
        if (ladder_.variables[v].type == Type::bit) continue;
        append_packed(key, cell.last.value);
        append_packed(key, cell.number);
        // A timer that has reached its preset stays there.
        append_packed(key, cell.runs ? std::min(now - cell.since, longest_[v]) : Time{-1});
    }
    for (const Signal& signal : state.edges) append_packed(key, signal.value);
    return key;
}

std::string Machine::save(const MachineState& state) const {
    std::string memory;
    for (std::size_t v = 0; v < state.cells.size(); ++v) {
        if (!remembered_[v]) continue;
        const MachineState::Cell& cell = state.cells[v];
        append_packed(memory, cell.bit.value);
        if (ladder_.variables[v].type == Type::bit) continue;
        append_packed(memory, cell.last.value);
        append_packed(memory, cell.runs);
        append_packed(memory, cell.number);
        append_packed(memory, cell.since);
    }
    for (const Signal& signal : state.edges) append_packed(memory, signal.value);
    return memory;
}

MachineState Machine::load(const std::string& memory) const {
    MachineState state;
    PackedReader reader(memory);
    state.cells.resize(ladder_.variables.size());
    for (std::size_t v = 0; v < state.cells.size(); ++v) {
        if (!remembered_[v]) continue;
        MachineState::Cell& cell = state.cells[v];
        reader.take(cell.bit.value);
        if (ladder_.variables[v].type == Type::bit) continue;
        reader.take(cell.last.value);
        reader.take(cell.runs);
        reader.take(cell.number);
        reader.take(cell.since);
    }
    state.edges.resize(edge_count_);
    for (Signal& signal : state.edges) reader.take(signal.value);
    return state;
}

std::vector<Time> Machine::delays() const {
    std::vector<Time> delays;
    for (const Time longest : longest_) {
        if (longest != 0) delays.push_back(longest);
    }
    return delays;
}

}  // namespace grafwire::ladder
