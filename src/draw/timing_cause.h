#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "text/time.h"

namespace grafwire {

/// What began changes of a run, and the changes that followed from it. Columns are those of the
/// trace.
struct TimingCause {
    Time at = 0;                       ///< when it happened: the time of a row
    std::vector<std::size_t> columns;  ///< that changed
    std::vector<std::string> ended;    ///< delays that ended: the time conditions, as written
    struct Effect {
        std::size_t column = 0;
        Time at = 0;  ///< when it followed: the time of the same row, or of a later one
    };
    std::vector<Effect> effects;
};

}  // namespace grafwire
