#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "grafcet/grafcet.h"
#include "sfc/chart.h"
#include "sfc/exclusion.h"

namespace grafwire::sfc {

/// How SFC says an action of a GRAFCET.
enum class Form : std::uint8_t {
    non_stored,    ///< N: a continuous action without a condition
    delayed,       ///< D: `lamp if 5s/X5` of step 5
    limited,       ///< L: `lamp if /(5s/X5)` of step 5
    set,           ///< S
    reset,         ///< R
    activation,    ///< P1, with a statement
    deactivation,  ///< P0, with a statement
    event,         ///< N, with a statement under a condition
    observed,      ///< the output is assigned by the step `observe`
    beyond,        ///< SFC cannot say it: an order
};

/// How the variables of an expression are read: as they are now, or as they were when the scan
/// began. Inputs do not change in a scan.
struct Reading {
    bool at_start = false;
    const std::set<Variable>* copied = nullptr;  ///< these at the start in any case
    bool copies_activity = false;                ///< steps, macro-steps and graphs likewise

    bool is_copy(Variable variable) const {
        const VariableKind kind = variable.kind;
        if (kind == VariableKind::input || kind == VariableKind::control) return false;
        return at_start || (copies_activity && is_activity(kind)) ||
               (copied != nullptr && copied->count(variable) > 0);
    }
    static bool is_activity(VariableKind kind) {
        return kind == VariableKind::step || kind == VariableKind::macro ||
               kind == VariableKind::graph;
    }
};
inline constexpr Reading reading_at_start{true, nullptr};
/// In transition conditions, which are read before anything has changed: there a copy says the same
/// as the flag of a step, and compilers know a flag only below its step.
inline constexpr Reading reading_before_evolution{false, nullptr, true};

/// Everything that is decided before a sequential function chart of a GRAFCET is written.
///
/// The chart has a step `observe` that is always active and whose action is executed last in each
/// scan. It works out the time conditions, which the conditions of transitions see a scan later (as
/// in the table method), assigns the outputs whose conditions no qualifier says, and keeps what the
/// next scan compares with: the operands of edges, and copies of what these read. It also executes
/// the stored actions that read whether other steps are active, for compilers know a step only
/// below it, and `observe` stands below all of them.
struct Plan {
    /// Nothing decided yet. The GRAFCET must outlive the plan.
    Plan(const Grafcet& of, bool with_modes)
        : grafcet(&of),
          has_modes(with_modes),
          chart(of),
          exclusion(of),
          forms(of.actions.size(), Form::beyond),
          copied_reads(of.actions.size()),
          deferred(of.actions.size(), false),
          edges(of.expressions.edges().size(), false),
          times(of.expressions.time_conditions().size(), false) {}

    const Grafcet* grafcet;
    bool has_modes;  ///< where not, an expression that reads Init, AUdur or AUdoux reads 0
    Chart chart;
    Exclusion exclusion;
    std::vector<Form> forms;  ///< per action
    /// Per action: what a stored one reads although another one may write it in the same scan.
    std::vector<std::set<Variable>> copied_reads;
    std::vector<bool> deferred;        ///< per action: a stored one that `observe` executes
    std::set<std::uint32_t> controls;  ///< those of Init, AUdur and AUdoux that anything reads
    std::set<OutputId> observed_outputs;
    bool has_deferred = false;
    bool has_held_vars = false;  ///< vars that steps hold, which are assigned there as well
    std::vector<bool> edges;     ///< per edge: whether anything reads it
    std::vector<bool> times;     ///< per time condition: whether anything reads its bit
    std::set<Variable> copies;
    std::set<std::size_t> time_copies;  ///< of the bits of time conditions
    bool has_start_bit = false;         ///< `started`: 0 in the first scan only
    /// Variables with two writes that can meet in one scan, and the actions that make them.
    struct Meeting {
        Variable target;
        std::set<std::size_t> actions;
    };
    std::vector<Meeting> meetings;  ///< in the order of the variables

    bool has_observer() const;
    Reading reading_of(std::size_t action) const { return {false, &copied_reads[action]}; }
    std::size_t index_of_action(const Action& action) const {
        return static_cast<std::size_t>(&action - grafcet->actions.data());
    }
};

Plan plan_of(const Grafcet& grafcet, bool has_modes = true);

}  // namespace grafwire::sfc
