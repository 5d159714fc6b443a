#pragma once

#include <optional>
#include <vector>

#include "grafcet/grafcet.h"
#include "s7/addresses/io_assignment.h"
#include "s7/machine/machine.h"
#include "trace/input_values.h"

namespace grafwire::s7 {

/// Where a listing keeps what a GRAFCET names; nothing where the assignment has no address.
struct Binding {
    std::vector<std::optional<Operand>> inputs;  ///< with Init, AUdur, AUdoux at the end
    std::vector<std::optional<Operand>> steps;   ///< the bits in Ts
    std::vector<std::optional<Operand>> outputs;
    std::vector<std::optional<Operand>> vars;
    std::vector<std::optional<Operand>> counters;
    std::vector<std::optional<Operand>> transitions;  ///< the bits in Tt
    std::vector<std::optional<Operand>> graphs;       ///< the bits in Tfig
};

/// Finds the address of each name. Errors, with their place in the text of the assignment: a name
/// that the GRAFCET does not have, an input whose address is no input bit, a step, output, var or
/// transition whose address is no bit, a counter whose address is no word; and, without a place, an
/// input, step or output that has no address.
std::optional<Binding> bind(const Grafcet& grafcet, const IoAssignment& io,
                            Diagnostics& diagnostics);

/// A GRAFCET that has nothing but the names of an assignment, for running a listing whose GRAFCET
/// nobody has given: bits of E are inputs (Init, AUdur and AUdoux apart), bits of A outputs, X…
/// steps, other bits vars and words counters. Transitions, and the bits of Tfig (V0.0 … V1.7,
/// Cordier, section 3.2), are left out.
Grafcet names_of(const IoAssignment& io);
/// Whether names_of makes something of an entry (or it is a control input).
bool is_shown(const IoAssignment::Entry& entry);

/// The assignment of a listing to itself: its input and output bits under their addresses.
IoAssignment addresses_of(const Listing& listing);

/// The process image for inputs of the GRAFCET; control inputs without address are left out.
InputImage image_of(const Binding& binding, const InputValues& inputs);

}  // namespace grafwire::s7
