#pragma once

#include <optional>
#include <vector>

#include "evolution/evolution.h"
#include "grafcet/grafcet.h"
#include "s7/listing.h"
#include "s7/machine/binding.h"

namespace grafwire {

/// Where a listing keeps the tables of the method: at Cordier's addresses (section 3.2), where Ts
/// is VB20 … VB29 and the other tables of steps lie at fixed distances from it.
struct MethodTables {
    static constexpr std::int32_t first_byte_of_ts = 20;
    static constexpr std::int32_t bytes = 10;
    enum Distance : std::int32_t {
        previous = -10,
        activate = 20,
        deactivate = 30,
        forced_on = 40,
        forced_off = 50,
    };
    /// The bit of a step in another table, given its bit in Ts.
    static s7::Operand in(Distance table, s7::Operand step);
};

/// Whether the steps and transitions of a binding lie where the method has Ts and Tt.
bool keeps_method_tables(const s7::Binding& binding);

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
