// A ladder diagram as a device of the check: its variables found by name, and its memory between
// two scans packed into a string. Unassigned inputs run through the diagram as unknown signals that
// carry their cause (ladder/machine.h), so an unknown result names an input that it needs:
//
//     rung  ─┤ a ├─┤ b ├─( X1 )     a = 0, b unassigned: X1 is 0, b is never asked for
//                                   a = 1, b unassigned: X1 is unknown, the device needs b
//
// What is remembered must not stay unknown either, for a later scan could depend on it.

#include "laddercheck/ladder_device.h"

#include <algorithm>

#include "explain/explanation_writer.h"
#include "grafcet/grafcet.h"
#include "iec/identifiers.h"
#include "ladder/draw/write_drawings.h"
#include "laddercheck/messages.h"
#include "trace/input_values.h"

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

// A witness explained: the rungs in which the difference came about.
//
// They are found backwards in the last scan, as a slice of the diagram: the rungs that decide a
// variable that is wrong, and those that write what these read, before them in the same scan. Steps
// are not followed: what a scan found active was right, or the difference would have shown earlier.

namespace {

namespace words = messages::laddercheck;

constexpr std::size_t most_rungs = 12;

/// A variable that is not what it should be.
struct Difference {
    VariableId variable{};
    bool expected = false;
};

bool writes(const ladder::Rung& rung, VariableId variable) {
    for (const ladder::Coil& coil : rung.coils) {
        if (coil.variable == variable) return true;
    }
    for (const ladder::Block& block : rung.blocks) {
        if (block.target == variable) return true;
    }
    return false;
}

/// Whether a rung may be why: a set coil that had power where there should be a 0, or had none
/// where there should be a 1; a reset coil likewise; any other coil.
bool may_be_why(const ladder::Rung& rung, bool has_power, const Difference& difference) {
    for (const ladder::Coil& coil : rung.coils) {
        if (coil.variable != difference.variable) continue;
        if (coil.kind == ladder::CoilKind::set) return has_power != difference.expected;
        if (coil.kind == ladder::CoilKind::reset) return has_power == difference.expected;
        return true;
    }
    return writes(rung, difference.variable);
}

/// The variables that a rung reads: those of contacts and comparisons, branch by branch.
void collect_reads(const ladder::Power& power, std::vector<VariableId>& variables) {
    if (power.kind == ladder::Power::Kind::contact) variables.push_back(power.variable);
    for (const ladder::Operand* operand : {&power.left, &power.right}) {
        if (power.kind == ladder::Power::Kind::comparison &&
            operand->kind == ladder::Operand::Kind::variable) {
            variables.push_back(operand->variable);
        }
    }
    for (const ladder::Power& part : power.parts) collect_reads(part, variables);
}

/// The rungs that the differences may come from: one variable after the other those that decide it,
/// each with those that write what it reads.
std::vector<std::size_t> candidate_rungs(const ladder::Ladder& ladder,
                                         const std::vector<Logic>& powers,
                                         const std::vector<Difference>& differences,
                                         const std::vector<VariableId>& steps) {
    std::vector<std::size_t> found;
    const auto add = [&](std::size_t rung) {
        if (found.size() == most_rungs) return;
        if (std::find(found.begin(), found.end(), rung) == found.end()) found.push_back(rung);
    };
    for (const Difference& difference : differences) {
        std::size_t next = found.size();
        for (std::size_t r = 0; r < ladder.rungs.size(); ++r) {
            if (may_be_why(ladder.rungs[r], powers[r] == Logic::one, difference)) add(r);
        }
        for (; next < found.size(); ++next) {
            std::vector<VariableId> read;
            const std::size_t reader = found[next];
            collect_reads(ladder.rungs[reader].power, read);
            for (const VariableId variable : read) {
                if (std::find(steps.begin(), steps.end(), variable) != steps.end()) continue;
                for (std::size_t r = 0; r < reader; ++r) {
                    if (writes(ladder.rungs[r], variable)) add(r);
                }
            }
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

/// The scan at the end of the witness, as the diagram executes it.
ladder::Machine::Outcome LadderDevice::last_scan(const Witness& witness) const {
    ladder::MachineState state = machine_.start();
    ladder::Machine::Outcome outcome;
    StimuliPlayer player(witness.stimuli, grafcet_.all_input_count());
    for (Time now = 0; now <= witness.stimuli.end; now += witness.scan_period) {
        player.advance(now);
        for (const auto& [variable, input] : input_of_) {
            machine_.set(state, variable, logic_of(player.inputs()[input] != 0));
        }
        outcome = machine_.scan(state, now);
    }
    return outcome;
}

std::string LadderDevice::explain(const Witness& witness, Language language) const {
    ExplanationWriter writer(grafcet_, witness, language);
    writer.explain_changes();
    writer.explain_reference();
    writer.explain_difference(words::the_ladder_diagram);
    const ladder::Machine::Outcome scan = last_scan(witness);
    std::vector<Difference> differences;
    for (std::size_t v = 0; v < witness.values.size(); ++v) {
        if (witness.values[v].expected == witness.values[v].got) continue;
        const VariableId variable =
            v < names_.steps.size() ? names_.steps[v] : names_.outputs[v - names_.steps.size()];
        differences.push_back({variable, witness.values[v].expected == Logic::one});
        const std::uint32_t last_writer = scan.writers[static_cast<std::size_t>(variable)];
        const std::string& name = ladder_.variable(variable).name;
        if (last_writer == ladder::Machine::nobody) {
            writer.say(words::no_network_has_written, name);
        } else {
            writer.say(words::was_last_written, name, ladder_.rungs[last_writer].number);
        }
    }
    const std::vector<std::size_t> rungs =
        candidate_rungs(ladder_, scan.powers, differences, names_.steps);
    if (!rungs.empty()) writer.say(words::networks_that_decide);
    for (const std::size_t r : rungs) {
        const ladder::Rung& rung = ladder_.rungs[r];
        writer.say(scan.powers[r] == Logic::one ? words::power_passes : words::power_does_not_pass,
                   writer.network_text(rung.number, rung.comment, rung.origin));
        writer.add(ladder::write_rung(ladder_, rung, 72, 4));
    }
    return writer.take();
}

}  // namespace grafwire
