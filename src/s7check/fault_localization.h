#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/witness.h"
#include "grafcet/grafcet.h"
#include "s7/machine/binding.h"
#include "s7/machine/machine.h"

namespace grafwire {

/// Where in a listing a difference comes from: the first bit of the tables, in the order of the
/// scan, that is not what it should be, and the networks that are candidates for having made it so.
struct Diagnosis {
    enum class Kind : std::uint8_t {
        receptivity,  ///< Tt, of a transition
        timer,        ///< a time condition that a receptivity reads
        previous,     ///< Tp, of a step, like the next five
        activate,     ///< Ta
        deactivate,   ///< Td
        forced_on,    ///< Tf1
        forced_off,   ///< Tf0
        situation,    ///< Ts, or the bit of a step where there are no tables
        may_evolve,   ///< Tfig, of a graph
        var,
        output,
    };
    Kind kind = Kind::situation;
    std::string name;   ///< of the transition (its label), step (X…), graph, var, output; T37
    s7::Operand place;  ///< the bit
    bool expected = false;
    Time at = 0;  ///< the time of the scan after which it was wrong
    /// The networks (by number) to look at, the likeliest first: the one that wrote the bit, or
    /// should have written it, then those that write what it reads, or that could have jumped over
    /// it and did not. Empty where none writes it.
    std::vector<std::uint32_t> networks;
    bool should_have_written = false;  ///< the first network did not write it, and should have

    /// What the first network (or one that wrote such a thing) read, other than inputs and tables.
    struct Read {
        std::uint32_t network = 0;  ///< who read
        s7::Operand place;
        std::int32_t value = 0;
        std::optional<std::uint32_t> writer;  ///< none: never written
    };
    std::vector<Read> reads;
};

/// Runs reference and listing over the stimuli of a witness and looks into the tables of the method
/// (where the listing keeps them, at Cordier's addresses) scan by scan. Empty where everything that
/// can be seen is as it should be up to the end.
std::optional<Diagnosis> localize_fault(const Grafcet& grafcet, const s7::Listing& listing,
                                        s7::Cpu cpu, const s7::Binding& binding,
                                        const Witness& witness);

}  // namespace grafwire
