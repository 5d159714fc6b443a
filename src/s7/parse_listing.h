#pragma once

#include <optional>

#include "s7/addresses/cpu.h"
#include "s7/addresses/io_assignment.h"
#include "s7/listing.h"
#include "s7/messages.h"
#include "text/diagnostics.h"

namespace grafwire::s7 {

struct ReadingOptions {
    Cpu cpu = Cpu::cpu_214;
    /// Gives names an address; without it an operand that is a name is an error.
    const IoAssignment* io = nullptr;
    /// A part of a listing, such as a single network: what check_listing asks for is not asked for.
    bool is_fragment = false;
};

/// Reads a listing as STEP 7-Micro writes it, or as a book prints it: with or without the byte
/// offset before each instruction, in SIMATIC or international spelling (mixed, if need be), with
/// comments that go on in the next line, `KI` for `K1`, and two columns of print side by side or
/// one behind the other, which are put in order by their offsets. What it puts right it says in a
/// warning (code::read_leniently), as it does where an offset does not fit (code::bad_offset).
///
/// All errors are reported in one go, those of check_listing included; the result is empty then.
std::optional<Listing> parse_listing(const SourceFile& source, const ReadingOptions& options,
                                     Diagnostics& diagnostics);

}  // namespace grafwire::s7
