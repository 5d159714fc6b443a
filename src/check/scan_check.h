#pragma once

#include <optional>

#include "check/check_result.h"
#include "check/scanned_device.h"
#include "check/witness.h"
#include "grafcet/grafcet.h"
#include "text/time.h"
#include "trace/stimuli.h"
#include "trace/trace.h"

namespace grafwire {

/// Compares a program that is executed scan by scan with the reference, executed with the same
/// period: after every scan, in every state that can be reached, under every change of the inputs
/// that can matter there. Situations, cases and states waiting are counted as for a netlist; a case
/// is one scan. The verdict holds for this period; a witness replays with `run --scan`.
CheckResult check_scans(const Grafcet& grafcet, const ScannedDevice& device, Time period,
                        const CheckOptions& options);

/// A period under which the delays of the GRAFCET and of the device are whole numbers of scans:
/// their greatest common divisor, halved where several can run at once, so that one can begin
/// between the scans of another; 10 ms where there are no delays.
Time natural_period(const Grafcet& grafcet, const ScannedDevice& device);

/// The device over stimuli, a scan every period from 0 to the end: one row per scan, vars and
/// counters unknown.
Trace run_device(const Grafcet& grafcet, const ScannedDevice& device, const Stimuli& stimuli,
                 Time period);

/// What comes of the scan in which a witness ends.
ScannedDevice::Outcome last_scan(const Grafcet& grafcet, const ScannedDevice& device,
                                 const Witness& witness);

/// Runs reference and device over stimuli from the start, scan by scan, and reports the first
/// difference; nothing where none shows.
std::optional<Witness> replay_scans(const Grafcet& grafcet, const ScannedDevice& device,
                                    const Stimuli& stimuli, Time period);

}  // namespace grafwire
