#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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

/// Runs reference and netlist over the stimuli of a path, from power-up, and reports the difference
/// at their end; nothing where none shows.
std::optional<Witness> replay(const Grafcet& grafcet, const Netlist& netlist,
                              const CellDelays& delays, const Stimuli& stimuli);

/// The witness in words: what changes at the last instant, which transitions the reference clears,
/// which gates change first, and where the two sides part.
std::string tell_witness(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                         const Witness& witness, Language language);

}  // namespace grafwire
