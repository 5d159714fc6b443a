// Gates are XSPICE digital models with a delay (ngspice manual, "XSPICE: digital models"). Cells
// without a model of their own are put together from others; what is inside such a cell takes a
// picosecond, and the rest is shortened by as much: every way through the whole takes what the
// delay model says.
//
//     latch       q = s + /r.q
//     pulse       a flip-flop set by the edge, reset by its own output through a delay
//     timer       a buffer with the two delays

#include "formats/spice/spice_cells.h"

#include <cassert>

namespace grafwire {

SpiceCells::SpiceCells(const Netlist& netlist, const NetSpelling& nets, SpiceElements& elements)
    : netlist_(netlist),
      nets_(nets),
      elements_(elements),
      initial_(netlist.net_count(), Logic::unknown) {
    for (const Netlist::InitialValue& item : netlist.initial_values) {
        initial_[index_of(item.net)] = logic_of(item.value);
    }
}

void SpiceCells::write_latch(const Cell& cell, std::string_view output) {
    // Both inputs pass two quick elements before the last.
    const std::string_view not_reset = elements_.inner_node();
    const std::string_view kept = elements_.inner_node();
    const std::string_view set = elements_.inner_node();
    const std::string_view late_set = elements_.inner_node();
    const bool starts_at_0 = cell.initial == Logic::zero;
    const bool starts_at_1 = cell.initial == Logic::one;
    elements_.add(pin(cell, 1), ' ', not_reset, " fast_not");
    elements_.add("[ ", not_reset, ' ', output, starts_at_0 ? " __running ] " : " ] ", kept,
                  " fast_and");
    elements_.add(pin(cell, 0), ' ', set, " fast_buffer");
    elements_.add(set, ' ', late_set, " fast_buffer");
    elements_.add("[ ", late_set, ' ', kept, starts_at_1 ? " __start ] " : " ] ", output,
                  " late_or");
}

void SpiceCells::write_memory(const Cell& cell, std::string_view model, std::string_view output) {
    const char initial = digit_of(cell.initial);
    elements_.add(pin(cell, 0), ' ', pin(cell, 1), " null null ", output, " null ", model, '_',
                  initial);
}

void SpiceCells::write_pulse(const Cell& cell, std::string_view output) {
    std::string_view clock = pin(cell, 0);
    if (cell.type == CellType::fall_pulse) {
        clock = elements_.inner_node();
        elements_.add(pin(cell, 0), ' ', clock, " fast_not");
    }
    const auto model =
        models_.pulses.try_emplace(netlist_.timings[cell.timing].fall, models_.pulses.size() + 1);
    const std::string_view over = elements_.inner_node();
    const std::string_view reset = elements_.inner_node();
    elements_.add("__one ", clock, " null ", reset, ' ', output, " null ",
                  cell.type == CellType::fall_pulse ? "one_shot_fall" : "one_shot_rise");
    elements_.add(output, ' ', over, " pulse", model.first->second);
    elements_.add("[ ", over, " __start ] ", reset, " fast_or");
}

void SpiceCells::write_timer(const Cell& cell, std::string_view output) {
    const Timing& timing = netlist_.timings[cell.timing];
    const auto model =
        models_.timers.try_emplace({timing.rise, timing.fall}, models_.timers.size() + 1);
    const std::string_view operand = elements_.inner_node();
    const bool starts_at_1 = cell.initial == Logic::one;
    elements_.add("[ ", pin(cell, 0), starts_at_1 ? " __start ] " : " __running ] ", operand,
                  starts_at_1 ? " fast_or" : " fast_and");
    elements_.add(operand, ' ', output, " timer", model.first->second);
}

void SpiceCells::write_driver(const Cell& cell, std::string_view output, std::string_view speed) {
    switch (cell.type) {
        case CellType::low:
            return elements_.add(output, " zero");
        case CellType::high:
            return elements_.add(output, " one");
        case CellType::latch:
            return write_latch(cell, output);
        case CellType::hold_latch:
            return write_memory(cell, "hold", output);
        case CellType::flip_flop:
            return write_memory(cell, "flip_flop", output);
        case CellType::rise_pulse:
        case CellType::fall_pulse:
            return write_pulse(cell, output);
        case CellType::timer:
            return write_timer(cell, output);
        default:
            break;
    }
    assert(!counts_scans(cell.type));
    std::vector<std::string_view> pins;
    for (const NetId net : netlist_.pins_of(cell)) pins.push_back(nets_[net]);
    elements_.add_gate(speed, cell.type, std::move(pins), output);
}

void SpiceCells::write(const Cell& cell) {
    const std::string_view output = nets_[cell.output];
    const Logic held = initial_[index_of(cell.output)];
    if (held == Logic::unknown) return write_driver(cell, output, "slow_");
    // A gate with an initial value drives an inner node, which the net follows after the start.
    const std::string_view free = elements_.inner_node();
    const bool at_1 = held == Logic::one;
    elements_.add("[ ", free, at_1 ? " __start ] " : " __running ] ", output,
                  at_1 ? " fast_or" : " fast_and");
    write_driver(cell, free, "held_");
}

}  // namespace grafwire
