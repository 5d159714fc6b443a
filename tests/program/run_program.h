#pragma once

#include "program/program.h"
#include "trace/stimuli.h"
#include "trace/trace.h"

namespace grafwire::testing {

/// Executes a scan program statement by statement, a scan every period, and gives the trace in the
/// columns of the reference. With `bit_by_bit` the operations on tables are expanded first.
Trace run_program(const Grafcet& grafcet, const ScanProgram& program, const Stimuli& stimuli,
                  Time period, bool bit_by_bit);

}  // namespace grafwire::testing
