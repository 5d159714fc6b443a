// The cases that leave a product state: every way in which the next instant or scan can come, what
// the reference does in it, and what the netlist does.
//
// Only inputs that somebody looks at are varied. The reference says which it has consulted
// (reference_case.cpp); where the netlist reacts to one that is still unassigned, the case is split
// into its two halves.

#include "check/expansion.h"

#include <algorithm>
#include <cassert>

namespace grafwire {

std::vector<PathStep> halves_of(const Assumptions& assumptions, const PathStep& step,
                                const UnknownCause& cause, bool is_one_at_a_time) {
    const bool is_before = cause.kind == UnknownCause::Kind::unassigned_before;
    std::vector<PathStep> halves;
    for (const PartialInput value : {PartialInput::one, PartialInput::zero}) {
        PathStep half = step;
        if (!is_before) half.inputs[cause.input] = value;
        if (is_before || is_one_at_a_time) half.before[cause.input] = value;
        if (is_one_at_a_time && assumptions.can_hold(half.inputs) &&
            !assumptions.can_hold(half.before)) {
            // It cannot have been so before, together with the inputs that change: it changes too.
            half.before[cause.input] = opposite(value);
        }
        halves.push_back(std::move(half));
    }
    return halves;
}

Expander::Expander(const Grafcet& grafcet, std::shared_ptr<ExploredNetlist> netlist,
                   const ExplorationPlan& plan, KeepGoing keep_going)
    : grafcet_(grafcet),
      netlist_(std::move(netlist)),
      plan_(plan),
      evolution_(grafcet),
      reference_(evolution_, std::move(keep_going)),
      assumptions_(grafcet) {}

bool Expander::is_one_at_a_time() const {
    return !netlist_->is_clocked() && plan_.changes == Changes::one;
}

bool Expander::expand(const ProductState* source, const Visit& visit) {
    bool is_whole = true;
    bool goes_on = true;
    const auto compare_one = [&](const RunningDelays::Ending& ending,
                                 const ReferenceOutcome& expected) {
        is_whole = compare(source, ending, expected, [&](ExpandedCase&& found) {
            goes_on = visit(std::move(found));
            return goes_on;
        });
        return is_whole && goes_on;
    };
    return for_each_expected(source, compare_one) && is_whole;
}

bool Expander::for_each_expected(const ProductState* source, const VisitExpected& visit) {
    is_broken_off_ = false;
    const PartialInputs any = unassigned_inputs(grafcet_, netlist_->has_modes());
    if (source == nullptr) {
        const RunningDelays::Ending at_the_start;
        explore_edge({nullptr, at_the_start}, any, visit);
        return !is_broken_off_;
    }
    source->delays.for_each_ending([&](const RunningDelays::Ending& ending) {
        const Edge edge{source, ending};
        if (!is_one_at_a_time()) return explore_edge(edge, any, visit);
        // Delays end, or no assigned input changes: what the unassigned ones do is seen.
        if (!explore_edge(edge, source->inputs, visit)) return false;
        if (!ending.ended.none()) return true;
        for (const PartialInputs& changed :
             single_changes(assumptions_, source->inputs, netlist_->has_modes())) {
            if (!explore_edge(edge, changed, visit)) return false;
        }
        return true;
    });
    return !is_broken_off_;
}

ReferenceOutcome Expander::run_reference(const Edge& edge, const PartialInputs& inputs) const {
    const EvolutionState* state = edge.source == nullptr ? nullptr : &edge.source->reference;
    const std::vector<std::uint32_t>& due = edge.ending.ended.conditions;
    return netlist_->is_clocked() ? reference_.scan_after(state, due, inputs)
                                  : reference_.instant(state, due, inputs);
}

/// All cases of one instant or scan under partial inputs; false where there is to be no further
/// one.
bool Expander::explore_edge(const Edge& edge, const PartialInputs& inputs,
                            const VisitExpected& visit) {
    bool goes_on = true;
    for_each_case(
        assumptions_, inputs, [&](const PartialInputs& some) { return run_reference(edge, some); },
        [&](const ReferenceOutcome& expected) {
            is_broken_off_ = is_broken_off_ || expected.broken_off;
            goes_on = !is_broken_off_ && visit(edge.ending, expected);
            return goes_on;
        });
    return goes_on;
}

/// The step from a state to inputs of a case; nothing where it takes more changes at once than the
/// plan has.
std::optional<PathStep> Expander::step_to(const Edge& edge, const PartialInputs& inputs) const {
    PathStep step{inputs, inputs, edge.ending.ended, edge.ending.running};
    if (edge.source == nullptr) return step;
    step.before = edge.source->inputs;
    if (!is_one_at_a_time()) return step;
    auto before = inputs_before(assumptions_, edge.source->inputs, inputs);
    if (!before) return std::nullopt;
    step.before = std::move(*before);
    return step;
}

bool Expander::compare(const ProductState* source, const RunningDelays::Ending& ending,
                       const ReferenceOutcome& expected, const Visit& visit) {
    const PartialInputs& left = source == nullptr ? expected.inputs : source->inputs;
    const SimulatorState* state = source == nullptr ? nullptr : &source->netlist;
    std::vector<PathStep> remaining;
    if (auto step = step_to({source, ending}, expected.inputs)) {
        remaining.push_back(std::move(*step));
    }
    while (!remaining.empty()) {
        PathStep step = std::move(remaining.back());
        remaining.pop_back();
        if (source == nullptr) step.before = step.inputs;
        if (!assumptions_.can_hold(step.inputs) || !assumptions_.can_hold(step.before)) continue;
        NetlistOutcomes outcomes;
        if (expected.stable) {
            outcomes = netlist_->run(state, left, step, expected);
            assert(!outcomes.empty());
        }
        const auto first = [&](NetlistOutcome::Kind kind) {
            return std::find_if(
                outcomes.begin(), outcomes.end(),
                [&](const NetlistOutcome& outcome) { return outcome.kind == kind; });
        };
        if (first(NetlistOutcome::Kind::broken_off) != outcomes.end()) return false;
        const auto unassigned = first(NetlistOutcome::Kind::unassigned);
        if (unassigned != outcomes.end()) {
            for (PathStep& half :
                 halves_of(assumptions_, step, *unassigned->unknown, is_one_at_a_time())) {
                remaining.push_back(std::move(half));
            }
        } else if (!visit({ending, expected, std::move(step), std::move(outcomes)})) {
            return true;
        }
    }
    return true;
}

}  // namespace grafwire
