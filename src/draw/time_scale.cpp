// A run often waits for seconds between changes that are milliseconds apart; to scale, the changes
// would fall together on paper. So its scale is linear only while the longest interval is at most
// twenty times the shortest, and all of it fits one strip. Within an instant every interval is a
// few gate delays, and the scale is always linear.

#include "draw/time_scale.h"

#include <algorithm>

#include "draw/messages.h"
#include "text/shown_duration.h"

namespace grafwire {

namespace {

constexpr double tail = 1.3;  ///< behind the last moment
constexpr double widest_ratio = 20;
constexpr double axis_step = 1.2;   ///< of the shortest interval on an axis
constexpr double tick_pitch = 0.9;  ///< at least

/// The shortest and the longest way from a time to the next; there are two times or more.
struct Intervals {
    Time shortest = never;
    Time longest = 0;
};

Intervals intervals_of(const std::vector<Time>& times) {
    Intervals intervals;
    for (std::size_t i = 1; i < times.size(); ++i) {
        intervals.shortest = std::min(intervals.shortest, times[i] - times[i - 1]);
        intervals.longest = std::max(intervals.longest, times[i] - times[i - 1]);
    }
    return intervals;
}

/// Whether one strip has room to scale; then the places are entered.
bool place_to_scale(const std::vector<Time>& times, double step, double room,
                    MomentPlaces& places) {
    if (times.size() < 2) return false;
    const auto [shortest, longest] = intervals_of(times);
    if (shortest <= 0) return false;
    const double scale = step / static_cast<double>(shortest);
    const double whole = static_cast<double>(times.back() - times.front()) * scale;
    if (static_cast<double>(longest) > widest_ratio * static_cast<double>(shortest)) return false;
    if (whole + tail > room) return false;
    for (const Time at : times) places.x.push_back(static_cast<double>(at - times.front()) * scale);
    places.strips.push_back({0, times.size(), whole + tail});
    places.per_nanosecond = scale * nanosecond;
    return true;
}

}  // namespace

std::string moment_text(Time at, TimeScale scale, Language language) {
    if (scale == TimeScale::moments) return shown_duration(at).in(language);
    if (at < 0) return messages::draw::before.in(language);
    return messages::draw::nanoseconds(format_nanoseconds(at)).in(language);
}

MomentPlaces place_moments(const std::vector<Time>& times, double step, double room) {
    MomentPlaces places;
    if (place_to_scale(times, step, room, places)) return places;
    const auto per_strip = static_cast<std::size_t>(std::max(1.0, (room - tail) / step + 1));
    for (std::size_t first = 0; first < times.size(); first += per_strip) {
        const std::size_t last = std::min(first + per_strip, times.size());
        for (std::size_t i = first; i < last; ++i) {
            places.x.push_back(static_cast<double>(i - first) * step);
        }
        places.strips.push_back({first, last, places.x.back() + tail});
    }
    return places;
}

MomentPlaces place_on_axis(const std::vector<Time>& times, double room) {
    MomentPlaces places;
    const double scale = times.size() < 2
                             ? axis_step / nanosecond
                             : axis_step / static_cast<double>(intervals_of(times).shortest);
    places.per_nanosecond = scale * nanosecond;
    const auto width = [&](std::size_t from, std::size_t to) {
        return static_cast<double>(times[to] - times[from]) * scale;
    };
    for (std::size_t first = 0; first < times.size();) {
        std::size_t last = first;
        for (; last < times.size() && (last == first || width(first, last) + tail <= room);
             ++last) {
            places.x.push_back(width(first, last));
        }
        const double end =
            last < times.size() ? std::min(width(first, last), room) : places.x.back() + tail;
        places.strips.push_back({first, last, end});
        first = last;
    }
    return places;
}

std::vector<Time> ticks_of(const MomentPlaces& places, const Strip& strip,
                           const std::vector<Time>& times) {
    const double scale = places.per_nanosecond / nanosecond;
    Time pitch = 1;
    for (Time decade = 1; static_cast<double>(pitch) * scale < tick_pitch; decade *= 10) {
        for (const Time round : {decade, 2 * decade, 5 * decade}) {
            pitch = round;
            if (static_cast<double>(pitch) * scale >= tick_pitch) break;
        }
    }
    const Time from = std::max<Time>(0, times[strip.first]);
    const Time to = times[strip.first] + static_cast<Time>(strip.end / scale);
    std::vector<Time> ticks;
    for (Time at = (from + pitch - 1) / pitch * pitch; at <= to; at += pitch) ticks.push_back(at);
    return ticks;
}

}  // namespace grafwire
