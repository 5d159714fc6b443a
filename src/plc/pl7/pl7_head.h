#pragma once

#include <string>

#include "grafcet/grafcet.h"
#include "plc/pl7/pl7_objects.h"
#include "text/language.h"

namespace grafwire {

/// What a listing begins with: the title, its conventions, the assignment of objects.
std::string pl7_head(const Grafcet& grafcet, Pl7Objects& objects, Language language);

/// The steps of the chart and those that source and sink transitions need, a line each; `#` marks
/// the initial ones, as in the printouts.
std::string pl7_steps(const Grafcet& grafcet, Pl7Objects& objects, Language language);

}  // namespace grafwire
