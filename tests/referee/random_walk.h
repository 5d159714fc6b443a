#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "random/random_source.h"
#include "text/time.h"
#include "trace/input_values.h"
#include "trace/stimuli.h"

namespace grafwire::testing {

/// What may happen at an instant after the first one.
enum class Happens {
    one_thing,    ///< one input changes, or running delays end
    many_things,  ///< any inputs change, and running delays end with them
};

/// The inputs of a random run, which keep to the assumptions of the GRAFCET.
class RandomInputs {
  public:
    /// `controls`: whether Init, AUdur and AUdoux ever change.
    RandomInputs(const Grafcet& grafcet, RandomSource& random, bool controls);

    /// Some values that keep to the assumptions; false where none were found.
    bool begin();
    /// Other values; false where none were found.
    bool change(Happens happens);

    const InputValues& values() const { return values_; }

  private:
    bool may_change(const InputValues& values, std::size_t input) const;

    const Grafcet& grafcet_;
    RandomSource& random_;
    bool controls_;
    InputValues values_;
};

/// The line of stimuli that leads from some values to others.
Stimuli::Change change_between(const InputValues& before, const InputValues& after, Time at);

/// A run of reference and netlist beside each other, and how far they agreed.
struct Walk {
    Stimuli stimuli;
    Time scan_period = 0;  ///< 0: until stable
    std::size_t instants = 0;
    std::string contradiction;  ///< empty where they agreed throughout
};

/// Scan by scan where `scan_period` is not 0; else until stable. At most this many scans or
/// instants.
Walk random_walk(const Grafcet& grafcet, const Netlist& netlist, Happens happens, Time scan_period,
                 RandomSource& random, std::size_t length);

/// A period that fits the delays of the GRAFCET in some way or other.
Time random_period(const Grafcet& grafcet, RandomSource& random);

/// What nets without an initial value may hold at power-up: anything at all, or what they come to
/// by themselves except for some of them (so that a memory can keep what is random in it).
std::vector<bool> random_power_up(const Grafcet& grafcet, const Netlist& netlist,
                                  const InputValues& inputs, RandomSource& random);

}  // namespace grafwire::testing
