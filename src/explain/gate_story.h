#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "logic/logic.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"
#include "simulate/simulate.h"
#include "text/time.h"
#include "trace/stimuli.h"

namespace grafwire {

// What the gates of a netlist do at each instant, as values: what began it, and by which gates it
// came to every step and output that changes. write_gate_story.h puts it into words.

/// A change on the way to a step or output.
struct GateLink {
    CellId cell = no_cell;  ///< no_cell: an input
    NetId net = no_net;
    Logic value = Logic::unknown;
    Time after = 0;          ///< since the instant
    bool is_target = false;  ///< of a step or output that has a way of its own in the story
};

/// A step or output that is another after an instant than before it.
struct GateChange {
    std::string name;  ///< `X1`, or the output
    Logic value = Logic::unknown;
    Time after = 0;
    /// From what began it, or from the last step or output on the way, to the gate before its own.
    /// Where a gate needed several, the last to come.
    std::vector<GateLink> way;
    std::size_t left_out = 0;  ///< of a long way: links that are not there, after the first
};

/// An instant of a simulation, or a scan of a run scan by scan.
struct GateStory {
    Time at = 0;
    bool is_first = false;
    bool by_scans = false;
    std::vector<Stimuli::Assignment> inputs;  ///< that change; at the first instant, those at 1
    std::vector<std::string> ended;           ///< time conditions whose delay ends
    std::vector<GateChange> changes;          ///< the first of many, in the order of time
    std::size_t untold = 0;                   ///< those that are not in `changes`
    std::vector<NetId> oscillating;           ///< not empty: the netlist does not settle
    Time settled_after = 0;                   ///< when the last net changed

    // How it ends.
    std::vector<std::string> active;     ///< steps at 1
    std::vector<std::string> outputs;    ///< at 1
    std::vector<std::string> undefined;  ///< steps and outputs that are neither 0 nor 1

    /// Nothing has changed, and as many instants like this one follow, up to `last`.
    bool is_quiet = false;
    std::size_t repeated = 0;
    Time last = 0;
};

/// A simulation and its story.
struct ToldSimulation {
    SimulateResult result;
    std::vector<GateStory> stories;
};

/// simulate() with every instant told; its observers are those of the story.
ToldSimulation tell_simulation(const Grafcet& grafcet, const Netlist& netlist,
                               const CellDelays& delays, const Stimuli& stimuli,
                               SimulateOptions options);

}  // namespace grafwire
