#pragma once

#include <cstdint>
#include <map>

#include "program/program.h"
#include "s7/addresses/io_assignment.h"
#include "s7/generate/tables.h"
#include "text/diagnostics.h"

namespace grafwire::s7 {

/// An assignment brought to the bits and counters of a chart.
struct ResolvedAssignment {
    /// Inputs, control inputs, outputs and vars.
    std::map<Bit, Operand> bits;
    /// By the index of the counter.
    std::map<std::uint32_t, Operand> counters;
    /// free_place where the assignment says nothing.
    TablePlaces places;
};

/// Errors: names that the chart does not have, with the nearest it has.
void check_assigned_names(const Grafcet& grafcet, const IoAssignment& assignment,
                          Diagnostics& diagnostics);

/// Finds what each name of the assignment stands for. Errors, with their place in the assignment: a
/// name that the chart does not have (with the nearest it has), an address of the wrong kind, a
/// step outside Ts (a transition outside Tt, a graph outside Tfig), anything else inside the tables
/// or the accumulator VB2 … VB5. (Two names over one another are found when it is read.) With wide
/// tables, whose addresses follow from the chart, steps, transitions and graphs must not be
/// assigned.
ResolvedAssignment resolve_assignment(const Grafcet& grafcet, const IoAssignment& assignment,
                                      bool wide, Diagnostics& diagnostics);

/// The program with every control input that has no address in the assignment held at 0.
ScanProgram without_unassigned_controls(ScanProgram program, const ResolvedAssignment& assignment);

}  // namespace grafwire::s7
