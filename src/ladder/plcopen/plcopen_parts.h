#pragma once

#include "ladder/ladder.h"
#include "ladder/plcopen/plcopen_body.h"
#include "program/program.h"

namespace grafwire::ladder {

// The bodies of a PLCopen project. `names` are the identifiers of the diagram's variables.

void write_ladder_body(const Ladder& ladder, const std::vector<std::string>& names,
                       pugi::xml_node body);

/// The sequential function chart of a GRAFCET: its interface and its body. What SFC cannot say
/// (orders, enclosures, conditions of actions, actions on clearing and on events, transitions
/// without a step before or after) stands in comments.
void write_sfc_interface(const Grafcet& grafcet, pugi::xml_node pou);
void write_sfc_body(const Grafcet& grafcet, pugi::xml_node body);

}  // namespace grafwire::ladder
