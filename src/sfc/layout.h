#pragma once

#include <cstdint>
#include <vector>

#include "sfc/chart.h"

namespace grafwire::sfc {

/// Where the steps and transitions of a sequential function chart stand: levels from top to bottom,
/// columns from left to right, graphs side by side. A link that leads up again is a
/// jump; all others lead to a lower level.
struct Layout {
    struct Place {
        int column = 0;
        int level = 0;  ///< of a transition: that of the lowest step before it
    };
    struct Link {
        TransitionId transition{};
        StepId step{};
        bool is_jump = false;
    };
    std::vector<Place> steps;
    std::vector<Place> transitions;
    std::vector<std::vector<TransitionId>> out_of;  ///< per step: the transitions that follow it
    std::vector<std::vector<Link>> into;            ///< per step, in the order of the transitions
    int columns = 0;
};

Layout layout_of(const Chart& chart);

}  // namespace grafwire::sfc
