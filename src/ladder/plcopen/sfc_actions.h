#pragma once

#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "ladder/plcopen/plcopen_body.h"
#include "ladder/plcopen/structured_text.h"

namespace grafwire::ladder {

/// One action of an action block: a qualifier, a duration (of L and D), and either the name of a
/// bit or statements.
struct SfcAction {
    std::string qualifier;
    std::string duration;
    std::string reference;
    std::string statements;
};

/// Whether SFC can express any action of a step.
bool has_sfc_actions(const Grafcet& grafcet, const SfcNames& names, StepId step);
/// The action block beside a step, of the actions that SFC can express.
void write_sfc_actions(const Grafcet& grafcet, const SfcNames& names, StepId step,
                       const Outlet& source, PlcopenBody& body);
void write_sfc_action_block(const std::vector<SfcAction>& actions, const Outlet& source,
                            PlcopenBody& body);
/// What SFC cannot express, a line each; the first says where it is to be found.
std::vector<std::string> sfc_remarks(const Grafcet& grafcet, const SfcNames& names);

}  // namespace grafwire::ladder
