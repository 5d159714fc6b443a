// What was applied is kept as stimuli: a run over them goes through the same instants.

#include "story/stepped_run.h"

#include <utility>

#include "trace/input_values.h"

namespace grafwire {

namespace {

/// Of one step; a longer way is gone in several.
constexpr std::size_t most_instants = 100'000;

}  // namespace

SteppedRun::SteppedRun(const Grafcet& grafcet, std::optional<Time> period)
    : grafcet_(grafcet), evolution_(grafcet), period_(period) {
    moment_.inputs.assign(grafcet.all_input_count(), 0);
}

Time SteppedRun::next_instant() const {
    if (period_) return next_scan();
    return has_begun() ? moment_.run.next_delay_end() : Time{0};
}

bool SteppedRun::advance(Time to, const std::vector<Stimuli::Assignment>& assignments,
                         bool has_instant, const std::function<void(InstantStory)>& tell) {
    Moment before = moment_;
    std::size_t count = 0;
    while (next_instant() < to && !is_stuck() && count++ < most_instants) {
        tell(do_instant(next_instant(), !has_begun()));
    }
    const bool is_done = count <= most_instants;
    if (is_done && !is_stuck()) {
        for (const Stimuli::Assignment& set : assignments) moment_.inputs[set.input] = set.value;
        const bool is_scan = period_ && next_scan() == to && (has_instant || to != before.now);
        if (is_scan || !period_) tell(do_instant(to, has_instant));
        moment_.now = to;
    }
    past_.push_back(std::move(before));
    return is_done;
}

/// `is_asked`: the user has named the instant, so it is one of the stimuli even where no input
/// changes; those at which delays end come by themselves.
InstantStory SteppedRun::do_instant(Time at, bool is_asked) {
    InstantStory story =
        tell_instant(evolution_, moment_.run, moment_.inputs, at, period_.has_value());
    if (!story.inputs.empty() || (is_asked && !period_)) {
        changes_.push_back({at, story.inputs});
    }
    moment_.change_count = changes_.size();
    moment_.now = at;
    moment_.last = story;
    return story;
}

void SteppedRun::go_back() {
    moment_ = std::move(past_.back());
    past_.pop_back();
    changes_.resize(moment_.change_count);
}

Stimuli SteppedRun::stimuli() const {
    Stimuli stimuli{changes_, moment_.now};
    if (!period_ || !has_unread_inputs()) return stimuli;
    const InputValues all_0(moment_.inputs.size(), 0);
    const InputValues& before = has_begun() ? moment_.run.inputs : all_0;
    Stimuli::Change change{next_scan(), {}};
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] == moment_.inputs[i]) continue;
        change.assignments.push_back({static_cast<std::uint32_t>(i), moment_.inputs[i] != 0});
    }
    stimuli.end = change.at;
    if (!change.assignments.empty()) stimuli.changes.push_back(std::move(change));
    return stimuli;
}

std::vector<std::size_t> SteppedRun::broken_assumptions() const {
    std::vector<std::size_t> broken;
    for (std::size_t i = 0; i < grafcet_.assumptions.size(); ++i) {
        if (!assumption_holds(grafcet_, i, moment_.inputs)) broken.push_back(i);
    }
    return broken;
}

}  // namespace grafwire
