// From a path of scans to stimuli and a period.
//
// Scans follow each other at 0, T, 2T, … A delay of length d that begins at scan b has fallen due
// by scan i, and not by an earlier one, where
//
//     (i - b) T >= d      it has fallen due by scan i
//     (i - b) T <  d      it is still running after scan i
//
// so every path bounds T from below and from above, and any period within the bounds will do: one
// that people like to read is taken.

#include <algorithm>

#include "check/path.h"

namespace grafwire {

namespace {

struct Bounds {
    Time lowest = 1;
    Time highest = hour;
};

Time divided_up(Time length, std::size_t by) {
    const auto parts = static_cast<Time>(by);
    return (length + parts - 1) / parts;
}

Bounds bounds_of(const std::vector<PathStep>& path) {
    Bounds bounds;
    for (std::size_t i = 0; i < path.size(); ++i) {
        for (const RunningDelay& delay : path[i].running) {
            const Time share = divided_up(delay.length, i - delay.begun);
            if (delay.ends) {
                bounds.lowest = std::max(bounds.lowest, share);
            } else {
                bounds.highest = std::min(bounds.highest, share - 1);
            }
        }
    }
    // With a delay longer than an hour that ends in one scan the period is as long.
    if (bounds.highest == hour) bounds.highest = std::max(hour, bounds.lowest);
    return bounds;
}

/// The roundest within the bounds, 10 ms if it is.
Time readable_period(const Bounds& bounds) {
    const Time usual = 10 * millisecond;
    if (bounds.lowest <= usual && usual <= bounds.highest) return usual;
    for (Time unit = 100 * second; unit > 1; unit /= 10) {
        const Time period = (bounds.lowest + unit - 1) / unit * unit;
        if (period <= bounds.highest) return period;
    }
    return bounds.lowest;
}

}  // namespace

std::optional<ScanStimuli> scans_for(const Grafcet& grafcet, const Assumptions& assumptions,
                                     const std::vector<PathStep>& path, Time period) {
    const Bounds bounds = bounds_of(path);
    if (period != 0 ? period < bounds.lowest || period > bounds.highest
                    : bounds.lowest > bounds.highest) {
        return std::nullopt;
    }
    ScanStimuli scans;
    scans.period = period != 0 ? period : readable_period(bounds);
    InputValues previous(grafcet.all_input_count(), 0);
    for (const PathStep& step : path) {
        const auto values = assumptions.complete(step.inputs, previous);
        if (!values) return std::nullopt;
        std::vector<Stimuli::Assignment> changed = differences(previous, *values);
        if (!changed.empty() || scans.stimuli.changes.empty()) {
            scans.stimuli.changes.push_back({scans.stimuli.end, std::move(changed), {}});
        }
        previous = *values;
        scans.stimuli.end += scans.period;
    }
    scans.stimuli.end -= scans.period;
    return scans;
}

}  // namespace grafwire
