#pragma once

#include "check/check_result.h"
#include "check/scanned_device.h"
#include "grafcet/grafcet.h"
#include "text/time.h"

namespace grafwire {

/// Compares a program that is executed scan by scan with the reference, executed with the same
/// period: after every scan, in every state that can be reached, under every change of the inputs
/// that can matter there. Situations, cases and states waiting are counted as for a netlist; a case
/// is one scan. The verdict holds for this period; a witness replays with `run --scan`.
CheckResult check_scans(const Grafcet& grafcet, const ScannedDevice& device, Time period,
                        const CheckOptions& options);

}  // namespace grafwire
