#pragma once

#include <string>
#include <vector>

#include "draw/scene.h"
#include "draw/time_scale.h"
#include "draw/timing_cause.h"
#include "text/message.h"
#include "trace/trace.h"

namespace grafwire {

/// How a run is to be drawn.
struct TimingDrawing {
    std::string title;
    Paper paper = papers[0];
    Language language = Language::english;
    /// Another run in the same columns, such as that of a netlist: a signal that is not the same in
    /// both has a second line with its values there, `!` where they differ.
    const Trace* other = nullptr;
    /// Drawn as dotted lines from what changed to what followed; delays that ended stand below the
    /// time.
    std::vector<TimingCause> causes{};
    TimeScale scale = TimeScale::moments;
};

/// A run as teachers draw it: a line for each input, step, output and var, the values of counters
/// and the situation in boxes, a dashed line at each moment at which something changes. Time is to
/// scale where the intervals allow it; else the moments stand side by side, and the diagram says
/// so. Long runs are folded into strips, with the names before each. Control inputs that stay 0 are
/// left out. Within an instant, time has an axis below, and there is no situation.
std::vector<Sheet> draw_timing(const Trace& trace, const TimingDrawing& how);

}  // namespace grafwire
