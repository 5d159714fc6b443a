// A receptivity that is wrong, and what it is wrong because of.

#include "s7check/investigation.h"

namespace grafwire {

/// Of enabled transitions only: Tt is 1 where they are cleared.
Investigation::Deviation Investigation::in_receptivities() {
    for (std::size_t t = 0; t < binding_.transitions.size(); ++t) {
        const bool expected = expected_.cleared.test(t);
        const Operand& place = *binding_.transitions[t];
        if (!expected_.enabled.test(t) || got(place) == expected) continue;
        const Transition& transition = grafcet_.transitions[static_cast<TransitionId>(t)];
        if (auto kept = in_freezing(transition)) return kept;
        if (auto kept = in_vars(transition)) return kept;
        Finding finding = suspects_.written(Kind::receptivity, transition.name, place, expected);
        if (auto timer = in_timer(finding, transition)) return timer;
        return finding;
    }
    return std::nullopt;
}

/// Where the freezing bit was not what it should have been when it was read.
Investigation::Deviation Investigation::in_freezing(const Transition& transition) {
    const std::size_t graph = index_of(transition.graph);
    const std::optional<Operand>& place = binding_.graphs[graph];
    if (!place) return std::nullopt;
    const std::string& name = grafcet_.graphs[transition.graph].name;
    const auto kept = kept_.find(name);
    if (kept != kept_.end()) return kept->second;
    const bool expected = before_.may_evolve.test(graph);
    if (suspects_.read_as(*place).value_or(expected) == expected) return std::nullopt;
    return suspects_.written(Kind::may_evolve, name, *place, expected);
}

/// Where a var that the receptivity reads has been wrong since an earlier scan.
Investigation::Deviation Investigation::in_vars(const Transition& transition) {
    std::vector<ExprId> parts;
    collect(transition.receptivity, ExprKind::variable, parts);
    for (const ExprId id : parts) {
        const Variable variable = grafcet_.expressions.variable_of(id);
        if (variable.kind != VariableKind::var) continue;
        const auto kept = kept_.find(variable_name(grafcet_, variable));
        if (kept != kept_.end()) return kept->second;
    }
    return std::nullopt;
}

/// Where the receptivity reads one time condition and its network a timer, and these were not the
/// same before the scan: the network that runs the timer.
Investigation::Deviation Investigation::in_timer(const Finding& receptivity,
                                                 const Transition& transition) {
    std::vector<ExprId> conditions;
    collect(transition.receptivity, ExprKind::time_condition, conditions);
    if (receptivity.networks.empty() || conditions.size() != 1) return std::nullopt;
    const bool expected = before_.time_values.test(grafcet_.expressions.ordinal(conditions[0]));
    for (const s7::Network& network : listing_.networks) {
        if (network.number != receptivity.networks[0]) continue;
        for (const s7::Instruction& instruction : network.instructions) {
            if (instruction.operands.empty()) continue;
            const Operand& timer = instruction.operands[0];
            if (timer.area != s7::Area::timer || !loads(instruction, timer)) continue;
            if (machine_.bit(state_before_, timer).is_one() == expected) continue;
            Finding finding = receptivity;
            finding.kind = Kind::timer;
            finding.name = "T" + std::to_string(timer.address);
            finding.place = timer;
            finding.expected = expected;
            suspects_.blame_instead(finding, suspects_.runners_of(timer));
            finding.should_have_written = false;
            return finding;
        }
    }
    return std::nullopt;
}

/// The parts of an expression that are of a kind.
void Investigation::collect(ExprId id, ExprKind kind, std::vector<ExprId>& found) const {
    if (id == no_expr) return;
    if (grafcet_.expressions.kind(id) == kind) found.push_back(id);
    for (const ExprId operand : grafcet_.expressions.operands(id)) collect(operand, kind, found);
}

}  // namespace grafwire
