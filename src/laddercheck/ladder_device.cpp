// A ladder diagram as a device of the check: its variables found by name, and its memory between
// two scans packed into a string. Unassigned inputs run through the diagram as unknown signals that
// carry their cause (ladder/machine.h), so an unknown result names an input that it needs.

#include "laddercheck/ladder_device.h"

#include <fmt/format.h>

#include "grafcet/grafcet.h"
#include "iec/identifiers.h"

namespace grafwire {

using ladder::VariableId;

LadderNames find_names(const Grafcet& grafcet, const ladder::Ladder& ladder) {
    const std::vector<std::string> names = declared_names(grafcet);
    const std::vector<std::string> identifiers = iec::Identifiers().add(names);
    std::map<std::string, VariableId> spelled;
    std::map<std::string, VariableId> bits;  // by name in capitals
    for (std::uint32_t v = 0; v < ladder.variables.size(); ++v) {
        if (ladder.variables[v].type != ladder::Type::bit) continue;
        spelled.emplace(ladder.variables[v].name, VariableId{v});
        bits.emplace(iec::capitals(ladder.variables[v].name), VariableId{v});
    }
    LadderNames found;
    std::size_t next = 0;
    // The very name first: a diagram that is not bound to identifiers may have both `a` and `A`.
    const auto find = [&]() -> std::optional<VariableId> {
        const std::size_t at = next++;
        const auto exact = spelled.find(names[at]);
        if (exact != spelled.end()) return exact->second;
        for (const std::string* name : {&identifiers[at], &names[at]}) {
            const auto bit = bits.find(iec::capitals(*name));
            if (bit != bits.end()) return bit->second;
        }
        return std::nullopt;
    };
    const auto find_compared = [&](std::vector<VariableId>& list) {
        const auto variable = find();
        if (!variable) found.missing.push_back(names[next - 1]);
        list.push_back(variable.value_or(VariableId{}));
    };
    for (std::size_t i = 0; i < grafcet.all_input_count(); ++i) {
        found.inputs.push_back(find());
        if (!found.inputs.back() && i < grafcet.inputs.size()) {
            found.missing_inputs.push_back(names[i]);
        }
    }
    for (std::size_t o = 0; o < grafcet.outputs.size(); ++o) find_compared(found.outputs);
    for (std::size_t s = 0; s < grafcet.steps.size(); ++s) find_compared(found.steps);
    return found;
}

LadderDevice::LadderDevice(const Grafcet& grafcet, const ladder::Ladder& ladder, LadderNames names)
    : grafcet_(grafcet), ladder_(ladder), names_(std::move(names)), machine_(ladder) {
    for (std::uint32_t i = 0; i < names_.inputs.size(); ++i) {
        if (names_.inputs[i]) input_of_.emplace(*names_.inputs[i], i);
    }
}

bool LadderDevice::has_modes() const {
    for (std::size_t i = grafcet_.inputs.size(); i < names_.inputs.size(); ++i) {
        if (names_.inputs[i]) return true;
    }
    return false;
}

std::string LadderDevice::start() const {
    return machine_.save(machine_.start());
}

ScannedDevice::Outcome LadderDevice::scan(const std::string& memory, const PartialInputs& inputs,
                                          Time now) const {
    ladder::MachineState state = machine_.load(memory);
    for (const auto& [variable, input] : input_of_) {
        machine_.set(state, variable, logic_of(inputs[input]));
    }
    Outcome outcome;
    auto needs = machine_.scan(state, now).needs;
    if (!needs) needs = machine_.open_memory(state);
    const auto read = [&](const std::vector<VariableId>& variables, std::vector<Logic>& values) {
        for (const VariableId variable : variables) {
            const ladder::Signal& bit = state.cells[static_cast<std::size_t>(variable)].bit;
            if (bit.value == Logic::unknown && !needs) needs = bit.cause;
            values.push_back(bit.value);
        }
    };
    read(names_.steps, outcome.steps);
    read(names_.outputs, outcome.outputs);
    if (needs) {
        outcome.needs = input_of_.at(*needs);
        return outcome;
    }
    outcome.memory = machine_.save(state);
    return outcome;
}

std::string LadderDevice::key(const std::string& memory, Time now) const {
    return machine_.key(machine_.load(memory), now);
}

}  // namespace grafwire
