// The concurrency relation of a Petri net (A. Kovalyov, "Concurrency relations and the safety
// problem for Petri nets", 1992): the smallest relation of pairs of places that holds for the
// initial marking, for the places that one transition marks, and, where a place is concurrent with
// every place before a transition, for that place and those after it. It is found in polynomial
// time, holds at least for all steps that can be active together, and for exactly these in
// well-formed charts (live, free-choice).
//
// What is of GRAFCET here: a situation comes about at once by INIT, a list of steps in a forcing
// order or activation links as well; steps of different graphs are left out, for no transition
// joins them; and a source transition can be cleared beside anything.

#include "equations/concurrent_steps.h"

#include <algorithm>

#include "equations/equations.h"
#include "grafcet/warnings.h"

namespace grafwire {

ConcurrentSteps::ConcurrentSteps(const Grafcet& grafcet, std::size_t most_pairs)
    : grafcet_(grafcet),
      most_pairs_(most_pairs),
      can_clear_(grafcet.transitions.size(), true),
      enabled_(grafcet.transitions.size(), false),
      reached_(grafcet.steps.size(), false),
      neighbours_(grafcet.steps.size()) {
    StepTransitions links = transitions_by_step(grafcet);
    first_out_of_ = std::move(links.first_out_of);
    out_of_ = std::move(links.out_of);
    const ConstantExpressions constants(grafcet);
    for (std::size_t i = 0; i < grafcet.transitions.size(); ++i) {
        const TransitionId id = grafcet.transitions.id_at(i);
        const Transition& transition = grafcet.transitions[id];
        can_clear_[i] = !constants.is_never_true(transition.condition);
        if (transition.preceding.count == 0 && can_clear_[i]) sources_.push_back(id);
    }
    start();
    while (is_complete_ && (!open_.empty() || !open_steps_.empty())) {
        if (open_steps_.empty()) {
            const Pair next = open_.back();
            open_.pop_back();
            follow(next);
            continue;
        }
        const StepId step = open_steps_.back();
        open_steps_.pop_back();
        for (const TransitionId source : sources_) {
            spread(grafcet_.transitions[source], step);
        }
        for (std::uint32_t i = first_out_of_[index_of(step)]; i < first_out_of_[index_of(step) + 1];
             ++i) {
            enable(out_of_[i]);
        }
    }
}

std::uint64_t ConcurrentSteps::key(StepId a, StepId b) {
    return std::uint64_t{index_of(std::max(a, b))} << 32U | index_of(std::min(a, b));
}

/// The situations that come about at once.
void ConcurrentSteps::start() {
    std::vector<StepId> initial;
    for (std::size_t g = 0; g < grafcet_.graphs.size(); ++g) {
        const Graph& graph = grafcet_.graphs.items()[g];
        initial.clear();
        for (const StepId step : graph.steps) {
            if (grafcet_.steps[step].initial) initial.push_back(step);
        }
        start_together(initial);
    }
    for (const Order& order : grafcet_.orders) start_together(order.steps);
    for (const Enclosure& enclosure : grafcet_.enclosures) start_together(enclosure.links);
    for (const TransitionId source : sources_) enable(source);
}

void ConcurrentSteps::start_together(std::span<const StepId> steps) {
    for (const StepId step : steps) {
        reach(step);
        for (const StepId other : steps) pair(step, other);
    }
}

void ConcurrentSteps::reach(StepId step) {
    if (reached_[index_of(step)]) return;
    reached_[index_of(step)] = true;
    reached_steps_.push_back(step);
    open_steps_.push_back(step);
}

void ConcurrentSteps::pair(StepId a, StepId b) {
    if (a == b || grafcet_.steps[a].graph != grafcet_.steps[b].graph) return;
    if (!is_complete_ || !pairs_.insert(key(a, b)).second) return;
    neighbours_[index_of(a)].push_back(b);
    neighbours_[index_of(b)].push_back(a);
    open_.push_back({a, b});
    is_complete_ = pairs_.size() < most_pairs_;
}

void ConcurrentSteps::follow(const Pair& pair) {
    extend(pair.a, pair.b);
    extend(pair.b, pair.a);
}

/// What a pair leads to by the transitions out of its first step.
void ConcurrentSteps::extend(StepId from, StepId other) {
    for (std::uint32_t i = first_out_of_[index_of(from)]; i < first_out_of_[index_of(from) + 1];
         ++i) {
        enable(out_of_[i]);
        if (enabled_[index_of(out_of_[i])]) spread(grafcet_.transitions[out_of_[i]], other);
    }
}

bool ConcurrentSteps::is_enabled(const Transition& transition) const {
    const std::span<const StepId> before = grafcet_.preceding(transition);
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (!reached_[index_of(before[i])]) return false;
        for (std::size_t j = i + 1; j < before.size(); ++j) {
            if (before[i] != before[j] && !are_concurrent(before[i], before[j])) return false;
        }
    }
    return true;
}

/// Clears a transition for the first time, if it can be.
void ConcurrentSteps::enable(TransitionId id) {
    const Transition& transition = grafcet_.transitions[id];
    if (enabled_[index_of(id)] || !can_clear_[index_of(id)] || !is_enabled(transition)) return;
    enabled_[index_of(id)] = true;
    start_together(grafcet_.following(transition));
    const std::span<const StepId> before = grafcet_.preceding(transition);
    // By index: the lists grow.
    const std::vector<StepId>& bystanders =
        before.empty() ? reached_steps_ : neighbours_[index_of(before.front())];
    for (std::size_t i = 0; i < bystanders.size(); ++i) spread(transition, bystanders[i]);
}

/// A step that can be active while a transition is cleared goes together with what follows it.
void ConcurrentSteps::spread(const Transition& transition, StepId bystander) {
    for (const StepId step : grafcet_.preceding(transition)) {
        if (step == bystander || !are_concurrent(step, bystander)) return;
    }
    for (const StepId step : grafcet_.following(transition)) pair(step, bystander);
}

bool ConcurrentSteps::are_concurrent(StepId step, std::span<const StepId> others) const {
    for (std::size_t i = 0; i < others.size(); ++i) {
        if (others[i] == step) continue;
        if (!are_concurrent(step, others[i])) return false;
        for (std::size_t j = i + 1; j < others.size(); ++j) {
            if (others[j] == step || others[i] == others[j]) continue;
            if (!are_concurrent(others[i], others[j])) return false;
        }
    }
    return true;
}

}  // namespace grafwire
