#pragma once

#include "ladder/ladder.h"
#include "plcopen/plcopen_body.h"
#include "sfc/actions.h"
#include "sfc/names.h"
#include "sfc/plan.h"

namespace grafwire::ladder {

// The bodies of a PLCopen project. `names` are the identifiers of the diagram's variables.

void write_ladder_body(const Ladder& ladder, const std::vector<std::string>& names,
                       pugi::xml_node body);

/// The sequential function chart of a GRAFCET: its interface and its body. What SFC cannot say
/// stands in comments (sfc/remarks.h).
void write_sfc_interface(const sfc::Plan& plan, const sfc::Names& names, pugi::xml_node pou);
void write_sfc_body(const sfc::Plan& plan, const sfc::Names& names, pugi::xml_node body);
/// The action block beside a step, which hangs on its outlet for actions.
void write_sfc_action_block(const std::vector<sfc::ActionBlockEntry>& actions, const Outlet& source,
                            PlcopenBody& body);

}  // namespace grafwire::ladder
