#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "command/command_line.h"

namespace grafwire {

/// What is known of a request, as bits; a bit that may still turn out to hold is set.
namespace fact {
inline constexpr unsigned none = 0;
inline constexpr unsigned generated = 1;      ///< a netlist made from the GRAFCET
inline constexpr unsigned elsewhere = 2;      ///< a netlist from a file
inline constexpr unsigned listing = 4;        ///< an S7-200 listing
inline constexpr unsigned ladder = 8;         ///< a ladder diagram
inline constexpr unsigned asynchronous = 16;  ///< the netlist has no clock
inline constexpr unsigned clocked = 32;       ///< it has one
inline constexpr unsigned open_start = 64;    ///< nothing sets its steps: from elsewhere, no Init
inline constexpr unsigned stimuli = 128;      ///< there are stimuli
inline constexpr unsigned own_bench = 256;    ///< the format keeps a bench in a file of its own
inline constexpr unsigned bench = 512;        ///< a bench is asked for
inline constexpr unsigned output = 1024;      ///< the result goes into a file
inline constexpr unsigned text = 2048;        ///< the result is a text for programs
inline constexpr unsigned drawing = 4096;     ///< it is a drawing
inline constexpr unsigned moment = 8192;      ///< of a moment
inline constexpr unsigned handshake = 16384;  ///< the netlist is made in this style
}  // namespace fact

/// A format as the table of options sees it.
struct FormatOptions {
    std::string_view name;
    std::string_view options;  ///< those that it heeds: `--io --mnemonics`
};

/// A row of a table of formats, and all of them.
struct ChosenFormat {
    FormatOptions chosen;
    std::vector<FormatOptions> all;
};
template <typename Row>
ChosenFormat chosen_format(std::span<const Row> rows, const Row& row) {
    ChosenFormat format{{row.name, row.options}, {}};
    for (const Row& other : rows) format.all.push_back({other.name, other.options});
    return format;
}

/// Whether an option was written that has no effect with what is asked for; says so if so.
/// The rows of the command are looked at in their order, and the first that refuses is shown.
/// `format`: that of `--to`, for options that some formats heed.
bool refuse_idle_options(const CommandLine& line, std::string_view command, unsigned facts,
                         const ChosenFormat* format = nullptr);

}  // namespace grafwire
