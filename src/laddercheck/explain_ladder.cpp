// A witness against a ladder diagram explained: the rungs in which the difference came about.
//
// They are found backwards in the last scan, as a slice of the diagram: the rungs that decide a
// variable that is wrong, and those that write what these read, before them in the same scan. Steps
// are not followed: what a scan found active was right, or the difference would have shown earlier.

#include <fmt/format.h>

#include <algorithm>

#include "explain/explanation_writer.h"
#include "ladder/draw/write_drawings.h"
#include "laddercheck/ladder_device.h"
#include "laddercheck/messages.h"
#include "trace/input_values.h"

namespace grafwire {

namespace {

namespace words = messages::laddercheck;
using ladder::VariableId;

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
        writer.say(words::network, rung.number);
        if (rung.origin.is_known()) writer.say(words::at_line, rung.origin.line);
        if (!rung.comment.empty()) writer.add(fmt::format(" ({})", rung.comment));
        writer.say(scan.powers[r] == Logic::one ? words::power_passes : words::power_does_not_pass);
        writer.add(ladder::write_rung(ladder_, rung, 72, 4));
    }
    return writer.take();
}

}  // namespace grafwire
