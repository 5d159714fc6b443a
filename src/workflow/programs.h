#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plc/formats.h"
#include "s7/addresses/cpu.h"
#include "s7/addresses/io_assignment.h"
#include "s7/listing.h"
#include "text/diagnostics.h"
#include "workflow/chart.h"

namespace grafwire {

/// The numbers users call controllers by (`214`): all, that of a controller, and the controller of
/// one.
std::vector<std::string> cpu_numbers();
std::string_view number_of(s7::Cpu cpu);
std::optional<s7::Cpu> cpu_of_number(std::string_view number);

/// Reads a table of assignment; empty after an error.
std::optional<s7::IoAssignment> read_assignment(const SourceFile& source, Diagnostics& diagnostics);
/// Reads one for a program in that format, and checks that it suits the chart.
std::optional<s7::IoAssignment> read_assignment(const SourceFile& source, const PlcFormat& format,
                                                const PlcOptions& options, const Chart& chart,
                                                Diagnostics& diagnostics);

/// Reads an S7-200 listing for a controller. `assignment`: gives the names in it an address, or
/// none.
std::optional<s7::Listing> read_listing(const SourceFile& source, s7::Cpu cpu,
                                        const s7::IoAssignment* assignment,
                                        Diagnostics& diagnostics);

/// A program as a file, and the addresses of everything in it as a table of assignment, of formats
/// that have addresses.
struct WrittenProgram {
    std::string text;
    std::string addresses;
};

/// Writes a chart as a program; empty, with the reasons in `diagnostics`, where the format cannot
/// hold it. `modes`: with Init, AUdur and AUdoux.
std::optional<WrittenProgram> write_program(const Chart& chart, const PlcFormat& format,
                                            const PlcOptions& options, bool modes,
                                            Diagnostics& diagnostics);

}  // namespace grafwire
