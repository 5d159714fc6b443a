#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "text/message.h"
#include "text/time.h"

namespace grafwire {

/// What the times of a timing diagram are.
enum class TimeScale : std::uint8_t {
    moments,      ///< those of a run, each written above its moment
    nanoseconds,  ///< since an instant, on an axis; a time before 0 is what was there before
};

/// A moment in words.
std::string moment_text(Time at, TimeScale scale, Language language);

/// The moments from number `first` up to `last`, excluded, side by side.
struct Strip {
    std::size_t first = 0;
    std::size_t last = 0;
    double end = 0;  ///< of its lines, from their beginning
};

/// Where moments stand.
struct MomentPlaces {
    std::vector<Strip> strips;
    std::vector<double> x;      ///< by moment, from the beginning of its strip
    double per_nanosecond = 0;  ///< 0 where time is not to scale
};

/// Moments of a run: to scale, in one strip, where the intervals allow it; else side by side.
/// `step`: what a moment takes at least; `room`: how wide a strip may be.
MomentPlaces place_moments(const std::vector<Time>& times, double step, double room);

/// Moments within an instant: to scale, in as many strips as it takes.
MomentPlaces place_on_axis(const std::vector<Time>& times, double room);

/// The times from 0 on that have a tick on the axis of a strip, at round numbers.
std::vector<Time> ticks_of(const MomentPlaces& places, const Strip& strip,
                           const std::vector<Time>& times);

}  // namespace grafwire
