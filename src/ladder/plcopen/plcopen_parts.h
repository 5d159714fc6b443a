#pragma once

#include "ladder/ladder.h"
#include "ladder/plcopen/plcopen_body.h"
#include "ladder/plcopen/sfc_names.h"
#include "ladder/plcopen/sfc_plan.h"

namespace grafwire::ladder {

// The bodies of a PLCopen project. `names` are the identifiers of the diagram's variables.

void write_ladder_body(const Ladder& ladder, const std::vector<std::string>& names,
                       pugi::xml_node body);

/// The sequential function chart of a GRAFCET: its interface and its body. What SFC cannot say
/// stands in comments (sfc_remarks.h).
void write_sfc_interface(const SfcPlan& plan, const SfcNames& names, pugi::xml_node pou);
void write_sfc_body(const SfcPlan& plan, const SfcNames& names, pugi::xml_node body);

}  // namespace grafwire::ladder
