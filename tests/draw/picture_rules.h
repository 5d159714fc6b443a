#pragma once

#include <string>
#include <vector>

#include "draw/picture.h"
#include "grafcet/grafcet.h"

namespace grafwire::testing {

// What a printed GRAFCET must be like, measured in the picture: IEC 60848, and what teachers expect
// of a sheet. Each rule says what breaks it, a line each.

using Faults = std::vector<std::string>;
std::string told(const Faults& faults);

/// Every step, macro-step, transition and action of the chart is there once, and nothing else is.
Faults missing_parts(const Grafcet& grafcet, const Picture& picture);
/// Every link of the chart is drawn, or cut with the name of where it leads.
Faults missing_links(const Grafcet& grafcet, const Picture& picture);
/// No text lies on another, on a line or on the edge of something else, and nothing is outside.
Faults crowded_texts(const Picture& picture);
/// Steps are as high as each other, not narrower than high, and the frame of an initial step is as
/// large as a step; actions stand right of their steps.
Faults wrong_steps(const Grafcet& grafcet, const Picture& picture);
/// Bars stand across their link, midway between two steps that follow each other; the name is left
/// of the bar, the condition right of it.
Faults wrong_bars(const Grafcet& grafcet, const Picture& picture);
/// The bars below one step stand at one height, and the steps below one transition.
Faults uneven_branches(const Grafcet& grafcet, const Picture& picture);
/// Both lines of simultaneous branches have the same ends, close to each other.
Faults wrong_double_lines(const Picture& picture);
/// Links are level or upright; one that leads up has an arrow, up.
Faults wrong_links(const Picture& picture);
/// No link passes through a step, an action or the bar of another.
Faults links_through_parts(const Picture& picture);
/// The places at which links cross that have nothing to do with each other.
std::size_t crossings(const Picture& picture);

/// All of the rules (crossings are allowed).
Faults all_faults(const Grafcet& grafcet, const Picture& picture);

}  // namespace grafwire::testing
