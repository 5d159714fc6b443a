#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "check/partial_inputs.h"
#include "check/witness.h"
#include "grafcet/grafcet.h"
#include "text/language.h"
#include "text/time.h"
#include "trace/stimuli.h"
#include "trace/trace.h"

namespace grafwire {

/// A program that is executed scan by scan, as a check sees it: a machine without gates, whose
/// memory between two scans is a value. The same memory, inputs and moment give the same outcome.
class ScannedDevice {
  public:
    virtual ~ScannedDevice() = default;

    /// What came of a scan.
    struct Outcome {
        /// An input that is open in this scan and on which a compared value, or anything that is
        /// remembered, depends. The rest is of no meaning then.
        std::optional<std::uint32_t> needs;
        std::string memory;          ///< after the scan
        std::vector<Logic> steps;    ///< X of every step of the GRAFCET, 0 or 1
        std::vector<Logic> outputs;  ///< every output, 0 or 1
    };

    /// The memory before the first scan, which finds its inputs for itself. Opaque to everybody
    /// else; it may hold moments.
    virtual std::string start() const = 0;
    /// One scan at moment `now`, which is later than that of the scan before. Inputs are those of
    /// the GRAFCET (declared inputs, Init, AUdur, AUdoux), some of them open.
    virtual Outcome scan(const std::string& memory, const PartialInputs& inputs,
                         Time now) const = 0;
    /// All that decides how a memory left by a scan at moment `now` goes on, with moments relative
    /// to it: memories of one key behave alike from then on.
    virtual std::string key(const std::string& memory, Time now) const = 0;

    /// The lengths and resolutions of its own timers, for the choice of a period.
    virtual std::vector<Time> delays() const = 0;
    /// Whether it has Init, AUdur and AUdoux; where not, they stay 0.
    virtual bool has_modes() const = 0;
};

/// A period under which the delays of the GRAFCET and of the device are whole numbers of scans:
/// their greatest common divisor, halved where several can run at once, so that one can begin
/// between the scans of another; 10 ms where there are no delays.
Time natural_period(const Grafcet& grafcet, const ScannedDevice& device);

/// The device over stimuli, a scan every period from 0 to the end: one row per scan, vars and
/// counters unknown.
Trace run_device(const Grafcet& grafcet, const ScannedDevice& device, const Stimuli& stimuli,
                 Time period);

/// Runs reference and device over stimuli from the start, scan by scan, and reports the first
/// difference; nothing where none shows.
std::optional<Witness> replay_scans(const Grafcet& grafcet, const ScannedDevice& device,
                                    const Stimuli& stimuli, Time period);

}  // namespace grafwire
