#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evolution/run.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "netlist/styles/styles.h"
#include "support/slow_build.h"
#include "trace/stimuli.h"

namespace grafwire::testing {

/// A chart of examples/ with its stimuli, and what the README says of it.
struct Example {
    std::string name;
    Grafcet grafcet;
    Stimuli stimuli;
    RunResult reference;                           ///< until stable
    std::vector<std::string> sound_in;             ///< the styles in the README's column "sound in"
    std::vector<std::string> sound_one_at_a_time;  ///< and those in "one at a time"
};

/// All of them, in the order of the README's table. There are thirteen, or the test fails.
const std::vector<Example>& examples();

/// One that is there.
const Example& example_named(const std::string& name);

Grafcet load_grafcet(const std::string& path);
Stimuli load_stimuli(const std::string& path, const Grafcet& grafcet);

/// The netlist in a style, with its default form of CDX; empty only where the style has no
/// registers for the counters of the GRAFCET.
std::optional<Netlist> netlist_of(const Grafcet& grafcet, const StyleRow& row);

/// A netlist whose simulation over the example's stimuli agrees with the reference.
struct AgreeingNetlist {
    const Example* example = nullptr;
    const StyleRow* style = nullptr;
    Netlist netlist;
    std::string name() const { return example->name + " in " + std::string(style->name); }
};

/// What the reference does over the example's stimuli: until stable for gates that run freely, scan
/// by scan for those on a clock.
inline constexpr Time scan_period = 50 * millisecond;
Trace reference_for(const AgreeingNetlist& item);

/// All of those, example by example.
const std::vector<AgreeingNetlist>& agreeing_netlists();

/// One row of a trace as other simulators show it: the names of the steps and outputs that are 1,
/// each followed by a blank.
std::string ones_of(const Grafcet& grafcet, const Trace& trace, std::size_t row);

}  // namespace grafwire::testing
