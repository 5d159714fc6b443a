#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "equations/equations.h"
#include "equations/logic.h"

namespace grafwire {

// What the parts of equations_from share. Each derive_ function fills the fields it names from the
// GRAFCET and from what the functions before it have filled; they are listed in this order.

/// `expressions` and `from_grafcet`: every expression of the GRAFCET without constant terms and
/// without the variables of macro-steps and graphs. Edges and time conditions keep their ordinals.
void normalise_expressions(const Grafcet& grafcet, Equations& equations);
/// `frozen`.
void derive_frozen(const Grafcet& grafcet, Equations& equations);
/// `transition_conditions` and `clearing`.
void derive_transitions(const Grafcet& grafcet, Equations& equations);
/// CAX and CDX of every step.
void derive_step_conditions(const Grafcet& grafcet, Equations& equations);
/// forced_off, forced_on, enclosing and link of every step.
void derive_forcing(const Grafcet& grafcet, Equations& equations);
void derive_enclosures(const Grafcet& grafcet, Equations& equations);
/// `outputs`.
void derive_outputs(const Grafcet& grafcet, Equations& equations);
/// `stored`.
void derive_stored(const Grafcet& grafcet, Equations& equations);

/// X of a step.
inline ExprId step_variable(Expressions& pool, StepId step) {
    return pool.variable({VariableKind::step, static_cast<std::uint32_t>(step)});
}

inline ExprId control_variable(Expressions& pool, ControlInput input) {
    return pool.variable({VariableKind::control, static_cast<std::uint32_t>(input)});
}

/// The expression without its control input: `e . /Init`.
inline ExprId and_not_control(Expressions& pool, ExprId id, ControlInput input) {
    return and_of(pool, {id, not_of(pool, control_variable(pool, input))});
}

/// Likewise; `e` as it is where there are no modes.
inline ExprId and_not_control(Equations& equations, ExprId id, ControlInput input) {
    return equations.options.modes ? and_not_control(equations.expressions, id, input) : id;
}

/// What an expression of the GRAFCET has become here.
inline ExprId translated(const Equations& equations, ExprId in_grafcet) {
    return equations.from_grafcet[static_cast<std::size_t>(in_grafcet)];
}

/// Lists of terms (the steps that force a graph, say) that are collected out of order and then read
/// per key, in the order collected.
template <typename Id>
class TermsByKey {
  public:
    void add(Id key, ExprId term) { terms_.emplace_back(key, term); }

    /// Calls `use(key, terms)` for every key that has terms, by ascending key. Nothing is left.
    template <typename Use>
    void consume(Use use) {
        std::stable_sort(terms_.begin(), terms_.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        std::vector<ExprId> run;
        for (std::size_t i = 0; i < terms_.size(); ++i) {
            run.push_back(terms_[i].second);
            if (i + 1 < terms_.size() && terms_[i + 1].first == terms_[i].first) continue;
            use(terms_[i].first, run);
            run.clear();
        }
        terms_.clear();
    }

  private:
    std::vector<std::pair<Id, ExprId>> terms_;
};

}  // namespace grafwire
