#pragma once

#include <cstdint>
#include <vector>

#include "netlist/netlist.h"
#include "text/time.h"
#include "trace/stimuli.h"

namespace grafwire {

/// What a test bench or a deck applies to a netlist, and when it looks at the outputs.
struct Bench {
    /// What is applied; `Assignment::input` is an index into Netlist::inputs. Inputs never set are
    /// 0.
    Stimuli stimuli;
    /// The moments that have a row of results, strictly in order. For the settled values of an
    /// asynchronous netlist: every change and every end of a delay; for a clocked one: the scans.
    std::vector<Time> instants;
    /// What the outputs shall be in each row, row after row, unknown where anything will do; empty
    /// where nothing is expected. For benches that can compare.
    std::vector<Logic> expected;
    std::uint32_t clock_cycles = 1;  ///< clocked netlists: clock cycles at every instant
    /// A row is taken so long after its instant, or nine tenths of the way to the next where that
    /// is sooner.
    Time settling = 100 * microsecond;
};

/// The bench for a netlist made from the GRAFCET the stimuli are for (inputs in the same order).
/// Without `instants` (those of a trace), these are 0, the changes and the end of the stimuli.
Bench bench_from(const Netlist& netlist, const Stimuli& stimuli, std::vector<Time> instants = {});

/// Without stimuli: all inputs 0, one instant.
Bench idle_bench();

/// How long after its instant row number `row` is taken.
Time sampling_delay(const Bench& bench, std::size_t row);

/// How long that may be, however long the netlist takes to settle: nine tenths of the way to the
/// next instant; without bound after the last.
Time longest_sampling_delay(const Bench& bench, std::size_t row);

/// The values of all inputs that a netlist is started with: those of instant 0, but Init at 1 and
/// the other controls (and the clock) at 0.
std::vector<bool> starting_inputs(const Netlist& netlist, const Bench& bench);

/// One moment of a bench with all that happens then: the inputs that change, and whether the
/// moment has a row of results.
struct BenchEvent {
    Time at = 0;
    std::vector<Stimuli::Assignment> assignments;  ///< those that change something, by input
    std::size_t row = no_row;
    static constexpr std::size_t no_row = static_cast<std::size_t>(-1);
};

/// The changes and instants merged, in the order of time. Changes after the last instant are left
/// out. The first event is at 0 and undoes the start (Init).
std::vector<BenchEvent> bench_events(const Netlist& netlist, const Bench& bench);

}  // namespace grafwire
