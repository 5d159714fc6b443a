#pragma once

#include <vector>

#include "core/json.h"
#include "core/runs.h"

namespace grafwire::playground {

/// Where a run stands, and the instants that led there, as the page gets them.
Json state_answer(const Runs::OpenRun& open, const std::vector<LiveInstant>& instants);

/// What the gates did at power-up.
Json power_up_answer(const LiveRun& run);

}  // namespace grafwire::playground
