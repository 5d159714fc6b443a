#pragma once

#include <optional>
#include <string_view>

#include "ladder/ladder.h"
#include "plcopen/messages.h"
#include "text/diagnostics.h"

namespace grafwire::plcopen {

/// Reads the LD body of a program in a PLCopen TC6 XML project of any tool. With `program`
/// empty the project must hold exactly one program in LD. Networks are executed from top to bottom,
/// or by executionOrderId where every coil and block has one; within a network, what others depend
/// on comes first. What is not understood (jumps, other blocks, variables of other types) goes into
/// `diagnostics` as code::bad_ladder with the place of its element, and the result is empty then.
std::optional<ladder::Ladder> read_ladder(const SourceFile& source, Diagnostics& diagnostics,
                                          std::string_view program = {});

}  // namespace grafwire::plcopen
