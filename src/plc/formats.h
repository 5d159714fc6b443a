#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "program/program.h"
#include "s7/cpu.h"
#include "s7/io_assignment.h"
#include "text/diagnostics.h"

namespace grafwire {

/// For formats with addresses.
struct PlcOptions {
    /// Addresses for inputs, outputs and steps; without, they are assigned in order.
    const s7::IoAssignment* io = nullptr;
    Mnemonics mnemonics = Mnemonics::simatic;  ///< of instruction lists
    bool wide_tables = false;                  ///< tables beyond the 80 steps of the method
    std::optional<s7::Cpu> cpu;                ///< the controller that the program has to fit
};

/// One row per language. A writer gives the whole file; where the language cannot hold the program
/// it says which limit is exceeded in `diagnostics`, and the text is empty then. Same chart, same
/// bytes.
struct PlcFormat {
    std::string_view name;
    std::string_view extension;
    std::string_view description;
    std::string (*write)(const ScanProgram& program, const PlcOptions& options,
                         Diagnostics& diagnostics);
    bool has_addresses = false;  ///< whether it heeds the options
};

/// All formats, in the order in which help shows them.
std::span<const PlcFormat> plc_formats();
/// The format of that name; nullptr where there is none.
const PlcFormat* plc_format_named(std::string_view name);
std::vector<std::string_view> plc_format_names();

}  // namespace grafwire
