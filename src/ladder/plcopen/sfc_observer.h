#pragma once

#include <string>

#include "ladder/plcopen/structured_text.h"

namespace grafwire::ladder {

/// The statements of the step `observe`, to be executed after all other actions of a scan; empty
/// where there is nothing to observe.
std::string observer_text(const SfcPlan& plan, const SfcNames& names);

}  // namespace grafwire::ladder
