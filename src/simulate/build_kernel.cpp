#include <algorithm>
#include <cassert>
#include <numeric>

#include "simulate/kernel.h"

namespace grafwire {

Simulator::Kernel::Kernel(const Netlist& netlist, const CellDelays& delays) {
    const std::size_t count = netlist.net_count();
    assert(count < (std::size_t{1} << 30U));
    assert(delays.rise.size() == netlist.cells.size());
    assert(delays.fall.size() == netlist.cells.size());
    words_.resize(count, undriven_flag);
    readers_.resize(count);
    values_.resize(count, Logic::unknown);
    types_.resize(count, CellType::buffer);
    memory_of_.resize(count, no_memory);
    touched_.items.resize(count + 1);
    choose_slot(netlist, delays);
    for (std::size_t i = 0; i < netlist.cells.size(); ++i) {
        add_cell(netlist, delays, netlist.cells.id_at(i));
    }
    for (const Netlist::InitialValue& initial : netlist.initial_values) {
        held_at_power_up_.emplace_back(static_cast<std::uint32_t>(initial.net),
                                       logic_of(initial.value));
    }
    if (netlist.is_clocked()) clock_ = static_cast<std::uint32_t>(netlist.clock);
    link_readers(netlist);
    power_up();
}

void Simulator::Kernel::choose_slot(const Netlist& netlist, const CellDelays& delays) {
    Time slot = 0;
    Time longest = 0;
    const auto include = [&](Time delay) {
        assert(delay > 0);
        if (delay != slot) slot = std::gcd(slot, delay);
        longest = std::max(longest, delay);
    };
    for (std::size_t i = 0; i < netlist.cells.size(); ++i) {
        include(delays.rise[i]);
        include(delays.fall[i]);
    }
    const Time longest_gate = longest;
    for (const Cell& cell : netlist.cells) {
        const bool is_pulse =
            cell.type == CellType::rise_pulse || cell.type == CellType::fall_pulse;
        if (is_pulse && netlist.timings[cell.timing].fall > 0) {
            include(netlist.timings[cell.timing].fall);
        }
    }
    if (slot != 0) slot_ = slot;
    uniform_ = longest_gate <= slot_;
    if (uniform_) {
        // The lists are read a little ahead of their ends.
        current_.items.resize(netlist.net_count() + 64);
        next_.items.resize(netlist.net_count() + 64);
    } else {
        timings_.resize(netlist.net_count());
        wheel_ = EventWheel(longest_gate / slot_);
    }
}

void Simulator::Kernel::add_cell(const Netlist& netlist, const CellDelays& delays, CellId id) {
    const Cell& cell = netlist.cells[id];
    const auto net = static_cast<std::uint32_t>(cell.output);
    assert(cell.pin_count <= most_pins);
    types_[net] = cell.type;
    words_[net] = is_gate(cell.type) ? table_of(cell.type) : special_flag;
    if (!uniform_) {
        timings_[net].rise = delays.rise[index_of(id)] / slot_;
        timings_[net].fall = delays.fall[index_of(id)] / slot_;
    }
    if (!is_gate(cell.type) && cell.type != CellType::xor_gate) add_memory(netlist, delays, id);
    if (row_of(cell.type).has_memory) held_at_power_up_.emplace_back(net, cell.initial);
}

void Simulator::Kernel::add_memory(const Netlist& netlist, const CellDelays& delays, CellId id) {
    const Cell& cell = netlist.cells[id];
    const auto pins = netlist.pins_of(cell);
    MemoryCell memory;
    memory.node = static_cast<std::uint32_t>(cell.output);
    memory.data = static_cast<std::uint32_t>(pins.front());
    memory.control = static_cast<std::uint32_t>(pins.back());
    const auto number = static_cast<std::uint32_t>(memories_.size());
    if (cell.type == CellType::rise_pulse || cell.type == CellType::fall_pulse) {
        Pulse pulse;
        pulse.memory = number;
        pulse.delay = delays.rise[index_of(id)] / slot_;
        pulse.width = netlist.timings[cell.timing].fall / slot_;
        memory.detail = static_cast<std::uint32_t>(pulses_.size());
        pulses_.push_back(std::move(pulse));
        held_at_power_up_.emplace_back(memory.node, Logic::zero);
    }
    if (cell.type == CellType::scan_timer_next) {
        memory.held = static_cast<std::uint32_t>(pins[1]);
        look_ahead_nodes_.push_back(memory.node);
    }
    if (is_timer(cell.type)) {
        memory.detail = static_cast<std::uint32_t>(timer_cells_.size());
        timer_cells_.push_back(id);
        timer_nodes_.push_back(memory.node);
        rise_delays_.push_back(netlist.timings[cell.timing].rise);
        fall_delays_.push_back(netlist.timings[cell.timing].fall);
        due_.push_back(never);
        towards_.push_back(Logic::unknown);
    }
    memory_of_[memory.node] = number;
    memories_.push_back(memory);
}

void Simulator::Kernel::link_readers(const Netlist& netlist) {
    std::vector<std::uint32_t> first(netlist.net_count() + 1, 0);
    for (const Cell& cell : netlist.cells) {
        for (const NetId pin : netlist.pins_of(cell)) ++first[index_of(pin) + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::uint32_t> readers(first.back());
    std::vector<std::uint32_t> filled(first.begin(), first.end() - 1);
    for (const Cell& cell : netlist.cells) {
        const std::uint32_t entry =
            2 * static_cast<std::uint32_t>(cell.output) +
            static_cast<std::uint32_t>(gate_rule(cell.type).controlling_value);
        for (const NetId pin : netlist.pins_of(cell)) readers[filled[index_of(pin)]++] = entry;
    }
    for (std::size_t net = 0; net < readers_.size(); ++net) {
        Readers& own = readers_[net];
        const auto begin = readers.begin() + first[net];
        own.count = first[net + 1] - first[net];
        if (own.count <= own.readers.size()) {
            std::copy_n(begin, own.count, own.readers.begin());
        } else {
            own.readers[0] = static_cast<std::uint32_t>(more_readers_.size());
            more_readers_.insert(more_readers_.end(), begin, begin + own.count);
            own.readers[1] = static_cast<std::uint32_t>(more_readers_.size());
        }
    }
}

}  // namespace grafwire
