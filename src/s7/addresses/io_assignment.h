#pragma once

#include <optional>
#include <string>
#include <vector>

#include "s7/addresses/operand.h"
#include "text/diagnostics.h"

namespace grafwire::s7 {

/// Which address stands for which name of a chart: the tables of assignment that Cordier puts
/// before each program ("Affectation de Entrées - Sorties", "Adressage complémentaire").
///
/// A text of one line per name, `#` begins a comment:
///
///     E0.0  = v0            # an input, an output, a var, a counter (a word)
///     A0.0  = "V+"
///     V21.0 = X10           # a step: its bit in Ts
///     V81.0 = (10)          # a transition: its bit in Tt
///     V0.1  = Gauto         # a graph: its bit in Tfig
struct IoAssignment {
    struct Entry {
        Operand operand;
        std::string name;  ///< unquoted; of a transition with its parentheses
        Location where;
    };
    std::vector<Entry> entries;  ///< in the order written

    /// The operand of a name; nullptr where there is none.
    const Operand* operand_of(std::string_view name) const;
};

/// Errors (not an address, a name or an address twice) go into `diagnostics`; empty then.
std::optional<IoAssignment> parse_io_assignment(const SourceFile& source, Diagnostics& diagnostics);

/// The assignment as such a text; reading it back gives the same assignment.
std::string write_io_assignment(const IoAssignment& assignment,
                                Mnemonics mnemonics = Mnemonics::simatic);

}  // namespace grafwire::s7
