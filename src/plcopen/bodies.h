#pragma once

#include "ladder/ladder.h"
#include "plcopen/body.h"
#include "sfc/names.h"
#include "sfc/plan.h"

namespace grafwire::plcopen {

// The bodies of a PLCopen project. `names` are the identifiers of the diagram's variables.

void write_ladder_body(const ladder::Ladder& ladder, const std::vector<std::string>& names,
                       pugi::xml_node body);

/// The sequential function chart of a GRAFCET. What SFC cannot say stands in comments
/// (sfc/remarks.h).
void write_sfc_body(const sfc::Plan& plan, const sfc::Names& names, Language language,
                    pugi::xml_node body);

}  // namespace grafwire::plcopen
