#pragma once

#include <string>
#include <vector>

#include "program/program.h"
#include "s7/addresses/io_assignment.h"
#include "s7/generate/addresses.h"
#include "s7/generate/network_list.h"

namespace grafwire::s7 {

/// What every address stands for: inputs, control inputs that are read, outputs, vars, counters,
/// steps (in Ts), transitions (in Tt) and graphs (in Tfig).
IoAssignment assignment_of(const Grafcet& grafcet, const ScanProgram& program,
                           const Addresses& addresses);

/// The lines at the head of a listing: what it is, the memory it takes, its tables, and the
/// assignment, one line a name as parse_io_assignment reads them.
std::vector<std::string> head_of(const Grafcet& grafcet, const Addresses& addresses,
                                 const IoAssignment& assignment, const NetworkList& networks,
                                 Mnemonics mnemonics, Language language);

}  // namespace grafwire::s7
