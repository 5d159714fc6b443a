#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evolution/run.h"
#include "grafcet/grafcet.h"
#include "netlist/delay_schedule.h"
#include "netlist/netlist.h"
#include "text/time.h"
#include "trace/stimuli.h"
#include "trace/trace.h"

namespace grafwire {

enum class DifferenceKind {
    situation,    ///< an X differs, once everything has settled or after a scan
    output,       ///< an output differs
    oscillation,  ///< a netlist does not settle
    race,         ///< a netlist settles at a value that the gates leave open
    power_up,     ///< a netlist does not find its initial situation by itself
};

/// A difference that replays: stimuli, and what the two sides show at their end.
struct Witness {
    DifferenceKind kind = DifferenceKind::situation;
    Stimuli stimuli;
    /// Not 0: the difference shows in a scan-by-scan run with this period, not at the end of an
    /// instant.
    Time scan_period = 0;
    /// What memories that nothing is known of hold at power-up, where that matters.
    std::vector<Netlist::InitialValue> power_up;
    /// The delays of gates that the difference needs; the others are nominal.
    DelaySchedule delays;
    struct Value {
        std::string name;
        Logic expected = Logic::unknown;
        Logic got = Logic::unknown;
    };
    std::vector<Value> values;  ///< X of every step, then the outputs
};

/// The first moment at which a run of the reference and one of what is compared with it differ, or
/// where the latter does not settle; nothing where the reference finds no stable situation before.
/// The two may have rows at different moments.
std::optional<Witness> first_difference(const Grafcet& grafcet, const Stimuli& stimuli,
                                        const RunResult& expected, const Trace& got,
                                        std::optional<Time> unsettled_at = std::nullopt);

}  // namespace grafwire
