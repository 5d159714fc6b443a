#pragma once

#include <optional>

#include "program/program.h"
#include "s7/generate/assignment.h"
#include "s7/listing.h"
#include "text/diagnostics.h"

namespace grafwire::s7 {

/// The width of all integers of a program: words where every counter and every sum stays within 16
/// bits and no counter has been assigned a double word, else double words. Errors: a sum beyond 32
/// bits; a word assigned to a counter where double words are needed. Empty then.
std::optional<Width> integer_width(const Grafcet& grafcet, const ScanProgram& program,
                                   const ResolvedAssignment& assignment, Diagnostics& diagnostics);

}  // namespace grafwire::s7
