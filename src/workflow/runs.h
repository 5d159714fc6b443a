#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evolution/run.h"
#include "netlist/netlist.h"
#include "s7/machine/run_listing.h"
#include "simulate/simulate.h"
#include "story/instant_story.h"
#include "text/diagnostics.h"
#include "text/message.h"
#include "text/time.h"
#include "trace/stimuli.h"
#include "workflow/chart.h"
#include "workflow/gate_delays.h"
#include "workflow/programs.h"

namespace grafwire {

/// The reference over stimuli: scan by scan with that period, or until stable (none).
RunResult run_reference(const Chart& chart, const Stimuli& stimuli, std::optional<Time> period);

/// The same run with an account of each instant or scan: what was cleared and why; and that account
/// in words.
ToldRun tell_reference(const Chart& chart, const Stimuli& stimuli, std::optional<Time> period);
std::string explain_run(const Chart& chart, const ToldRun& run, Language language);

/// The gates over stimuli under these delays: a clocked netlist scan by scan with that period, or
/// until stable (none). With a waveform of every net if asked for.
SimulateResult simulate_gates(const Chart& chart, const Netlist& netlist, const Stimuli& stimuli,
                              const GateDelays& delays, std::optional<Time> period,
                              bool with_waveform);

/// The same run, and in words: what the gates did at each instant, from what began it to every step
/// and output that changes.
struct ExplainedSimulation {
    SimulateResult result;
    std::string text;
};
ExplainedSimulation explain_gates(const Chart& chart, const Netlist& netlist,
                                  const Stimuli& stimuli, const GateDelays& delays,
                                  std::optional<Time> period, bool with_waveform,
                                  Language language);

/// The cells that drive these nets, for the message that a netlist does not settle; the first of
/// many.
Localized oscillating_cells(const Netlist& netlist, const std::vector<NetId>& nets);

/// The moments at which stimuli break an assumption, the first for each that is found broken.
std::vector<RunResult::BrokenAssumption> broken_assumptions(const Grafcet& grafcet,
                                                            const Stimuli& stimuli);
/// Which assumption it is, and when.
Localized broken_assumption_text(const Grafcet& grafcet, const RunResult::BrokenAssumption& broken);

/// The names that a run of a listing has its columns by, and where the listing keeps what they
/// show.
struct ListingColumns {
    Grafcet grafcet;
    s7::Binding binding;
};
/// Those of a chart, which needs the assignment; without one, those of the assignment, or of the
/// addresses in the listing. Errors have their places in the text of the assignment; empty then.
std::optional<ListingColumns> columns_of(const s7::Listing& listing,
                                         const s7::IoAssignment* assignment, const Chart* chart,
                                         Diagnostics& diagnostics);

/// The names of inputs that the stimuli set and the listing does not have.
std::vector<std::string> lost_inputs(const ListingColumns& columns, const Stimuli& stimuli);

}  // namespace grafwire
