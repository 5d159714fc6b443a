#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "check/partial_inputs.h"
#include "logic/logic.h"
#include "text/message.h"
#include "text/source.h"
#include "text/time.h"

namespace grafwire {

/// A program that is executed scan by scan, as a check sees it: a machine without gates, whose
/// memory between two scans is a value. The same memory, inputs and time give the same outcome. It
/// is all that a check knows of programs.
class ScannedDevice {
  public:
    virtual ~ScannedDevice() = default;

    /// Where a program stops in a scan that should come to its end.
    struct Stop {
        std::uint32_t network = 0;  ///< its number
        Location where;
        Localized message;
    };

    /// What came of a scan.
    struct Outcome {
        /// An input that is unassigned in this scan and on which a compared value, or anything that
        /// is remembered, depends. The rest is of no meaning then.
        std::optional<std::uint32_t> needs;
        /// Where the program stopped, if it did; the values below are unknown then.
        std::optional<Stop> stop;
        std::string memory;          ///< after the scan
        std::vector<Logic> steps;    ///< X of every step of the GRAFCET, 0 or 1
        std::vector<Logic> outputs;  ///< every output, 0 or 1
    };

    /// The memory before the first scan, which finds its inputs for itself. Opaque to its users; it
    /// may hold times.
    virtual std::string start() const = 0;
    /// One scan at time `now`, which is later than that of the scan before. Inputs are those of the
    /// GRAFCET (declared inputs, Init, AUdur, AUdoux), some of them unassigned.
    virtual Outcome scan(const std::string& memory, const PartialInputs& inputs,
                         Time now) const = 0;
    /// All that decides how a memory left by a scan at time `now` goes on, with times relative to
    /// it: memories with the same key behave alike from then on.
    virtual std::string key(const std::string& memory, Time now) const = 0;

    /// The lengths and resolutions of its own timers, for the choice of a period.
    virtual std::vector<Time> delays() const = 0;
    /// Whether it has Init, AUdur and AUdoux; where not, they stay 0.
    virtual bool has_modes() const = 0;
};

}  // namespace grafwire
