#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/shared/bench.h"
#include "netlist/netlist.h"
#include "text/diagnostics.h"

namespace grafwire {

struct ExportOptions {
    /// The time between two rises of the clock of a clocked netlist, for formats that must turn the
    /// delays of clocked timers into cycles.
    Time scan_period = 10 * millisecond;
    /// What to apply, for formats that hold a netlist and its stimuli in one file; without, these
    /// hold all inputs at 0 after the initialisation.
    const Bench* bench = nullptr;
};

/// One row per output format. A writer gives the whole file; where the format cannot hold the
/// netlist it says so in `diagnostics`, and the text is empty then. Same netlist, same bytes.
struct Exporter {
    std::string_view name;
    std::string_view extension;
    std::string_view description;
    std::string (*write)(const Netlist& netlist, const ExportOptions& options,
                         Diagnostics& diagnostics);
    /// The options that it heeds, as they are called on the command line: `--scan --stim --bench`.
    std::string_view options = "";
    /// The test bench for that file, of formats that keep it in one of its own; the options have a
    /// bench.
    std::string (*write_bench)(const Netlist& netlist, const ExportOptions& options) = nullptr;
};

/// All formats, in the order in which help shows them.
std::span<const Exporter> exporters();

/// The format of that name; nullptr where there is none.
const Exporter* exporter_named(std::string_view name);

/// The names of all formats, for "did you mean".
std::vector<std::string_view> exporter_names();

}  // namespace grafwire
