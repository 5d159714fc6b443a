// What the structure alone shows that asynchronous wiring may get wrong, so that it can be said
// before anything is built, and named where a check has found a difference.
//
// In the successor form a step falls once its followers are up, whyever they are. That is wrong
// where they are up for another reason: because the step has its token from them (a loop of two
// steps), or because a second token is there (ConcurrentSteps says which steps can be active
// together). An edge is wired as a pulse, and a pulse has a width: a transition right behind
// another one that reads the same edge may still see it.
//
// Two transition conditions read the same edge if, with inputs that satisfy both, either is 1 with
// the edge and 0 without: `↑a.b` and `↑a./b` do not. That is tried out for up to ten operands.

#include "equations/wiring_hazards.h"

#include <algorithm>

#include "equations/concurrent_steps.h"
#include "equations/messages.h"
#include "grafcet/write_grafcet.h"
#include "text/joined.h"

namespace grafwire {

namespace say = messages::equations;

namespace {

bool contains(std::span<const StepId> steps, StepId step) {
    return std::find(steps.begin(), steps.end(), step) != steps.end();
}

/// Whether two transitions hang on one edge.
class SharedEdge {
  public:
    SharedEdge(const Expressions& pool, ExprId first, ExprId second)
        : pool_(pool), first_(first), second_(second) {
        collect(first);
        collect(second);
        // The edges and what comes from outside are the same for both; the rest changes as the
        // first one is cleared.
        std::stable_partition(atoms_.begin(), atoms_.end(),
                              [&](ExprId atom) { return !is_inner(atom); });
        shared_ = static_cast<std::size_t>(std::count_if(
            atoms_.begin(), atoms_.end(), [&](ExprId atom) { return !is_inner(atom); }));
    }

    /// The first such edge, or no_expr.
    ExprId find() const {
        for (std::size_t i = 0; i < shared_; ++i) {
            if (!is_edge(atoms_[i]) || !occurs(first_, atoms_[i]) || !occurs(second_, atoms_[i])) {
                continue;
            }
            if (atoms_.size() > most_atoms || can_hang_on(i)) return atoms_[i];
        }
        return no_expr;
    }

  private:
    static constexpr std::size_t most_atoms = 10;

    bool is_edge(ExprId id) const {
        return pool_.kind(id) == ExprKind::rise || pool_.kind(id) == ExprKind::fall;
    }
    bool is_inner(ExprId id) const {
        if (is_edge(id)) return false;
        if (pool_.kind(id) != ExprKind::variable) return true;
        const VariableKind kind = pool_.variable_of(id).kind;
        return kind != VariableKind::input && kind != VariableKind::control;
    }
    static bool is_operator(ExprKind kind) {
        return kind == ExprKind::negation || kind == ExprKind::conjunction ||
               kind == ExprKind::disjunction || kind == ExprKind::exclusive_or;
    }

    /// The operands, those of edges included: an edge says what its operand is.
    void collect(ExprId id) {
        const ExprKind kind = pool_.kind(id);
        if (kind == ExprKind::constant) return;
        if (!is_operator(kind) && std::find(atoms_.begin(), atoms_.end(), id) == atoms_.end()) {
            atoms_.push_back(id);
        }
        if (atoms_.size() > 4 * most_atoms) return;
        for (const ExprId operand : pool_.operands(id)) collect(operand);
    }
    bool occurs(ExprId in, ExprId atom) const {
        if (in == atom) return true;
        if (!is_operator(pool_.kind(in))) return false;
        const auto operands = pool_.operands(in);
        return std::any_of(operands.begin(), operands.end(),
                           [&](ExprId operand) { return occurs(operand, atom); });
    }

    bool value(ExprId id, std::uint32_t row) const {
        const auto operands = pool_.operands(id);
        const auto is_one = [&](ExprId operand) { return value(operand, row); };
        switch (pool_.kind(id)) {
            case ExprKind::constant:
                return pool_.constant_value(id);
            case ExprKind::negation:
                return !is_one(operands[0]);
            case ExprKind::conjunction:
                return std::all_of(operands.begin(), operands.end(), is_one);
            case ExprKind::disjunction:
                return std::any_of(operands.begin(), operands.end(), is_one);
            case ExprKind::exclusive_or:
                return std::count_if(operands.begin(), operands.end(), is_one) % 2 == 1;
            default: {
                const auto atom = std::find(atoms_.begin(), atoms_.end(), id);
                return (row >> static_cast<std::size_t>(atom - atoms_.begin()) & 1U) != 0;
            }
        }
    }

    /// Edges that are 1 have the operand that they leave behind.
    bool is_possible(std::uint32_t row) const {
        for (std::size_t i = 0; i < shared_; ++i) {
            if (!is_edge(atoms_[i]) || (row >> i & 1U) == 0) continue;
            const bool rises = pool_.kind(atoms_[i]) == ExprKind::rise;
            if (value(pool_.operands(atoms_[i])[0], row) != rises) return false;
        }
        return true;
    }
    bool can_hang_on(std::size_t edge) const {
        const auto rows = std::uint32_t{1} << shared_;
        for (std::uint32_t row = 0; row < rows; ++row) {
            if ((row >> edge & 1U) == 0) continue;
            if (hangs_on(first_, edge, row) && hangs_on(second_, edge, row)) return true;
        }
        return false;
    }
    /// For some values of the inner operands.
    bool hangs_on(ExprId id, std::size_t edge, std::uint32_t shared_row) const {
        const auto inner_rows = std::uint32_t{1} << (atoms_.size() - shared_);
        for (std::uint32_t inner = 0; inner < inner_rows; ++inner) {
            const std::uint32_t row = shared_row | inner << shared_;
            if (is_possible(row) && value(id, row) && !value(id, row & ~(1U << edge))) return true;
        }
        return false;
    }

    const Expressions& pool_;
    ExprId first_;
    ExprId second_;
    std::vector<ExprId> atoms_;
    std::size_t shared_ = 0;  ///< the first so many are the same for both
};

/// Goes through every step and every transition out of it, once for each kind of hazard.
class HazardSearch {
  public:
    explicit HazardSearch(const Grafcet& grafcet)
        : grafcet_(grafcet), links_(transitions_by_step(grafcet)) {}

    std::vector<WiringHazard> find() {
        for_every_way_out([&](StepId step, TransitionId out) { find_loop(step, out); });
        const std::size_t loops = hazards_.size();
        const ConcurrentSteps concurrent(grafcet_);
        for_every_way_out([&](StepId step, TransitionId out) {
            const auto after = grafcet_.following(grafcet_.transitions[out]);
            const bool is_own = after.size() == 1 && after[0] == step;
            if (after.empty() || is_own || !concurrent.are_concurrent(step, after)) return;
            if (!is_loop(step, out, loops)) {
                hazards_.push_back({WiringHazard::Kind::two_tokens, step, out, out, no_expr});
            }
        });
        if (!grafcet_.expressions.edges().empty()) {
            for_every_way_out([&](StepId step, TransitionId out) { find_edges(step, out); });
        }
        return std::move(hazards_);
    }

  private:
    template <typename Use>
    void for_every_way_out(const Use& use) {
        for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
            const StepId step = grafcet_.steps.id_at(i);
            for (const TransitionId out : links_.out_of_step(step)) use(step, out);
        }
    }

    /// A way back from all that follows the step by `out`. Whichever list is shorter is searched.
    void find_loop(StepId step, TransitionId out) {
        const auto after = grafcet_.following(grafcet_.transitions[out]);
        if (after.empty()) return;
        if (after.size() == 1 && after[0] == step) {
            hazards_.push_back({WiringHazard::Kind::step_loop, step, out, out, no_expr});
            return;
        }
        const auto into = links_.into_step(step);
        const auto away = links_.out_of_step(after.front());
        for (const TransitionId back : into.size() <= away.size() ? into : away) {
            const Transition& transition = grafcet_.transitions[back];
            if (!contains(grafcet_.following(transition), step)) continue;
            const auto before = grafcet_.preceding(transition);
            if (std::all_of(after.begin(), after.end(),
                            [&](StepId next) { return contains(before, next); })) {
                hazards_.push_back({WiringHazard::Kind::step_loop, step, out, back, no_expr});
                return;
            }
        }
    }

    /// Whether the first so many hazards, the loops in the order of their steps, have this one.
    bool is_loop(StepId step, TransitionId out, std::size_t loops) const {
        const auto end = hazards_.begin() + static_cast<std::ptrdiff_t>(loops);
        auto loop = std::lower_bound(hazards_.begin(), end, step,
                                     [](const WiringHazard& h, StepId id) { return h.step < id; });
        for (; loop != end && loop->step == step; ++loop) {
            if (loop->out == out) return true;
        }
        return false;
    }

    void find_edges(StepId step, TransitionId out) {
        for (const TransitionId into : links_.into_step(step)) {
            const ExprId edge =
                SharedEdge(grafcet_.expressions, grafcet_.transitions[into].condition,
                           grafcet_.transitions[out].condition)
                    .find();
            if (edge == no_expr) continue;
            hazards_.push_back({WiringHazard::Kind::repeated_edge, step, out, into, edge});
        }
    }

    const Grafcet& grafcet_;
    StepTransitions links_;
    std::vector<WiringHazard> hazards_;
};

/// What is said of the hazards, at the transition out of the step.
class Warnings {
  public:
    Warnings(const Grafcet& grafcet, Diagnostics& diagnostics)
        : grafcet_(grafcet), diagnostics_(diagnostics) {}

    void warn(const WiringHazard& hazard) {
        switch (hazard.kind) {
            case WiringHazard::Kind::step_loop:
                return warn_of_loop(hazard);
            case WiringHazard::Kind::two_tokens:
                return warn_of_tokens(hazard);
            case WiringHazard::Kind::repeated_edge:
                return warn_of_edge(hazard);
        }
    }

  private:
    std::string names_of(std::span<const StepId> steps) const {
        std::vector<std::string> names;
        for (const StepId step : steps) names.push_back(grafcet_.steps[step].name);
        return joined(names, ", ");
    }
    Location place_of(TransitionId id) const { return grafcet_.transitions[id].where; }

    void warn_of_loop(const WiringHazard& hazard) {
        const Step& step = grafcet_.steps[hazard.step];
        if (hazard.out == hazard.back) {
            diagnostics_.warning(code::wiring_hazard, place_of(hazard.out),
                                 say::step_follows_itself(step.name));
            return;
        }
        // Both ways round it is the same loop.
        if (hazard.out > hazard.back) return;
        const auto after = grafcet_.following(grafcet_.transitions[hazard.out]);
        diagnostics_
            .warning(code::wiring_hazard, place_of(hazard.out),
                     say::steps_follow_each_other(step.name, names_of(after)))
            .notes.push_back({place_of(hazard.back), say::way_back_here()});
    }

    void warn_of_tokens(const WiringHazard& hazard) {
        const auto after = grafcet_.following(grafcet_.transitions[hazard.out]);
        diagnostics_.warning(
            code::wiring_hazard, place_of(hazard.out),
            say::active_together(grafcet_.steps[hazard.step].name, names_of(after)));
    }

    void warn_of_edge(const WiringHazard& hazard) {
        diagnostics_
            .warning(
                code::wiring_hazard, place_of(hazard.out),
                say::edge_read_again(write_expression(grafcet_, grafcet_.expressions, hazard.edge),
                                     grafcet_.steps[hazard.step].name))
            .notes.push_back({place_of(hazard.back), say::transition_before_here()});
    }

    const Grafcet& grafcet_;
    Diagnostics& diagnostics_;
};

}  // namespace

std::vector<WiringHazard> wiring_hazards(const Grafcet& grafcet) {
    return HazardSearch(grafcet).find();
}

void warn_of_wiring(const Grafcet& grafcet, CdxForm cdx, Diagnostics& diagnostics) {
    Warnings warnings(grafcet, diagnostics);
    for (const WiringHazard& hazard : wiring_hazards(grafcet)) {
        if (cdx == CdxForm::successor || hazard.kind == WiringHazard::Kind::repeated_edge) {
            warnings.warn(hazard);
        }
    }
}

}  // namespace grafwire
