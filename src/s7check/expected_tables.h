#pragma once

#include <vector>

#include "evolution/evolution.h"
#include "grafcet/grafcet.h"

namespace grafwire {

/// What the tables of the method (Cordier, section 3.2) should hold at the end of a scan, worked
/// out from the reference: of a GRAFCET without enclosures and stored actions on its steps exactly,
/// and of others as far as the tables have a part in it.
struct ExpectedTables {
    BitTable enabled;     ///< per transition: all its preceding steps were active
    BitTable cleared;     ///< per transition: it was cleared; for an enabled one, its Tt
    BitTable previous;    ///< Tp
    BitTable activate;    ///< Ta
    BitTable deactivate;  ///< Td
    BitTable evolved;     ///< Ts = Tp . /Td + Ta
    BitTable forced_on;   ///< Tf1
    BitTable forced_off;  ///< Tf0
    BitTable situation;   ///< Ts at the end
    BitTable may_evolve;  ///< Tfig
    BitTable vars;
    OutputValues outputs;
};

/// Executes one scan of the reference on `state`.
ExpectedTables scan_with_tables(const Evolution& evolution, EvolutionState& state,
                                const EvolutionInputs& inputs, Time now);

}  // namespace grafwire
