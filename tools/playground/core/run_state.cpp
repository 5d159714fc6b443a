// A run as values: names as the drawing has them, times in milliseconds, of gates in nanoseconds.

#include "core/run_state.h"

#include <algorithm>
#include <string>

#include "core/script.h"
#include "grafcet/write_grafcet.h"
#include "story/write_story.h"
#include "workflow/runs.h"

namespace grafwire::playground {

namespace {

Json time_or_null(Time time) {
    return time == never ? Json() : Json(in_milliseconds(time));
}

/// Names and words of one run.
class RunWriter {
  public:
    RunWriter(const LiveRun& run, Language language)
        : run_(run), grafcet_(run.chart().grafcet), language_(language) {}

    Json instant(const LiveInstant& item) const {
        Json answer{{"at_ms", in_milliseconds(item.at())}};
        if (item.story) add_story(answer, *item.story);
        if (item.gates) answer["gates"] = gates(*item.gates);
        return answer;
    }

    Json gates(const GateInstant& item) const {
        Json changes = Json::array();
        for (const GateInstant::Change& change : item.changes) {
            changes.push_back({static_cast<double>(change.after) / static_cast<double>(nanosecond),
                               run_.netlist()->names[change.net],
                               std::string(1, digit_of(change.value))});
        }
        return Json{{"settled", item.is_settled},
                    {"oscillating", nets(item.oscillating)},
                    {"changes", std::move(changes)}};
    }

    Json nets(const std::vector<NetId>& ids) const {
        Json list = Json::array();
        for (const NetId net : ids) list.push_back(run_.netlist()->names[net]);
        return list;
    }

    Json inputs(const InputValues& values) const {
        Json object = Json::object();
        for (std::size_t i = 0; i < values.size(); ++i) {
            object[std::string(input_name(grafcet_, i))] = static_cast<int>(values[i]);
        }
        return object;
    }
    /// The steps that are active.
    Json situation(const BitTable& situation) const {
        Json list = Json::array();
        for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
            if (i < situation.size() && situation.test(i)) list.push_back(step_name(i));
        }
        return list;
    }
    /// By name, those of the reference.
    template <typename Parts>
    Json bits(const Parts& parts, const BitTable& values) const {
        Json object = Json::object();
        for (std::size_t i = 0; i < parts.size(); ++i) {
            object[parts[parts.id_at(i)].name] = i < values.size() && values.test(i) ? 1 : 0;
        }
        return object;
    }
    /// Transitions that are enabled, or those among them that are clearable.
    Json enabled(const std::vector<EnabledTransition>& transitions, bool clearable) const {
        Json list = Json::array();
        for (const EnabledTransition& item : transitions) {
            const bool is_clearable = item.condition && !item.is_frozen;
            if (!clearable || is_clearable) list.push_back(transition_name(item.transition));
        }
        return list;
    }
    Json counters(const std::vector<std::int64_t>& values) const {
        Json object = Json::object();
        for (std::size_t i = 0; i < grafcet_.counters.size(); ++i) {
            const Counter& counter = grafcet_.counters[grafcet_.counters.id_at(i)];
            object[counter.name] = i < values.size() ? values[i] : counter.low;
        }
        return object;
    }
    Json timers() const {
        Json list = Json::array();
        const auto& conditions = grafcet_.expressions.time_conditions();
        const auto& state = run_.reference().run().state;
        for (std::size_t i = 0; i < conditions.size(); ++i) {
            list.push_back(
                {{"condition", write_expression(grafcet_, grafcet_.expressions, conditions[i])},
                 {"value", state && state->time_values.test(i) ? 1 : 0},
                 {"due_ms", state ? time_or_null(state->due[i]) : Json()}});
        }
        return list;
    }
    Json warnings() const {
        Json list = Json::array();
        for (const std::size_t broken : run_.reference().broken_assumptions()) {
            list.push_back(
                broken_assumption_text(grafcet_, {run_.reference().now(), broken}).in(language_));
        }
        return list;
    }

  private:
    const std::string& step_name(std::size_t index) const {
        return grafcet_.steps[grafcet_.steps.id_at(index)].name;
    }
    std::string transition_name(TransitionId id) const {
        return '(' + grafcet_.transitions[id].name + ')';
    }

    void add_story(Json& answer, const InstantStory& story) const {
        answer["last_ms"] = in_milliseconds(story.last);
        Json changed = Json::object();
        for (const Stimuli::Assignment& item : story.inputs) {
            changed[std::string(input_name(grafcet_, item.input))] = item.value ? 1 : 0;
        }
        answer["inputs"] = std::move(changed);
        Json scans = Json::array();
        for (const ScanStory& item : story.scans) scans.push_back(scan(item));
        answer["scans"] = std::move(scans);
        answer["stable"] = story.is_stable;
        answer["changing"] = story.changing;
        answer["situation"] = situation(story.situation);
        answer["outputs"] = bits(grafcet_.outputs, story.outputs);
        answer["enabled"] = enabled(story.enabled, false);
        answer["clearable"] = enabled(story.enabled, true);
        answer["rules"] = rules(story);
        answer["text"] = write_story(grafcet_, story, language_);
    }

    Json scan(const ScanStory& item) const {
        Json cleared = Json::array();
        for (const TransitionId id : item.record.cleared) cleared.push_back(transition_name(id));
        Json activated = Json::array();
        Json deactivated = Json::array();
        for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
            const bool was = item.before.test(i);
            const bool is = item.situation.test(i);
            if (is && !was) activated.push_back(step_name(i));
            if (was && !is) deactivated.push_back(step_name(i));
        }
        Json kept = Json::array();
        for (const StepId id : item.kept) kept.push_back(grafcet_.steps[id].name);
        return Json{{"cleared", std::move(cleared)},
                    {"activated", std::move(activated)},
                    {"deactivated", std::move(deactivated)},
                    {"kept", std::move(kept)},
                    {"situation", situation(item.situation)}};
    }

    /// The rules of IEC 60848 that the words speak of.
    static Json rules(const InstantStory& story) {
        bool is_used[6] = {};
        is_used[1] = story.is_first;
        for (const ScanStory& item : story.scans) {
            const std::size_t cleared = item.record.cleared.size();
            is_used[2] |= cleared > 0;
            is_used[3] |= cleared > 0;
            is_used[4] |= cleared > 1;
            is_used[5] |= !item.kept.empty();
        }
        Json list = Json::array();
        for (int rule = 1; rule <= 5; ++rule) {
            if (is_used[rule]) list.push_back(rule);
        }
        return list;
    }

    const LiveRun& run_;
    const Grafcet& grafcet_;
    Language language_;
};

Json gates_state(const LiveRun& run, const RunWriter& writer) {
    const Netlist& netlist = *run.netlist();
    Json values = Json::object();
    for (std::size_t i = 0; i < netlist.net_count(); ++i) {
        const auto net = static_cast<NetId>(i);
        values[std::string(netlist.names[net])] = std::string(1, digit_of(run.value(net)));
    }
    const std::vector<std::string> differences = run.differences();
    return Json{{"values", std::move(values)},
                {"settled", run.gates_are_settled()},
                {"oscillating", writer.nets(run.oscillating())},
                {"agrees", differences.empty() && run.gates_are_settled()},
                {"differs", differences}};
}

std::string story_of(const LiveRun& run, const std::vector<LiveInstant>& instants,
                     Language language) {
    std::vector<InstantStory> stories;
    for (const LiveInstant& item : instants) {
        if (item.story) add_story(stories, *item.story);
    }
    return write_stories(run.chart().grafcet, stories, language);
}

}  // namespace

Json state_answer(const Runs::OpenRun& open, const std::vector<LiveInstant>& instants) {
    const LiveRun& run = *open.run;
    const Grafcet& grafcet = run.chart().grafcet;
    const SteppedRun& reference = run.reference();
    const RunWriter writer(run, open.language);
    static const InstantStory nothing;
    const InstantStory& last = reference.last() ? *reference.last() : nothing;
    Json answer{{"run", open.number},
                {"now_ms", in_milliseconds(reference.now())},
                {"begun", reference.has_begun()},
                {"stable", last.is_stable},
                {"changing", last.changing},
                {"situation", writer.situation(last.situation)},
                {"enabled", writer.enabled(last.enabled, false)},
                {"clearable", writer.enabled(last.enabled, true)},
                {"inputs", writer.inputs(reference.inputs())},
                {"outputs", writer.bits(grafcet.outputs, last.outputs)},
                {"vars", writer.bits(grafcet.vars, last.vars)},
                {"counters", writer.counters(last.counters)},
                {"timers", writer.timers()},
                {"next_ms", time_or_null(reference.next_instant())},
                {"can_back", reference.can_go_back()},
                {"warnings", writer.warnings()}};
    Json list = Json::array();
    for (const LiveInstant& item : instants) list.push_back(writer.instant(item));
    answer["instants"] = std::move(list);
    answer["story"] = story_of(run, instants, open.language);
    if (run.netlist() != nullptr) answer["gates"] = gates_state(run, writer);
    return answer;
}

Json power_up_answer(const LiveRun& run) {
    return RunWriter(run, Language::english).gates(run.power_up());
}

}  // namespace grafwire::playground
