// Many inputs at once, where one at a time makes no difference: what becomes of the verdict, and
// what keeps it.
//
// The witness of a difference under Changes::many has been made as small as it can be, so every
// change in it is needed, and the last instant at which several things happen says what must not
// happen together. Whether the GRAFCET can say that the plant never does so is tried: with the
// assumption that the inputs never are what they all become there, the check has to come out
// equivalent under both kinds of change, with nothing unexercised that was exercised before.

#include <algorithm>

#include "check/check_equivalence.h"
#include "evolution/evolution.h"
#include "grafcet/plant_conditions.h"
#include "grafcet/write_grafcet.h"

namespace grafwire {

namespace {

/// The last line of the stimuli that changes several inputs, else the last that changes any.
const Stimuli::Change* decisive_line(const Stimuli& stimuli) {
    const Stimuli::Change* decisive = nullptr;
    for (const Stimuli::Change& change : stimuli.changes) {
        if (change.at == 0) continue;  // what the inputs are at the start is no change
        const std::size_t least = decisive != nullptr && decisive->assignments.size() > 1 ? 2 : 1;
        if (change.assignments.size() >= least) decisive = &change;
    }
    return decisive;
}

ExprId variable_of(Grafcet& grafcet, std::uint32_t input) {
    const auto declared = static_cast<std::uint32_t>(grafcet.inputs.size());
    return grafcet.expressions.variable(input < declared
                                            ? Variable{VariableKind::input, input}
                                            : Variable{VariableKind::control, input - declared});
}

/// "Not all of these together", as an expression of the GRAFCET: `/(a . /b)`, or `a + b` where all
/// become 0.
ExprId never_together(Grafcet& grafcet, const std::vector<Stimuli::Assignment>& assignments) {
    const bool all_fall = std::none_of(assignments.begin(), assignments.end(),
                                       [](const auto& set) { return set.value; });
    std::vector<ExprId> literals;
    for (const Stimuli::Assignment& set : assignments) {
        const ExprId variable = variable_of(grafcet, set.input);
        const bool as_it_is = set.value || all_fall;
        literals.push_back(as_it_is ? variable : grafcet.expressions.negation(variable));
    }
    if (all_fall) return grafcet.expressions.disjunction(literals);
    return grafcet.expressions.negation(grafcet.expressions.conjunction(literals));
}

/// The assumption that keeps the inputs apart, if it does and costs nothing.
std::string assumption_against(const Grafcet& grafcet, const Netlist& netlist,
                               const CheckOptions& options, const NeverExercised& unexercised,
                               const std::vector<Stimuli::Assignment>& assignments) {
    Grafcet assuming = grafcet;
    const ExprId expression = never_together(assuming, assignments);
    assuming.assumptions.push_back({expression, {}});
    if (!contradicting_assumptions(assuming).empty()) return {};
    for (const Changes changes : {Changes::one, Changes::many}) {
        CheckOptions some = options;
        some.changes = changes;
        const CheckResult result = check_changes(assuming, netlist, some);
        if (result.verdict != Verdict::equivalent) return {};
        if (changes == Changes::one && result.never != unexercised) return {};
    }
    return write_expression(assuming, assuming.expressions, expression);
}

}  // namespace

Together check_many_changes(const Grafcet& grafcet, const Netlist& netlist,
                            const CheckOptions& options, const NeverExercised& unexercised) {
    CheckOptions at_once = options;
    at_once.changes = Changes::many;
    CheckResult result = check_changes(grafcet, netlist, at_once);
    Together together;
    together.verdict = result.verdict;
    if (!result.witness) return together;
    together.witness = std::move(result.witness);
    const Stimuli::Change* line = decisive_line(together.witness->stimuli);
    if (line == nullptr) return together;
    for (const Stimuli::Assignment& set : line->assignments) together.inputs.push_back(set.input);
    std::sort(together.inputs.begin(), together.inputs.end());
    together.with_delay = line->assignments.size() == 1;
    const bool is_of_the_plant = std::all_of(
        line->assignments.begin(), line->assignments.end(),
        [&](const Stimuli::Assignment& set) { return set.input < grafcet.inputs.size(); });
    if (line->assignments.size() > 1 && is_of_the_plant) {
        together.assumption =
            assumption_against(grafcet, netlist, options, unexercised, line->assignments);
    }
    return together;
}

}  // namespace grafwire
