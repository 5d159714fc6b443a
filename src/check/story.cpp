#include "check/story.h"

#include <fmt/format.h>

#include <algorithm>

#include "evolution/run.h"

namespace grafwire {

namespace {

constexpr std::size_t most_scans = 8;

/// The inputs as the stimuli set them, moment after moment.
class InputsOverTime {
  public:
    InputsOverTime(const Grafcet& grafcet, const Stimuli& stimuli)
        : stimuli_(stimuli), values_(grafcet.all_input_count(), 0) {}

    /// At a moment not before the last one asked for.
    const InputValues& at(Time moment) {
        const auto& changes = stimuli_.changes;
        for (; next_ < changes.size() && changes[next_].at <= moment; ++next_) {
            for (const auto& set : changes[next_].assignments) values_[set.input] = set.value;
        }
        return values_;
    }

  private:
    const Stimuli& stimuli_;
    InputValues values_;
    std::size_t next_ = 0;
};

}  // namespace

void Story::tell_changes() {
    const Time last = witness_.stimuli.end;
    text_ += fmt::format("{} {} ms", choose("At", "À"), format_milliseconds(last));
    const auto& changes = witness_.stimuli.changes;
    std::vector<std::string> set;
    if (!changes.empty() && changes.back().at == last) {
        for (const Stimuli::Assignment& assignment : changes.back().assignments) {
            set.push_back(fmt::format("{}={}", input_name(grafcet_, assignment.input),
                                      assignment.value ? 1 : 0));
        }
    }
    text_ += set.empty() ? std::string(choose(", no input changes", ", aucune entrée ne change"))
                         : fmt::format("{} {}", choose(":", " :"), fmt::join(set, " "));
    text_ += ".\n";
}

std::string Story::situation_text(const BitTable& situation) const {
    std::vector<std::string> active;
    for (std::size_t i = 0; i < situation.size(); ++i) {
        if (situation.test(i)) {
            active.push_back("X" + grafcet_.steps[grafcet_.steps.id_at(i)].name);
        }
    }
    if (active.empty()) return std::string(choose("no step", "aucune étape"));
    return fmt::format("{}", fmt::join(active, " "));
}

std::string Story::transition_text(TransitionId id) const {
    const Transition& transition = grafcet_.transitions[id];
    const auto names = [&](std::span<const StepId> steps) {
        std::vector<std::string> list;
        for (const StepId step : steps) list.push_back(grafcet_.steps[step].name);
        return fmt::format("{}", fmt::join(list, ", "));
    };
    const std::string before = names(grafcet_.preceding(transition));
    return fmt::format("({}) {}{}-> {}", transition.name, before, before.empty() ? "" : " ",
                       names(grafcet_.following(transition)));
}

/// One scan, if it does something; false if it was the last of its instant.
bool Story::tell_scan(const Evolution& evolution, EvolutionState& state, const InputValues& inputs,
                      Time at, const std::string& label) {
    const auto cleared = evolution.cleared_by_scan(state, {inputs}, at);
    const EvolutionState before = state;
    evolution.scan(state, {inputs}, at);
    if (before.situation != state.situation || !cleared.empty()) {
        std::vector<std::string> names;
        for (const TransitionId id : cleared) names.push_back(transition_text(id));
        text_ += fmt::format("  {}{} {}{} -> {}\n", label, choose(":", " :"),
                             names.empty() ? "" : choose("clears ", "franchit "),
                             names.empty() ? std::string(choose("orders", "ordres"))
                                           : fmt::format("{}", fmt::join(names, "; ")),
                             situation_text(state.situation));
    }
    return !Evolution::is_settled(before, state);
}

/// Up to the last instant of a run until stable, and the scans of that one.
void Story::follow_instants(const Evolution& evolution) {
    const RunResult run = run_until_stable(grafcet_, witness_.stimuli);
    InputsOverTime inputs(grafcet_, witness_.stimuli);
    EvolutionState state;
    for (std::size_t row = 0; row < run.trace.row_count(); ++row) {
        const Time at = run.trace.times[row];
        const InputValues& values = inputs.at(at);
        if (row == 0) {
            state = evolution.start({values});
        } else {
            evolution.end_delays(state, {values}, at);
        }
        if (row + 1 < run.trace.row_count()) {
            evolution.settle(state, {values}, at);
            continue;
        }
        text_ +=
            fmt::format("  {}: {}\n", choose("before", "avant "), situation_text(state.situation));
        for (std::size_t scan = 1; scan <= most_scans; ++scan) {
            const std::string label = fmt::format("{} {}", choose("scan", "cycle"), scan);
            if (!tell_scan(evolution, state, values, at, label)) break;
        }
    }
}

/// The last scans of a run scan by scan: those since the inputs changed, but not too many.
void Story::follow_scans(const Evolution& evolution) {
    const Time period = witness_.scan_period;
    const auto& changes = witness_.stimuli.changes;
    const Time change = changes.empty() ? 0 : changes.back().at;
    const Time last = witness_.stimuli.end / period;
    const Time first = std::max<Time>(
        {0, (change + period - 1) / period, last - static_cast<Time>(most_scans) + 1});
    InputsOverTime inputs(grafcet_, witness_.stimuli);
    EvolutionState state = evolution.start({inputs.at(0)});
    for (Time scan = 0; scan <= last; ++scan) {
        const InputValues& values = inputs.at(scan * period);
        if (scan < first) {
            evolution.scan(state, {values}, scan * period);
            continue;
        }
        if (scan == first) {
            text_ += fmt::format("  {}: {}\n", choose("before", "avant "),
                                 situation_text(state.situation));
        }
        const Time now = scan * period;
        tell_scan(evolution, state, values, now,
                  fmt::format("{} {} ms", choose("scan at", "cycle à"), format_milliseconds(now)));
    }
}

void Story::tell_reference() {
    text_ += choose("The reference:\n", "La référence :\n");
    const Evolution evolution(grafcet_);
    if (witness_.scan_period == 0) {
        follow_instants(evolution);
    } else {
        follow_scans(evolution);
    }
}

void Story::tell_difference(std::string_view other_side) {
    text_ += choose("Where they part:\n", "Où ils se séparent :\n");
    const auto digit = [](Logic value) {
        return value == Logic::unknown ? 'x' : value == Logic::one ? '1' : '0';
    };
    for (const Witness::Value& value : witness_.values) {
        if (value.expected == value.got) continue;
        text_ += fmt::format("  {}{} {} {}, {} {}\n", value.name, choose(":", " :"),
                             choose("the reference gives", "la référence donne"),
                             digit(value.expected), other_side, digit(value.got));
    }
}

}  // namespace grafwire
