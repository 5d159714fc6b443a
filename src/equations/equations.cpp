// A GRAFCET becomes equations as in the course "Mise en œuvre du GRAFCET": the condition CAX that
// activates a step and the condition CDX that deactivates it are read off its transitions, and the
// step is a memory with priority to activation, X = CAX + /CDX.X. The parts are derived one after
// the other over tables, so the time is that of reading the GRAFCET: operators with many operands
// are built once and shared by everything that uses them.

#include "equations/equations.h"

#include "equations/derivation.h"

namespace grafwire {

Equations equations_from(const Grafcet& grafcet, const EquationOptions& options) {
    Equations equations;
    equations.options = options;
    // For most charts all there will be: the X of every step, and per transition a clearing
    // condition and the conjunction of the steps that follow.
    const std::size_t transitions = grafcet.transitions.size();
    equations.expressions.reserve(
        grafcet.expressions.size() + grafcet.steps.size() + 2 * transitions, transitions,
        2 * grafcet.links.size() + 2 * transitions);
    normalise_expressions(grafcet, equations);
    derive_frozen(grafcet, equations);
    derive_transitions(grafcet, equations);
    derive_step_conditions(grafcet, equations);
    derive_forcing(grafcet, equations);
    derive_enclosures(grafcet, equations);
    derive_outputs(grafcet, equations);
    derive_stored(grafcet, equations);
    return equations;
}

ExprId combined(Expressions& pool, const StepEquation& parts, StepId step, bool modes) {
    // The memory, then what acts on it from outside, each stronger than the one before.
    const ExprId held = and_of(pool, {not_of(pool, parts.cdx), step_variable(pool, step)});
    ExprId x = or_of(pool, {parts.cax, held});
    if (modes && parts.initial) x = or_of(pool, {x, control_variable(pool, ControlInput::init)});
    if (modes && !parts.initial) x = and_not_control(pool, x, ControlInput::init);

    if (parts.forced_off != no_expr) x = and_of(pool, {x, not_of(pool, parts.forced_off)});
    if (parts.forced_on != no_expr) x = or_of(pool, {x, parts.forced_on});
    if (parts.enclosing != no_expr) x = and_of(pool, {x, parts.enclosing});
    if (parts.link != no_expr) x = or_of(pool, {x, parts.link});
    return modes ? and_not_control(pool, x, ControlInput::au_dur) : x;
}

ExprId step_expression(const Equations& equations, StepId step, Expressions& pool) {
    return combined(pool, equations.steps[step], step, equations.options.modes);
}

ExprId stored_expression(const StoredEquation& stored, Expressions& pool) {
    if (stored.writes.empty()) return pool.constant(false);
    const ExprId held = and_of(pool, {not_of(pool, stored.reset), pool.variable(stored.target)});
    return or_of(pool, {stored.set, held});
}

namespace {

/// One direction of the links between steps and transitions, turned round: per step, the
/// transitions that name it. First every link is counted, then each is put in its place.
struct TurnedRound {
    std::vector<std::uint32_t>& first;
    std::vector<TransitionId>& transitions;
    std::vector<std::uint32_t> next{};  // per step: the next free place

    void count(std::span<const StepId> steps) {
        for (const StepId step : steps) ++first[index_of(step) + 1];
    }
    void make_places() {
        for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
        transitions.resize(first.back());
        next.assign(first.begin(), first.end() - 1);
    }
    void put(std::span<const StepId> steps, TransitionId transition) {
        for (const StepId step : steps) transitions[next[index_of(step)]++] = transition;
    }
};

std::span<const TransitionId> range_of(const std::vector<std::uint32_t>& first,
                                       const std::vector<TransitionId>& all, StepId step) {
    const std::size_t begin = first[index_of(step)];
    return {all.data() + begin, first[index_of(step) + 1] - begin};
}

}  // namespace

std::span<const TransitionId> StepTransitions::into_step(StepId step) const {
    return range_of(first_into, into, step);
}

std::span<const TransitionId> StepTransitions::out_of_step(StepId step) const {
    return range_of(first_out_of, out_of, step);
}

StepTransitions transitions_by_step(const Grafcet& grafcet) {
    StepTransitions result;
    result.first_into.assign(grafcet.steps.size() + 1, 0);
    result.first_out_of.assign(grafcet.steps.size() + 1, 0);
    TurnedRound into{result.first_into, result.into};
    TurnedRound out_of{result.first_out_of, result.out_of};
    for (const Transition& transition : grafcet.transitions) {
        into.count(grafcet.following(transition));
        out_of.count(grafcet.preceding(transition));
    }
    into.make_places();
    out_of.make_places();
    for (std::size_t i = 0; i < grafcet.transitions.size(); ++i) {
        const TransitionId id = grafcet.transitions.id_at(i);
        into.put(grafcet.following(grafcet.transitions[id]), id);
        out_of.put(grafcet.preceding(grafcet.transitions[id]), id);
    }
    return result;
}

}  // namespace grafwire
