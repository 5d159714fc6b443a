#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "story/instant_story.h"

namespace grafwire {

/// What had a part in what an instant changed, of what changed outside: inputs that were read by
/// the conditions of cleared transitions, of stored actions that were run, or of continuous actions
/// whose output has changed; modes; delays that ended.
struct InstantCauses {
    Time at = 0;
    std::vector<std::size_t> inputs;  ///< as input_name() numbers them
    std::vector<std::string> ended;   ///< the time conditions, as written
};

/// Of a whole run, the instants or scans that have such causes. Of the first instant there are
/// none: what is there has always been there.
std::vector<InstantCauses> causes_in(const Grafcet& grafcet,
                                     const std::vector<InstantStory>& stories);

}  // namespace grafwire
