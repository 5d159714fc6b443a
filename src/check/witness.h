#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "check/partial_inputs.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "simulate/simulator.h"
#include "text/language.h"
#include "trace/stimuli.h"

namespace grafwire {

enum class DifferenceKind {
    situation,    ///< an X differs once everything has settled
    output,       ///< an output differs
    oscillation,  ///< the netlist does not settle
    race,         ///< the netlist settles at a value that the gates leave open
};

/// One step of the way to a difference: a change of inputs and delays that end, all at one instant.
struct PathStep {
    PartialInputs before;              ///< what the inputs were in the state left (open: any)
    PartialInputs inputs;              ///< what they become
    std::vector<std::uint32_t> ended;  ///< the time conditions whose delays end
};

/// A difference that replays: stimuli, and what the two sides show at their end.
struct Witness {
    DifferenceKind kind = DifferenceKind::situation;
    Stimuli stimuli;
    /// Not 0: the difference shows in a scan-by-scan run with this period, not at the end of an
    /// instant.
    Time scan_period = 0;
    struct Value {
        std::string name;
        Logic expected = Logic::unknown;
        Logic got = Logic::unknown;
    };
    std::vector<Value> values;        ///< X of every step, then the outputs
    std::vector<CellId> oscillating;  ///< the cells that keep changing
};

/// Finds moments and full input values for a path, so that exactly the delays that are to end do
/// so; nothing where the lengths of the delays do not allow it.
std::optional<Stimuli> stimuli_for(const Grafcet& grafcet, const Assumptions& assumptions,
                                   const std::vector<PathStep>& path, Time gap);

/// Runs reference and netlist over the stimuli of a path, from power-up, and reports the difference
/// at their end; nothing where none shows.
std::optional<Witness> replay(const Grafcet& grafcet, const Netlist& netlist,
                              const CellDelays& delays, const Stimuli& stimuli);

/// The witness in words: what changes at the last instant, which transitions the reference clears,
/// which gates change first, and where the two sides part.
std::string tell_witness(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                         const Witness& witness, Language language);

}  // namespace grafwire
