#pragma once

#include <string>

#include "plc/shared/plc_options.h"
#include "program/program.h"
#include "text/diagnostics.h"

namespace grafwire {

// Writers of programming languages; see the table in plc/formats.cpp. Each gives one file that
// compiles as it is. Time is in whole microseconds. A chart that the language cannot hold is an
// error in `diagnostics`, with its place, and the text is empty then.

/// C99, which is C++ as well: to be included where the scan is called; with GRAFWIRE_MAIN a program
/// that reads scans and writes the trace. Integers have 64 bits.
std::string write_c(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                    Diagnostics& diagnostics);

/// A sketch: the same scan between `setup` and `loop`. Every input and output needs a pin of the
/// largest board.
std::string write_arduino(const Grafcet& grafcet, const ScanProgram& program,
                          const PlcOptions& options, Diagnostics& diagnostics);

/// A program in Free Pascal, of at most 256 steps. Integers have 64 bits.
std::string write_pascal(const Grafcet& grafcet, const ScanProgram& program,
                         const PlcOptions& options, Diagnostics& diagnostics);

/// A program in Python 3, without limits.
std::string write_python(const Grafcet& grafcet, const ScanProgram& program,
                         const PlcOptions& options, Diagnostics& diagnostics);

}  // namespace grafwire
