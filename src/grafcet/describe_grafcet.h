#pragma once

#include <string>

#include "grafcet/grafcet.h"
#include "text/message.h"

namespace grafwire {

/// What `grafwire info` prints: name and title, sizes, the graphs with their steps and transitions,
/// macro-steps, enclosures, and the forcing hierarchy as an indented tree.
std::string describe_grafcet(const Grafcet& grafcet, Language language);

}  // namespace grafwire
