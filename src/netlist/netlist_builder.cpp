#include "netlist/netlist_builder.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace grafwire {

NetlistBuilder::NetlistBuilder(const Grafcet& grafcet)
    : grafcet_(grafcet),
      step_origins_(grafcet.steps.size()),
      transition_origins_(grafcet.transitions.size()) {
    reserve();
    netlist_.name = grafcet.name;
    netlist_.origins.push_back({});
    const auto note = [&](const std::string& prefix, const std::string& name) {
        if (name.find('$') != std::string::npos) names_with_dollar_.insert(prefix + name);
    };
    for (const Input& input : grafcet.inputs) note("", input.name);
    for (const Output& output : grafcet.outputs) note("", output.name);
    for (const Var& var : grafcet.vars) note("", var.name);
    for (const Step& step : grafcet.steps) note("X", step.name);
    module_ = add_module("inputs");
}

// Makes room for what most charts take, so that lists of millions need not be moved as they grow.
// Room that stays empty is never touched and costs no memory.
void NetlistBuilder::reserve() {
    constexpr std::size_t cells_a_step = 8;
    constexpr std::size_t pins_a_cell = 4;
    constexpr std::size_t name_length = 24;
    const std::size_t steps = grafcet_.steps.size();
    const std::size_t cells = cells_a_step * steps;
    netlist_.cells.items().reserve(cells);
    cell_modules_.reserve(cells);
    netlist_.pins.reserve(pins_a_cell * cells);
    netlist_.names.reserve(cells, name_length * cells);
    netlist_.outputs.reserve(steps + grafcet_.outputs.size());
    netlist_.modules.reserve(steps + grafcet_.outputs.size() + grafcet_.vars.size() + 1);
    netlist_.origins.reserve(steps + grafcet_.transitions.size() + 1);
}

NetlistBuilder::ModuleId NetlistBuilder::add_module(std::string name, std::string comment) {
    netlist_.modules.push_back({std::move(name), std::move(comment), 0, 0});
    return static_cast<ModuleId>(netlist_.modules.size() - 1);
}

void NetlistBuilder::work_on(ModuleId module, std::uint32_t origin) {
    module_ = module;
    origin_ = origin;
}

std::uint32_t NetlistBuilder::add_origin(Origin::Kind kind, std::string name, Location where) {
    netlist_.origins.push_back({kind, std::move(name), where});
    return static_cast<std::uint32_t>(netlist_.origins.size() - 1);
}

std::uint32_t NetlistBuilder::origin_of_step(StepId step) {
    std::uint32_t& origin = step_origins_[index_of(step)];
    if (origin == 0) {
        const Step& item = grafcet_.steps[step];
        origin = add_origin(Origin::Kind::step, item.name, item.where);
    }
    return origin;
}

std::uint32_t NetlistBuilder::origin_of_transition(TransitionId transition) {
    std::uint32_t& origin = transition_origins_[index_of(transition)];
    if (origin == 0) {
        const Transition& item = grafcet_.transitions[transition];
        origin = add_origin(Origin::Kind::transition, "(" + item.name + ")", item.where);
    }
    return origin;
}

NetId NetlistBuilder::add_port_net(std::string_view name) {
    return netlist_.names.add(name);
}

NetId NetlistBuilder::add_net(std::string_view owner, std::string_view role) {
    scratch_.assign(owner);
    scratch_ += '$';
    scratch_ += role;
    while (names_with_dollar_.contains(scratch_)) scratch_ += '$';
    return netlist_.names.add(scratch_);
}

std::uint32_t NetlistBuilder::add_pins(std::span<const NetId> pins) {
    const auto first = static_cast<std::uint32_t>(netlist_.pins.size());
    netlist_.pins.insert(netlist_.pins.end(), pins.begin(), pins.end());
    return first;
}

void NetlistBuilder::add_cell(CellType type, NetId output, std::span<const NetId> pins) {
    assert(pins.size() >= row_of(type).min_pins && pins.size() <= row_of(type).max_pins);
    netlist_.cells.add({type, Logic::unknown, add_pins(pins),
                        static_cast<std::uint32_t>(pins.size()), output, origin_, 0});
    cell_modules_.push_back(static_cast<std::uint32_t>(module_));
}

void NetlistBuilder::add_memory(CellType type, NetId output, std::span<const NetId> pins,
                                Logic initial, const Timing* timing) {
    add_cell(type, output, pins);
    Cell& cell = netlist_.cells.items().back();
    cell.initial = initial;
    if (timing != nullptr) {
        netlist_.timings.push_back(*timing);
        cell.timing = static_cast<std::uint32_t>(netlist_.timings.size() - 1);
    }
}

void NetlistBuilder::add_pulse(CellType type, NetId output, NetId input, Time width) {
    const Timing timing{0, width, Timing::no_ordinal};
    add_memory(type, output, {&input, 1}, Logic::unknown, &timing);
}

void NetlistBuilder::drive(NetId output, CellType type, std::span<const NetId> pins) {
    if (pins.size() == 1) {
        const bool inverting =
            type == CellType::inverter || type == CellType::nand_gate || type == CellType::nor_gate;
        type = inverting ? CellType::inverter : CellType::buffer;
    }
    add_cell(type, output, pins);
}

NetId NetlistBuilder::gate(CellType type, std::span<const NetId> pins, std::string_view owner,
                           std::string_view role) {
    const NetId output = add_net(owner, role);
    drive(output, type, pins);
    return output;
}

NetlistBuilder::Companion& NetlistBuilder::companion(NetId net) {
    if (companions_.size() <= index_of(net)) companions_.resize(netlist_.net_count());
    return companions_[index_of(net)];
}

NetId NetlistBuilder::inverted(NetId net) {
    if (is_low(net)) return high();
    if (is_high(net)) return low();
    if (companion(net).inverted == no_net) {
        const std::string owner(netlist_.names[net]);
        const NetId output = gate(CellType::inverter, {&net, 1}, owner, "not");
        companion(net).inverted = output;
        companion(output).inverted = net;
    }
    return companion(net).inverted;
}

NetId NetlistBuilder::delayed(NetId net, std::uint32_t levels) {
    for (; levels != 0 && !is_low(net) && !is_high(net); --levels) {
        if (companion(net).delayed == no_net) {
            const std::string owner(netlist_.names[net]);
            const NetId output = gate(CellType::buffer, {&net, 1}, owner, "buf");
            companion(net).delayed = output;
        }
        net = companion(net).delayed;
    }
    return net;
}

NetId NetlistBuilder::low() {
    if (low_ == no_net) {
        low_ = add_net("", "low");
        add_cell(CellType::low, low_, {});
    }
    return low_;
}

NetId NetlistBuilder::high() {
    if (high_ == no_net) {
        high_ = add_net("", "high");
        add_cell(CellType::high, high_, {});
    }
    return high_;
}

// A counting sort, stable: the modules know where their cells begin.
void NetlistBuilder::sort_cells() {
    std::vector<std::uint32_t> position(netlist_.modules.size());
    for (std::size_t i = 0; i < position.size(); ++i) position[i] = netlist_.modules[i].first_cell;
    std::vector<Cell> sorted(netlist_.cells.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        sorted[position[cell_modules_[i]]++] = netlist_.cells.items()[i];
    }
    netlist_.cells.items() = std::move(sorted);
}

Netlist NetlistBuilder::finish() {
    for (const std::uint32_t module : cell_modules_) ++netlist_.modules[module].cell_count;
    std::uint32_t next = 0;
    for (Module& module : netlist_.modules) {
        module.first_cell = next;
        next += module.cell_count;
    }
    if (!std::is_sorted(cell_modules_.begin(), cell_modules_.end())) sort_cells();
    std::erase_if(netlist_.modules, [](const Module& module) { return module.cell_count == 0; });
    return std::move(netlist_);
}

}  // namespace grafwire
