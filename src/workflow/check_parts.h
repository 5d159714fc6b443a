#pragma once

#include "check/scanned_device.h"
#include "workflow/check.h"

namespace grafwire {

// What the check of a netlist and that of a program have in common.

/// Whether the chart gives a check something to say; why not goes into `messages`.
bool is_worth_checking(const Chart& chart, const std::string& file, bool has_modes,
                       Diagnostics& messages);

CheckOptions check_options(const CheckRequest& request);

}  // namespace grafwire
