#include "support/mutate.h"

#include <algorithm>
#include <utility>

namespace grafwire::testing {

namespace {

/// The type that stands for another, or the type itself where there is no likely mistake.
CellType mistaken(CellType type) {
    static constexpr std::pair<CellType, CellType> pairs[] = {
        {CellType::low, CellType::high},
        {CellType::buffer, CellType::inverter},
        {CellType::and_gate, CellType::or_gate},
        {CellType::nand_gate, CellType::nor_gate},
        {CellType::rise_pulse, CellType::fall_pulse},
    };
    for (const auto& [a, b] : pairs) {
        if (type == a) return b;
        if (type == b) return a;
    }
    return type == CellType::xor_gate ? CellType::or_gate : type;
}

bool swaps_pins(CellType type) {
    return type == CellType::latch || type == CellType::hold_latch;
}

/// The net a pin is moved to: one that a slip of the hand would hit.
NetId neighbour(const Netlist& netlist, NetId net) {
    const std::size_t next = (index_of(net) + 1) % netlist.net_count();
    return static_cast<NetId>(next);
}

/// Gives a cell other pins; its old ones stay in the list, unused.
void set_pins(Netlist& netlist, Cell& cell, const std::vector<NetId>& pins) {
    cell.first_pin = static_cast<std::uint32_t>(netlist.pins.size());
    cell.pin_count = static_cast<std::uint32_t>(pins.size());
    netlist.pins.insert(netlist.pins.end(), pins.begin(), pins.end());
}

/// A new inverter behind a net, in the last module.
NetId inverter_behind(Netlist& netlist, NetId net) {
    Cell inverter;
    inverter.type = CellType::inverter;
    inverter.origin = 0;  // of no part of the chart
    inverter.output = netlist.names.add("mutation$inverter");
    set_pins(netlist, inverter, {net});
    netlist.cells.add(inverter);
    ++netlist.modules.back().cell_count;
    return inverter.output;
}

}  // namespace

std::vector<Mutation> mutations_of(const Netlist& netlist) {
    std::vector<Mutation> mutations;
    for (std::size_t i = 0; i < netlist.cells.size(); ++i) {
        const CellId id = netlist.cells.id_at(i);
        const Cell& cell = netlist.cells[id];
        const CellTypeRow& row = row_of(cell.type);
        if (mistaken(cell.type) != cell.type || swaps_pins(cell.type)) {
            mutations.push_back({Mutation::Kind::other_type, id, 0});
        }
        if (row.has_memory && cell.initial != Logic::unknown) {
            mutations.push_back({Mutation::Kind::other_initial, id, 0});
        }
        // The clock stays as it is.
        const std::uint32_t pins = cell.pin_count - (row.is_clocked ? 1 : 0);
        for (std::uint32_t pin = 0; pin < pins; ++pin) {
            if (cell.pin_count > row.min_pins) {
                mutations.push_back({Mutation::Kind::no_pin, id, pin});
            }
            mutations.push_back({Mutation::Kind::inverted_pin, id, pin});
            mutations.push_back({Mutation::Kind::moved_pin, id, pin});
        }
    }
    return mutations;
}

Netlist mutated(Netlist netlist, const Mutation& mutation) {
    const auto old = netlist.pins_of(netlist.cells[mutation.cell]);
    std::vector<NetId> pins(old.begin(), old.end());
    switch (mutation.kind) {
        case Mutation::Kind::other_type:
            if (swaps_pins(netlist.cells[mutation.cell].type)) std::swap(pins[0], pins[1]);
            break;
        case Mutation::Kind::other_initial:
            break;
        case Mutation::Kind::no_pin:
            pins.erase(pins.begin() + static_cast<std::ptrdiff_t>(mutation.pin));
            break;
        case Mutation::Kind::inverted_pin:
            pins[mutation.pin] = inverter_behind(netlist, pins[mutation.pin]);
            break;
        case Mutation::Kind::moved_pin:
            pins[mutation.pin] = neighbour(netlist, pins[mutation.pin]);
            break;
    }
    Cell& cell = netlist.cells[mutation.cell];
    if (mutation.kind == Mutation::Kind::other_type) cell.type = mistaken(cell.type);
    if (mutation.kind == Mutation::Kind::other_initial) {
        cell.initial = cell.initial == Logic::one ? Logic::zero : Logic::one;
    }
    set_pins(netlist, cell, pins);
    return netlist;
}

std::string describe(const Netlist& netlist, const Mutation& mutation) {
    static constexpr const char* words[] = {"another type", "another initial value",
                                            "an input left out", "an input inverted",
                                            "an input from a neighbouring net"};
    return std::string(words[static_cast<std::size_t>(mutation.kind)]) + ": " +
           cell_description(netlist, mutation.cell) + ", pin " + std::to_string(mutation.pin);
}

}  // namespace grafwire::testing
