#pragma once

#include "s7/addresses/cpu.h"
#include "s7/listing.h"
#include "text/diagnostics.h"

namespace grafwire::s7 {

/// Whether a listing is a program that the controller accepts: operands of the right kind and
/// within its memory, labels and subroutines there, once each, and in the right place, no
/// subroutine that calls itself or is called more than eight deep, no OLD, ULD, LRD or LPP without
/// the loads it needs (or whose loads have been pushed out at the bottom of the nine levels), and a
/// size that fits. All errors are reported in one go, those of the flow of control only where there
/// are no others.
///
/// Networks without instructions, or whose first instruction neither loads nor begins or ends
/// something, are allowed: they work with what the network before has left on the stack.
void check_listing(const Listing& listing, Cpu cpu, Diagnostics& diagnostics);

/// The levels of the stack of bits; what is pushed out at the bottom is lost.
inline constexpr std::size_t stack_levels = 9;

/// The part of it that looks at an instruction by itself: the kinds of its operands, and that the
/// controller has what they name.
void check_operands(const Instruction& instruction, const CpuRow& cpu, Diagnostics& diagnostics);

}  // namespace grafwire::s7
