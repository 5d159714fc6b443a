// What a deck is written with: the names of its nodes, its elements and their models.

#include "formats/spice/spice_elements.h"

#include <algorithm>
#include <array>
#include <utility>

#include "text/characters.h"

namespace grafwire {

namespace {

/// What ngspice gives a meaning of its own.
constexpr std::array<std::string_view, 5> reserved{"gnd", "null", "time", "temper", "hertz"};

constexpr char small(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

void spell_spice(std::string& out, std::string_view name) {
    const std::size_t begin = out.size();
    for (const char original : name) {
        const char c = small(original);
        out += is_ascii_letter(c) || is_digit(c) ? c : '_';
    }
    if (name.empty() || !is_ascii_letter(out[begin])) out.insert(begin, 1, 'n');
}

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
                       [](char a, char b) { return a == small(b); });
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

namespace {

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

void append_gate_models(std::string& out, const DelayModel& delays) {
    for (const Primitive& gate : primitives) {
        const Time slow = delays.of(gate.type);
        for (const auto& [speed, delay] :
             {std::pair("slow", slow), std::pair("held", slow - 1), std::pair("fast", Time{1})}) {
            append(out, ".model ", speed, '_', gate.name, ' ', gate.model, "(rise_delay=", delay,
                   " fall_delay=", delay, ")\n");
        }
    }
}

/// The parts that cells with a memory are made of; each initial value is a model of its own.
void append_memory_models(std::string& out, const DelayModel& delays) {
    const Time latch = delays.of(CellType::latch) - 2;
    append(out, ".model late_or d_or(rise_delay=", latch, " fall_delay=", latch, ")\n");
    out += ".model zero d_pulldown\n.model one d_pullup\n";
    constexpr std::string_view initial = "01x";
    const Time hold = delays.of(CellType::hold_latch);
    for (std::size_t ic = 0; ic < initial.size(); ++ic) {
        append(out, ".model hold_", initial[ic], " d_dlatch(data_delay=", hold,
               " enable_delay=", hold, " ic=", ic, ")\n");
    }
    for (std::size_t ic = 0; ic < initial.size(); ++ic) {
        append(out, ".model flip_flop_", initial[ic],
               " d_dff(clk_delay=", delays.of(CellType::flip_flop), " ic=", ic, ")\n");
    }
}

}  // namespace

void append_spice_models(std::string& out, const SpiceModels& models, const DelayModel& delays) {
    out += '\n';
    append_gate_models(out, delays);
    append_memory_models(out, delays);
    append(out, ".model one_shot_rise d_dff(clk_delay=", delays.of(CellType::rise_pulse),
           " reset_delay=1 ic=0)\n.model one_shot_fall d_dff(clk_delay=",
           delays.of(CellType::fall_pulse) - 1, " reset_delay=1 ic=0)\n");
    out += R"(.model sampler d_dff(clk_delay=1 ic=2)
.model bridge adc_bridge(in_low=0.5 in_high=0.5 rise_delay=1 fall_delay=1)
)";
    for (const auto& [width, number] : models.pulses) {
        // The gate that gathers the resets and the flip-flop take a picosecond each.
        append(out, ".model pulse", number, " d_buffer(rise_delay=", std::max<Time>(1, width - 2),
               " fall_delay=1)\n");
    }
    for (const auto& [lengths, number] : models.timers) {
        const auto delay = [&](Time time) {
            return (time == 0 ? delays.of(CellType::timer) : time) - 1;
        };
        append(out, ".model timer", number, " d_buffer(rise_delay=", delay(lengths.first),
               " fall_delay=", delay(lengths.second), ")\n");
    }
}

}  // namespace grafwire
