#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/witness.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "simulate/simulator.h"
#include "text/time.h"

namespace grafwire {

/// A known reason why wiring departs from its GRAFCET although its equations are right.
enum class CauseKind {
    two_step_loop,      ///< two steps follow each other, and CDX has the successor form
    two_tokens,         ///< a step is reset by a second token in front of it, in the successor form
    long_pulse,         ///< the pulse of an edge clears two transitions, one after the other
    fleeting_follower,  ///< what should reset a step goes on before the step has been set
    reset_priority,     ///< deactivation wins over activation
    set_and_reset,      ///< a memory of gates is set and reset at once, and both end together
    input_race,         ///< inputs that change together are read together
    gate_race,          ///< the delays of gates decide, and with those of the witness it goes wrong
};

/// Such a reason, with the names it is told with.
struct Cause {
    CauseKind kind = CauseKind::two_step_loop;
    std::string step;  ///< `X1`: the step that goes wrong; of input_race empty
    /// two_step_loop, two_tokens, fleeting_follower: the X that reset it; long_pulse: the edge;
    /// input_race: the inputs
    std::vector<std::string> others;
    std::vector<std::string> transitions;  ///< long_pulse: the two; two_tokens: the one not cleared
};

/// Why a netlist departs from its GRAFCET at the end of a witness, backwards from what differs.
struct Explanation {
    /// What makes an equation 1 or 0.
    struct Operand {
        std::string name;
        Logic value = Logic::unknown;
    };
    /// CAX, CDX or X of a step, or the equation of an output, as it should be and as the netlist
    /// has it, read off its gates.
    struct EquationPair {
        std::string name;      ///< `CAX4`
        std::string expected;  ///< right-hand side
        /// The netlist's, as a sum of products; empty where it is the same function, or too large
        /// to be written.
        std::string got;
        bool is_same = true;
        std::vector<Operand> operands;     ///< of both, with their values where it is decided
        std::vector<std::string> missing;  ///< what the netlist's does not depend on
        std::vector<std::string> extra;    ///< what only the netlist's depends on
    };
    /// What is the matter with a part.
    enum class Fault {
        no_fault,  ///< the equations are the same: it is a matter of time, or follows from another
        equation,  ///< CAX, CDX or the equation of an output is another one
        priority,  ///< CAX and CDX are right, but where both are 1 deactivation wins
        order,     ///< AUdur, a forcing order or the enclosing step act otherwise
        unread,    ///< the gates cannot be compared: too many operands, or memories of their own
    };
    /// One X or output that is wrong, or that keeps changing.
    struct Part {
        std::string name;  ///< `X4`, or an output
        bool is_step = false;
        Logic expected = Logic::unknown;
        Logic got = Logic::unknown;
        Fault fault = Fault::no_fault;
        /// A fault that is seen in the values at this moment, counted from the instant.
        std::optional<Time> decided_at;
        std::vector<EquationPair> equations;
        std::vector<Operand> reads;             ///< fault unread: what its gates depend on
        std::vector<std::string> follows_from;  ///< other parts that are wrong and that it reads
        std::vector<std::uint32_t> lines;       ///< of a netlist from a file: where its gates stand
    };
    /// A change on the way, and what brought it about.
    struct Link {
        Time after = 0;         ///< since the last instant; negative before it
        CellId cell = no_cell;  ///< no_cell: an input
        std::string net;
        Logic value = Logic::unknown;
        bool is_begin = false;            ///< nothing before it: an input, the end of a delay
        std::vector<std::string> causes;  ///< the nets whose changes brought it about
    };

    std::optional<Cause> cause;
    std::vector<Part> parts;  ///< what differs: steps first
    std::vector<Link> chain;  ///< from the change that began it to the wrong values
    std::vector<CellId> oscillating;
};

/// Explains a witness that replays under these delays. The netlist is simulated once more, with
/// every change of a net noted; functions of more than TruthTable::most_variables are not compared.
Explanation explain(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                    const Witness& witness);

}  // namespace grafwire
