#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plc/shared/plc_options.h"
#include "program/program.h"
#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// One row per language. A writer gives the whole file; where the language cannot hold the program
/// it says which limit is exceeded in `diagnostics`, and the text is empty then. Same chart, same
/// bytes.
struct PlcFormat {
    std::string_view name;
    std::string_view extension;
    Message<> description;  ///< for `--help`
    std::string (*write)(const Grafcet& grafcet, const ScanProgram& program,
                         const PlcOptions& options, Diagnostics& diagnostics);
    /// The options that it uses, as they are called on the command line: `--io --mnemonics`.
    std::string_view options = "";
    /// What is wrong with `PlcOptions::io` for that chart, with places in the assignment; of
    /// formats that use it.
    void (*check_io)(const Grafcet& grafcet, const PlcOptions& options,
                     Diagnostics& diagnostics) = nullptr;
    /// Where everything in the file lives, as a text that `PlcOptions::io` can be read from; of
    /// formats that use `--addresses`.
    std::string (*write_addresses)(const Grafcet& grafcet, const ScanProgram& program,
                                   const PlcOptions& options, Diagnostics& diagnostics) = nullptr;
};

/// All formats, in the order in which help shows them.
std::span<const PlcFormat> plc_formats();
/// The format of that name; nullptr where there is none.
const PlcFormat* plc_format_named(std::string_view name);
std::vector<std::string_view> plc_format_names();

}  // namespace grafwire
