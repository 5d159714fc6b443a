#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plc/shared/plc_options.h"
#include "program/program.h"
#include "random/shrink.h"
#include "text/time.h"

namespace grafwire::testing {

/// Runs a program written in some language, once per text of scans: a line per scan with its moment
/// in ms and the inputs, under a heading. Gives the traces that it wrote; where it could not be
/// written, compiled or run, throws a std::runtime_error that says why.
using LanguageRunner = std::function<std::vector<std::string>(
    const Grafcet& grafcet, const ScanProgram& program, const std::vector<std::string>& scans)>;

/// The program of a case against the reference, over scans of each period: what differs, or
/// nothing. Without internals, the columns of vars and counters are left out.
std::string compare_with_reference(const RandomCase& item, const LanguageRunner& run,
                                   bool with_internals = true, const ProgramOptions& options = {},
                                   const std::vector<Time>& periods = {10 * millisecond,
                                                                       1500 * microsecond});

/// The heading of a trace without vars and counters, with its line end.
std::string heading_without_internals(const Grafcet& grafcet);

/// An example of examples/ as a case.
RandomCase example_case(const std::string& name);

/// The text of a format for a program; throws a std::runtime_error with the messages where it is
/// refused.
std::string written(const std::string& format, const Grafcet& grafcet, const ScanProgram& program,
                    const PlcOptions& options = {});

/// Every example, and so many random charts over the whole language, are the reference.
void check_language(const LanguageRunner& run, std::uint64_t first_seed, std::size_t random_cases,
                    bool with_internals = true);

}  // namespace grafwire::testing
