// What changes outside has a part in an instant where something that the reference did has read it.
// The situation before was stable (or the scan before has been told), so nothing would have
// happened without it.

#include "story/instant_causes.h"

#include <algorithm>
#include <utility>

#include "grafcet/expression.h"
#include "grafcet/write_grafcet.h"
#include "text/table.h"

namespace grafwire {

namespace {

class CauseFinder {
  public:
    explicit CauseFinder(const Grafcet& grafcet) : grafcet_(grafcet) {}

    /// `before`: the story of the instant or scan before.
    InstantCauses causes_of(const InstantStory& story, const InstantStory& before) {
        read_.assign(grafcet_.expressions.size(), false);
        // What was cleared in every scan without changing anything may not be cleared any more.
        for (const EnabledTransition& enabled : before.enabled) {
            if (enabled.condition) read(grafcet_.transitions[enabled.transition].condition);
        }
        for (const ScanStory& scan : story.scans) {
            for (const TransitionId id : scan.record.cleared) {
                read(grafcet_.transitions[id].condition);
            }
            for (const ScanRecord::StoredWrite& write : scan.record.writes) {
                if (write.on_clearing) {
                    read(grafcet_.clearing_actions[write.action].write.value);
                } else {
                    const Action& action = grafcet_.actions[write.action];
                    read(action.expression);
                    read(action.write.value);
                }
            }
        }
        read_actions(story, before);
        InstantCauses causes;
        causes.at = story.at;
        for (const Stimuli::Assignment& set : story.inputs) {
            if (has_a_part(set, story, before)) causes.inputs.push_back(set.input);
        }
        for (const ExprId ended : ended_delays(story, before)) {
            if (!read_[index_of(ended)]) continue;
            causes.ended.push_back(write_expression(grafcet_, grafcet_.expressions, ended));
        }
        return causes;
    }

  private:
    /// Marks an expression and all that it depends on.
    void read(ExprId id) {
        if (id == no_expr || read_[index_of(id)]) return;
        read_[index_of(id)] = true;
        const Expressions& expressions = grafcet_.expressions;
        if (expressions.kind(id) == ExprKind::time_condition) {
            read(expressions.time_condition_of(id).operand);
        }
        for (const ExprId operand : expressions.operands(id)) read(operand);
    }

    /// The conditions of continuous actions whose output is another than before, and of those that
    /// hold a var.
    void read_actions(const InstantStory& story, const InstantStory& before) {
        for (const Action& action : grafcet_.actions) {
            const bool has_changed =
                action.kind == ActionKind::continuous
                    ? story.outputs.test(index_of(action.output)) !=
                          before.outputs.test(index_of(action.output))
                    : action.kind == ActionKind::held && story.vars.test(index_of(action.var)) !=
                                                             before.vars.test(index_of(action.var));
            const std::size_t step = index_of(action.step);
            if (has_changed && (story.situation.test(step) || before.situation.test(step))) {
                read(action.expression);
            }
        }
    }

    bool has_a_part(const Stimuli::Assignment& set, const InstantStory& story,
                    const InstantStory& before) const {
        if (set.input < grafcet_.inputs.size()) {
            const Expressions& expressions = grafcet_.expressions;
            for (std::size_t i = 0; i < read_.size(); ++i) {
                const ExprId id{static_cast<std::uint32_t>(i)};
                if (read_[i] && expressions.kind(id) == ExprKind::variable &&
                    expressions.variable_of(id) == Variable{VariableKind::input, set.input}) {
                    return true;
                }
            }
            return false;
        }
        const auto mode = static_cast<ControlInput>(set.input - grafcet_.inputs.size());
        if (mode == ControlInput::au_doux) return story.outputs != before.outputs;
        return !story.scans.empty();
    }

    /// By scans a delay ends in the scan before the one that may read it.
    static std::vector<ExprId> ended_delays(const InstantStory& story, const InstantStory& before) {
        std::vector<ExprId> ended;
        for (const TimeConditionChange& change : story.ended) ended.push_back(change.condition);
        if (!story.by_scans) return ended;
        using Kind = TimeConditionChange::Kind;
        for (const ScanStory& scan : before.scans) {
            for (const TimeConditionChange& change : scan.times) {
                if (change.kind == Kind::becomes_1 || change.kind == Kind::becomes_0) {
                    ended.push_back(change.condition);
                }
            }
        }
        return ended;
    }

    const Grafcet& grafcet_;
    std::vector<bool> read_;  ///< per expression
};

}  // namespace

std::vector<InstantCauses> causes_in(const Grafcet& grafcet,
                                     const std::vector<InstantStory>& stories) {
    CauseFinder finder(grafcet);
    std::vector<InstantCauses> all;
    for (std::size_t i = 1; i < stories.size(); ++i) {
        if (!stories[i].is_stable || stories[i].is_quiet) continue;
        InstantCauses causes = finder.causes_of(stories[i], stories[i - 1]);
        if (!causes.inputs.empty() || !causes.ended.empty()) all.push_back(std::move(causes));
    }
    return all;
}

}  // namespace grafwire
