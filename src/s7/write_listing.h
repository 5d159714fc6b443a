#pragma once

#include <string>

#include "s7/listing.h"

namespace grafwire::s7 {

struct WritingOptions {
    Mnemonics mnemonics = Mnemonics::simatic;
    /// The byte offset before each instruction, as Cordier prints it.
    bool offsets = true;
};

/// One instruction as a listing has it, without offset: `S     M0.1    K1`.
std::string write_instruction(const Instruction& instruction, Mnemonics mnemonics);

/// The listing as text, aligned as in Cordier's: networks with their comments, offsets worked out
/// from the sizes, a blank line before each subroutine. Reading it back gives the same listing
/// (with those offsets; places apart).
std::string write_listing(const Listing& listing, const WritingOptions& options);

}  // namespace grafwire::s7
