#pragma once

#include "ladder/ladder.h"
#include "ladder/plcopen_body.h"
#include "program/program.h"

namespace grafwire::ladder {

// The bodies of a PLCopen project. `names` are the identifiers of the diagram's variables.

void write_ladder_body(const Ladder& ladder, const std::vector<std::string>& names,
                       pugi::xml_node body);

}  // namespace grafwire::ladder
