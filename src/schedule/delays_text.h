#pragma once

#include <optional>
#include <string>
#include <vector>

#include "netlist/delay_schedule.h"
#include "netlist/netlist.h"
#include "netlist/passes/wire_delays.h"
#include "text/diagnostics.h"
#include "text/source.h"

namespace grafwire {

/// The wires (`a->X1$set`) that a `.delays` text names, each once. It is to be read for the netlist
/// in which these are cells, with_wire_delays; wires that it does not name take no time.
std::vector<Wire> wires_named_in(const SourceFile& source, const Netlist& netlist);

/// Reads a `.delays` text (UTF-8): gates of that netlist, named by the nets that they drive, and
/// how long they take. The README of the folder describes it. Times without a unit are in
/// nanoseconds. The changes of one moment come in the order of cells. Errors go into `diagnostics`,
/// and the result is empty then.
std::optional<DelaySchedule> read_delays(const SourceFile& source, const Netlist& netlist,
                                         Diagnostics& diagnostics);

/// The schedule as a `.delays` text in its canonical form: gates that take 1 ns from the start are
/// left out, or those that take what most do, where that is another time; not so wires that are
/// cells. Equal schedules give the same bytes; reading them back and writing them again does so
/// too. (A name that holds white space or `#` as well as a quote cannot be read back.)
std::string write_delays(const DelaySchedule& schedule, const Netlist& netlist);

}  // namespace grafwire
