// Random runs: what is told of a run is what the run does, and the reasons given are the reasons.

#include <doctest/doctest.h>

#include <algorithm>

#include "evolution/run.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "story/instant_causes.h"
#include "story/instant_story.h"

namespace grafwire::testing {

namespace {

/// A transition is cleared if it is enabled, its condition is 1, its graph may evolve, and Init is
/// not 1.
bool reasons_hold(const ScanStory& scan) {
    std::vector<TransitionId> due;
    for (const EnabledTransition& enabled : scan.enabled) {
        if (enabled.condition && !enabled.is_frozen && !scan.init) {
            due.push_back(enabled.transition);
        }
    }
    return due == scan.record.cleared;
}

/// Each scan begins where the one before it ended.
bool scans_follow(const InstantStory& story) {
    const BitTable* before = nullptr;
    for (const ScanStory& scan : story.scans) {
        if (before != nullptr && scan.before != *before) return false;
        before = &scan.situation;
    }
    return before == nullptr || !story.is_stable || story.untold > 0 || *before == story.situation;
}

/// Whether a row of the trace, from its first step on, is how the instant ends.
bool ends_as_row(const InstantStory& story, const std::int64_t* row) {
    const auto has_bits = [&](const BitTable& bits) {
        for (std::size_t i = 0; i < bits.size(); ++i) {
            if (bits.test(i) != (*row++ != 0)) return false;
        }
        return true;
    };
    return has_bits(story.situation) && has_bits(story.outputs) && has_bits(story.vars) &&
           std::equal(story.counters.begin(), story.counters.end(), row);
}

std::string fault_of(const RandomCase& random_case, std::optional<Time> period) {
    const auto chart = read_grafcet(random_case.chart);
    const auto given = chart ? read_stimuli(random_case.stimuli, *chart) : std::nullopt;
    if (!given) return "it cannot be read";
    const Grafcet& grafcet = *chart;
    const Stimuli& stimuli = *given;
    const RunResult run =
        period ? run_scans(grafcet, stimuli, *period) : run_until_stable(grafcet, stimuli);
    const auto [result, stories] = tell_run(grafcet, stimuli, period);
    if (write_csv(result.trace) != write_csv(run.trace)) return "another trace";
    if (result.unstable_at != run.unstable_at || result.changing != run.changing ||
        !(result.broken_assumptions == run.broken_assumptions)) {
        return "another result";
    }
    std::size_t row = 0;
    for (const InstantStory& story : stories) {
        if (!std::all_of(story.scans.begin(), story.scans.end(), reasons_hold)) {
            return "a reason is wrong";
        }
        if (!scans_follow(story)) return "scans do not follow each other";
        if (!story.is_stable) {
            if (run.unstable_at != story.at || run.changing != story.changing) {
                return "unstable otherwise";
            }
            continue;
        }
        for (std::size_t i = 0; i <= story.repeated; ++i, ++row) {
            if (row == run.trace.row_count()) return "too many instants";
            const Time at = run.trace.times[row];
            if (at < story.at || at > story.last) return "another time";
            const std::int64_t* values = run.trace.values.data() + row * run.trace.columns.size() +
                                         grafcet.all_input_count();
            if (!ends_as_row(story, values)) return "another end";
        }
    }
    return row == run.trace.row_count() ? "" : "too few instants";
}

/// What comes after a stable situation has a cause, and causes are among what has changed.
std::string fault_of_causes(const RandomCase& random_case) {
    const auto chart = read_grafcet(random_case.chart);
    const auto given = chart ? read_stimuli(random_case.stimuli, *chart) : std::nullopt;
    if (!given) return "it cannot be read";
    const std::vector<InstantStory> stories = tell_run(*chart, *given, std::nullopt).stories;
    const std::vector<InstantCauses> all = causes_in(*chart, stories);
    for (std::size_t i = 1; i < stories.size() && stories[i].is_stable; ++i) {
        const InstantStory& story = stories[i];
        const InstantStory& before = stories[i - 1];
        const auto found = std::find_if(all.begin(), all.end(), [&](const InstantCauses& causes) {
            return causes.at == story.at;
        });
        const bool has_changed =
            story.situation != before.situation || story.outputs != before.outputs;
        if (found == all.end()) {
            if (has_changed && story.untold == 0) return "no cause";
            continue;
        }
        if (found->ended.size() > story.ended.size()) return "a delay that has not ended";
        for (const std::size_t input : found->inputs) {
            if (std::none_of(story.inputs.begin(), story.inputs.end(),
                             [&](const auto& set) { return set.input == input; })) {
                return "an input that has not changed";
            }
        }
    }
    return "";
}

}  // namespace

TEST_CASE("a change has a cause") {
    check_property(fault_of_causes, {}, 63'000, 300);
}

TEST_CASE("a run until stable is told as it is") {
    check_property([](const RandomCase& random) { return fault_of(random, std::nullopt); }, {},
                   61'000, 300);
}

TEST_CASE("a run scan by scan is told as it is") {
    check_property([](const RandomCase& random) { return fault_of(random, 7 * millisecond); }, {},
                   62'000, 200);
}

}  // namespace grafwire::testing
