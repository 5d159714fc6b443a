// A run of the reference is told while it runs: each scan keeps a record of what it did
// (ScanRecord), and the state before and after it says the rest. What a condition was made of is
// read once more, with the edges of that scan.
//
// An instant without a stable situation is known before it is told: a copy of the state is sent
// ahead. So an instant of very many scans costs twice the time, and no more memory than the scans
// that are told.

#include "story/instant_story.h"

#include <algorithm>
#include <utility>

#include "evolution/run_record.h"
#include "grafcet/expression.h"
#include "grafcet/write_grafcet.h"

namespace grafwire {

namespace {

constexpr std::size_t most_scans = 20;  ///< of an instant that are told

/// Collects what an expression reads.
class OperandReader {
  public:
    OperandReader(const Evolution& evolution, const EvolutionState& state,
                  const InputValues& inputs)
        : evolution_(evolution), grafcet_(evolution.grafcet()), state_(state), inputs_(inputs) {}

    std::vector<OperandValue> operands_of(ExprId id) {
        found_.clear();
        collect(id);
        return std::move(found_);
    }

  private:
    /// Edges and time conditions are read as one; of an edge that is 0 it helps to see what it is
    /// the edge of.
    void collect(ExprId id) {
        const Expressions& expressions = grafcet_.expressions;
        switch (expressions.kind(id)) {
            case ExprKind::constant:
                return;
            case ExprKind::variable:
                add(id);
                return;
            case ExprKind::rise:
            case ExprKind::fall:
                add(id);
                if (!evolution_.value(id, state_, {inputs_})) {
                    collect(expressions.operands(id).front());
                }
                return;
            case ExprKind::time_condition:
                add(id, state_.due[expressions.ordinal(id)]);
                return;
            case ExprKind::comparison:
                collect_counters(expressions.comparison_of(id).left);
                collect_counters(expressions.comparison_of(id).right);
                return;
            default:
                for (const ExprId operand : expressions.operands(id)) collect(operand);
        }
    }

    void collect_counters(const Sum& sum) {
        for (const SumTerm& term : sum) {
            if (term.counter == SumTerm::no_counter) continue;
            const Counter& counter = grafcet_.counters[CounterId{term.counter}];
            add({counter.name, state_.counters[term.counter]});
        }
    }

    void add(ExprId id, Time due = never) {
        const bool value = evolution_.value(id, state_, {inputs_});
        add({write_expression(grafcet_, grafcet_.expressions, id), value ? 1 : 0, due});
    }
    void add(OperandValue operand) {
        const bool is_known =
            std::any_of(found_.begin(), found_.end(),
                        [&](const OperandValue& other) { return other.name == operand.name; });
        if (!is_known) found_.push_back(std::move(operand));
    }

    const Evolution& evolution_;
    const Grafcet& grafcet_;
    const EvolutionState& state_;
    const InputValues& inputs_;
    std::vector<OperandValue> found_;
};

/// The transitions enabled in a state, and what their conditions make of it.
std::vector<EnabledTransition> enabled_in(const Evolution& evolution, const EvolutionState& state,
                                          const InputValues& inputs) {
    const Grafcet& grafcet = evolution.grafcet();
    OperandReader reader(evolution, state, inputs);
    std::vector<EnabledTransition> result;
    for (std::size_t i = 0; i < grafcet.transitions.size(); ++i) {
        const TransitionId id = grafcet.transitions.id_at(i);
        const Transition& transition = grafcet.transitions[id];
        const auto steps = grafcet.preceding(transition);
        if (!std::all_of(steps.begin(), steps.end(),
                         [&](StepId step) { return state.situation.test(index_of(step)); })) {
            continue;
        }
        result.push_back({id, evolution.value(transition.condition, state, {inputs}),
                          !state.may_evolve.test(index_of(transition.graph)),
                          reader.operands_of(transition.condition)});
    }
    return result;
}

/// The active steps before and behind transitions that are cleared at once.
std::vector<StepId> kept_steps(const Grafcet& grafcet, const std::vector<TransitionId>& cleared) {
    BitTable preceding(grafcet.steps.size());
    BitTable following(grafcet.steps.size());
    for (const TransitionId id : cleared) {
        const Transition& transition = grafcet.transitions[id];
        for (const StepId step : grafcet.preceding(transition)) preceding.set(index_of(step));
        for (const StepId step : grafcet.following(transition)) following.set(index_of(step));
    }
    std::vector<StepId> kept;
    for_each_common_bit(preceding, following,
                        [&](std::size_t step) { kept.push_back(grafcet.steps.id_at(step)); });
    return kept;
}

std::vector<TimeConditionChange> time_changes(const Grafcet& grafcet, const EvolutionState& before,
                                              const EvolutionState& after) {
    using Kind = TimeConditionChange::Kind;
    std::vector<TimeConditionChange> changes;
    const auto& conditions = grafcet.expressions.time_conditions();
    for (std::size_t i = 0; i < conditions.size(); ++i) {
        const bool value = after.time_values.test(i);
        if (value != before.time_values.test(i)) {
            changes.push_back({conditions[i], value ? Kind::becomes_1 : Kind::becomes_0});
        } else if (after.due[i] != never && before.due[i] == never) {
            changes.push_back({conditions[i], Kind::delay_begins, after.due[i]});
        } else if (after.due[i] == never && before.due[i] != never) {
            changes.push_back({conditions[i], Kind::delay_is_dropped});
        }
    }
    return changes;
}

bool control_input(const Grafcet& grafcet, const InputValues& inputs, ControlInput input) {
    return inputs[grafcet.inputs.size() + static_cast<std::size_t>(input)] != 0;
}

/// One scan.
ScanStory tell_scan(const Evolution& evolution, EvolutionState& state, const InputValues& inputs,
                    Time at) {
    const Grafcet& grafcet = evolution.grafcet();
    EvolutionState before = state;
    ScanStory story;
    evolution.scan(state, {inputs}, at, &story.record);
    story.before = before.situation;
    story.situation = state.situation;
    story.init = control_input(grafcet, inputs, ControlInput::init);
    story.au_dur = control_input(grafcet, inputs, ControlInput::au_dur);
    story.kept = kept_steps(grafcet, story.record.cleared);
    story.times = time_changes(grafcet, before, state);
    story.changes = before.situation != state.situation || before.vars != state.vars ||
                    before.counters != state.counters ||
                    before.stored_outputs != state.stored_outputs ||
                    before.may_evolve != state.may_evolve || !story.times.empty() ||
                    !story.record.cleared.empty();
    before.edges = state.edges;  // those that the conditions have read
    story.enabled = enabled_in(evolution, before, inputs);
    return story;
}

/// Scans until the situation is stable, or comes back; false where there is no stable one.
void tell_settling(const Evolution& evolution, EvolutionState& state, const InputValues& inputs,
                   Time at, InstantStory& story) {
    EvolutionState ahead = state;
    SettleResult settled = evolution.settle(ahead, {inputs}, at);
    story.is_stable = settled.stable;
    story.changing = std::move(settled.changing);
    const std::size_t told = std::min<std::size_t>(settled.repetitions, most_scans);
    story.untold = settled.repetitions - told;
    for (std::size_t i = 0; i < told; ++i) {
        ScanStory scan = tell_scan(evolution, state, inputs, at);
        if (scan.changes) story.scans.push_back(std::move(scan));
    }
    state = std::move(ahead);
}

void tell_end(const Evolution& evolution, EvolutionState state, const InputValues& inputs,
              InstantStory& story) {
    const Grafcet& grafcet = evolution.grafcet();
    story.situation = state.situation;
    story.outputs = evolution.outputs(state, {inputs});
    story.vars = BitTable(grafcet.vars.size());
    for (std::size_t i = 0; i < grafcet.vars.size(); ++i) {
        story.vars.assign(i, evolution.var(grafcet.vars.id_at(i), state, {inputs}));
    }
    story.counters = state.counters;
    story.init = control_input(grafcet, inputs, ControlInput::init);
    story.au_doux = control_input(grafcet, inputs, ControlInput::au_doux);
    state.edges = BitTable(state.edges.size());
    story.enabled = enabled_in(evolution, state, inputs);
    for (std::size_t i = 0; i < grafcet.orders.size(); ++i) {
        const OrderId order = grafcet.orders.id_at(i);
        if (state.situation.test(index_of(grafcet.orders[order].step))) {
            story.orders.push_back(order);
        }
    }
}

/// The first instant has nothing before it: all inputs were 0.
std::vector<Stimuli::Assignment> changed_inputs(const InputValues& before,
                                                const InputValues& after) {
    std::vector<Stimuli::Assignment> changed;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const bool was = !before.empty() && before[i] != 0;
        const bool is = after[i] != 0;
        if (was != is) changed.push_back({static_cast<std::uint32_t>(i), is});
    }
    return changed;
}

}  // namespace

Time EvolutionUnderWay::next_delay_end() const {
    if (!state || state->due.empty()) return never;
    return *std::min_element(state->due.begin(), state->due.end());
}

InstantStory tell_instant(const Evolution& evolution, EvolutionUnderWay& run,
                          const InputValues& inputs, Time at, bool by_scans) {
    InstantStory story;
    story.at = at;
    story.last = at;
    story.by_scans = by_scans;
    story.is_first = !run.state;
    story.inputs = changed_inputs(run.inputs, inputs);
    if (!run.state) {
        run.state = evolution.start({inputs});
    } else if (!by_scans) {
        const EvolutionState before = *run.state;
        evolution.end_delays(*run.state, {inputs}, at);
        story.ended = time_changes(evolution.grafcet(), before, *run.state);
    }
    EvolutionState& state = *run.state;
    if (by_scans) {
        ScanStory scan = tell_scan(evolution, state, inputs, at);
        if (scan.changes) story.scans.push_back(std::move(scan));
    } else {
        tell_settling(evolution, state, inputs, at, story);
    }
    tell_end(evolution, state, inputs, story);
    story.is_quiet = !story.is_first && story.inputs.empty() && story.ended.empty() &&
                     story.scans.empty() && story.outputs == run.outputs;
    run.inputs = inputs;
    run.outputs = story.outputs;
    run.now = at;
    return story;
}

void add_story(std::vector<InstantStory>& stories, InstantStory story) {
    if (story.is_quiet && !stories.empty() && stories.back().is_quiet) {
        ++stories.back().repeated;
        stories.back().last = story.at;
    } else {
        stories.push_back(std::move(story));
    }
}

ToldRun tell_run(const Grafcet& grafcet, const Stimuli& stimuli, std::optional<Time> period) {
    const Evolution evolution(grafcet);
    StimuliPlayer player(stimuli, grafcet.all_input_count());
    EvolutionUnderWay run;
    RunRecord record(grafcet);
    std::vector<InstantStory> stories;
    for (Time now = 0;;) {
        const bool any = player.advance(now);
        if (any || now == 0) record.check_assumptions(now, player.inputs());
        InstantStory story = tell_instant(evolution, run, player.inputs(), now, period.has_value());
        if (story.is_stable) {
            record.add_row(now, evolution, *run.state, player.inputs());
        } else {
            record.end_unstable(now, story.changing);
        }
        const bool is_last =
            !story.is_stable || now == stimuli.end || (period && *period > stimuli.end - now);
        add_story(stories, std::move(story));
        if (is_last) return {record.take(), std::move(stories)};
        now = period ? now + *period
                     : std::min({stimuli.end, player.next_change(), run.next_delay_end()});
    }
}

}  // namespace grafwire
