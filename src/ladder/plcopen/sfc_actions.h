#pragma once

#include <string>
#include <vector>

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

/// The actions of a step, as far as SFC can express them.
std::vector<SfcAction> sfc_actions(const SfcPlan& plan, const SfcNames& names, StepId step);
/// The action block beside a step.
void write_sfc_action_block(const std::vector<SfcAction>& actions, const Outlet& source,
                            PlcopenBody& body);

}  // namespace grafwire::ladder
