#pragma once

#include <optional>

#include "program/program.h"
#include "s7/addresses/cpu.h"
#include "s7/addresses/io_assignment.h"
#include "s7/listing.h"
#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire::s7 {

struct ListingOptions {
    /// Addresses that are given; resolve_assignment finds nothing wrong with them. Control inputs
    /// without an address are then left out of the program. Without, inputs take E0.0, E0.1, …,
    /// the control inputs that are read coming last, and outputs A0.0, A0.1, ….
    const IoAssignment* io = nullptr;
    /// Tables of the sizes that the chart needs, beyond the 80 steps of the method.
    bool wide_tables = false;
    /// The controller that the program has to fit; without, any size will do, and there are the
    /// timers of a CPU 214.
    std::optional<Cpu> cpu;
    Mnemonics mnemonics = Mnemonics::simatic;  ///< of the addresses at the head
    Language language = Language::english;     ///< of the head and of comments
    std::string made_by{};  ///< a line for the head: who wrote it and how; may be empty
};

/// A listing, and where everything in it lives: inputs, outputs, vars, counters, steps, transitions
/// and graphs, in this order.
struct AssignedListing {
    Listing listing;
    IoAssignment assignment;
};

/// The program as a listing of the method: OB1 and SBR 0 … SBR 10 as in Cordier, chapter V, with
/// the parts of the chart in their places, and at its head the assignment and what memory it takes.
/// Limits that are exceeded (steps, transitions, graphs, inputs, outputs, timers, integers, memory)
/// are errors in `diagnostics`, with what to do; empty then.
std::optional<AssignedListing> listing_from(const Grafcet& grafcet, const ScanProgram& program,
                                            const ListingOptions& options,
                                            Diagnostics& diagnostics);

}  // namespace grafwire::s7
