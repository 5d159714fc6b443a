// What a deck is written with: the names of its nodes, its elements, the cells of a netlist as
// elements, and the models of all these.
//
// Gates are XSPICE digital models with a delay (ngspice manual, "XSPICE: digital models"). Cells
// without a model of their own are put together from others; what is inside such a cell takes a
// picosecond, and the rest is shortened by as much: every way through the whole takes what the
// delay model says.
//
//     latch       q = s + /r.q
//     pulse       a flip-flop set by the edge, reset by its own output through a delay
//     timer       a buffer with the two delays

#include "formats/spice/spice_cells.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "formats/shared/gate_delays.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

/// What ngspice gives a meaning of its own.
constexpr std::array<std::string_view, 5> reserved{"gnd", "null", "time", "temper", "hertz"};

/// A word that begins with a letter, in small letters: the ASCII word that stands for the name. It
/// holds no `__`, which our own nodes do.
void spell_spice(std::string& out, std::string_view name) {
    for (const char c : ascii_word(name)) out += lower_case(c);
}

/// The models that a gate is written with, without their speed.
struct GateModel {
    std::string_view name;    ///< of any number of inputs
    std::string_view single;  ///< of one
    std::string_view part;    ///< gathers some of many inputs
};

GateModel model_of(CellType type) {
    switch (type) {
        case CellType::and_gate:
            return {"and", "buffer", "and"};
        case CellType::or_gate:
            return {"or", "buffer", "or"};
        case CellType::nand_gate:
            return {"nand", "not", "and"};
        case CellType::nor_gate:
            return {"nor", "not", "or"};
        case CellType::xor_gate:
            return {"xor", "buffer", "xor"};
        case CellType::inverter:
            return {"not", "not", ""};
        default:
            return {"buffer", "buffer", ""};
    }
}

}  // namespace

NetSpelling spice_nodes(const Netlist& netlist) {
    return {netlist, spell_spice, SafeNames(false, [](std::string_view name) {
                return std::find(reserved.begin(), reserved.end(), name) != reserved.end();
            })};
}

bool is_renamed(std::string_view node, std::string_view net) {
    return !std::equal(node.begin(), node.end(), net.begin(), net.end(),
                       [](char a, char b) { return a == lower_case(b); });
}

std::string spice_list(std::span<const std::string_view> nodes) {
    std::string text = "[";
    std::size_t on_line = 0;
    for (const std::string_view node : nodes)
        append(text, ++on_line % 16 == 0 ? "\n+ " : " ", node);
    return text + " ]";
}

std::string_view SpiceElements::inner_node() {
    std::string name = "__";
    append(name, ++inner_count_);
    return keep(std::move(name));
}

std::vector<std::string_view> SpiceElements::gather(std::span<const std::string_view> nodes,
                                                    std::string_view model) {
    std::vector<std::string_view> gathered;
    for (std::size_t first = 0; first < nodes.size(); first += widest) {
        const auto part = nodes.subspan(first, std::min(widest, nodes.size() - first));
        const std::string_view node = inner_node();
        if (part.size() == 1) {
            add(part[0], ' ', node, " fast_buffer");
        } else {
            add(spice_list(part), ' ', node, " fast_", model);
        }
        gathered.push_back(node);
    }
    return gathered;
}

void SpiceElements::add_gate(std::string_view speed, CellType type,
                             std::vector<std::string_view> pins, std::string_view output) {
    const GateModel model = model_of(type);
    while (pins.size() > widest) pins = gather(pins, model.part);
    if (pins.size() == 1) return add(pins[0], ' ', output, ' ', speed, model.single);
    add(spice_list(pins), ' ', output, ' ', speed, model.name);
}

// Cells.

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

/// Set and reset of XSPICE's memories stay open: initial values come from the model.
void SpiceCells::write_memory(const Cell& cell, std::string_view model, std::string_view output) {
    const char initial = digit_of(cell.initial);
    elements_.add(pin(cell, 0), ' ', pin(cell, 1), " null null ", output, " null ", model, '_',
                  initial);
}

/// The flip-flop takes a 1 at the edge; its output comes back after the width and resets it.
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

/// Of a timer that starts at 1 the operand is held at 1 during the start, otherwise at 0.
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

// Models.

namespace {

/// A gate of XSPICE.
struct Primitive {
    std::string_view name;
    std::string_view model;
    CellType type;  ///< whose delay it has
};

constexpr Primitive primitives[] = {
    {"buffer", "d_buffer", CellType::buffer}, {"not", "d_inverter", CellType::inverter},
    {"and", "d_and", CellType::and_gate},     {"or", "d_or", CellType::or_gate},
    {"nand", "d_nand", CellType::nand_gate},  {"nor", "d_nor", CellType::nor_gate},
    {"xor", "d_xor", CellType::xor_gate},     {"xnor", "d_xnor", CellType::xor_gate}};

/// `{gate}`, `{3 * gate - 2}`: a time in gate delays, less so many picoseconds for the quick parts
/// on the way.
std::string scaled(Time time, const DelayModel& delays, Time quick_parts = 0) {
    std::string text = "{" + in_gate_delays(time, delays, "gate");
    if (quick_parts != 0) append(text, " - ", quick_parts);
    return text += '}';
}

/// Each gate in its three speeds.
void append_gate_models(std::string& out, const DelayModel& delays) {
    for (const Primitive& gate : primitives) {
        const Time slow = delays.of(gate.type);
        for (const auto& [speed, delay] :
             {std::pair("slow", scaled(slow, delays)), std::pair("held", scaled(slow, delays, 1)),
              std::pair("fast", std::string("1"))}) {
            append(out, ".model ", speed, '_', gate.name, ' ', gate.model, "(rise_delay=", delay,
                   " fall_delay=", delay, ")\n");
        }
    }
}

/// The parts that cells with a memory are made of; each initial value is a model of its own.
void append_memory_models(std::string& out, const DelayModel& delays) {
    const std::string latch = scaled(delays.of(CellType::latch), delays, 2);
    append(out, ".model late_or d_or(rise_delay=", latch, " fall_delay=", latch, ")\n");
    out += ".model zero d_pulldown\n.model one d_pullup\n";
    constexpr std::string_view initial = "01x";
    const std::string hold = scaled(delays.of(CellType::hold_latch), delays);
    for (std::size_t ic = 0; ic < initial.size(); ++ic) {
        append(out, ".model hold_", initial[ic], " d_dlatch(data_delay=", hold,
               " enable_delay=", hold, " ic=", ic, ")\n");
    }
    for (std::size_t ic = 0; ic < initial.size(); ++ic) {
        append(out, ".model flip_flop_", initial[ic],
               " d_dff(clk_delay=", scaled(delays.of(CellType::flip_flop), delays), " ic=", ic,
               ")\n");
    }
}

}  // namespace

void append_spice_models(std::string& out, const SpiceModels& models, const DelayModel& delays) {
    out += '\n';
    append_gate_models(out, delays);
    append_memory_models(out, delays);
    append(out,
           ".model one_shot_rise d_dff(clk_delay=", scaled(delays.of(CellType::rise_pulse), delays),
           " reset_delay=1 ic=0)\n.model one_shot_fall d_dff(clk_delay=",
           scaled(delays.of(CellType::fall_pulse), delays, 1), " reset_delay=1 ic=0)\n");
    out += R"(.model sampler d_dff(clk_delay=1 ic=2)
.model bridge adc_bridge(in_low=0.5 in_high=0.5 rise_delay=1 fall_delay=1)
)";
    for (const auto& [width, number] : models.pulses) {
        // The gate that gathers the resets and the flip-flop take a picosecond each.
        append(out, ".model pulse", number, " d_buffer(rise_delay=", scaled(width, delays, 2),
               " fall_delay=1)\n");
    }
    for (const auto& [lengths, number] : models.timers) {
        const auto delay = [&](Time time) {
            return time == 0 ? scaled(delays.of(CellType::timer), delays, 1)
                             : std::to_string(time - 1);
        };
        append(out, ".model timer", number, " d_buffer(rise_delay=", delay(lengths.first),
               " fall_delay=", delay(lengths.second), ")\n");
    }
}

}  // namespace grafwire
