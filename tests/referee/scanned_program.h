#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "random/random_source.h"
#include "text/time.h"
#include "trace/input_values.h"
#include "trace/stimuli.h"

namespace grafwire::testing {

/// A program that is executed scan by scan, as plainly as it can be: with two values, and from one
/// state to the next.
class ScannedProgram {
  public:
    virtual ~ScannedProgram() = default;
    /// Back to before the first scan.
    virtual void start() = 0;
    virtual void scan(Time now, const InputValues& inputs) = 0;
    /// X of every step, then the outputs.
    virtual std::vector<bool> shown() const = 0;
};

/// A run of the reference and a program beside each other, a scan every period.
struct ScanWalk {
    Stimuli stimuli;
    std::size_t scans = 0;
    std::string contradiction;  ///< empty where they agreed throughout
};

/// Random inputs that keep to the assumptions; `controls`: Init, AUdur and AUdoux among them.
ScanWalk random_scans(const Grafcet& grafcet, ScannedProgram& program, Time period, bool controls,
                      RandomSource& random, std::size_t length);

/// Given stimuli; `is_plain`: beside the reference written plainly.
ScanWalk replayed_scans(const Grafcet& grafcet, ScannedProgram& program, const Stimuli& stimuli,
                        Time period, bool is_plain);

}  // namespace grafwire::testing
