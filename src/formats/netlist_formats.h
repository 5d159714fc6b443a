#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/shared/bench.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"
#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What a file may say beyond the netlist; a format takes what its row says that it heeds.
struct WriteOptions {
    /// The time between two rises of the clock of a clocked netlist.
    Time scan_period = 10 * millisecond;
    /// How long the gates of an asynchronous netlist take.
    DelayModel delays{};
    /// The stimuli; by default all inputs are 0 after the initialisation.
    Bench bench = idle_bench();
    /// What the file says of a netlist made of a GRAFCET before anything else, line by line; the
    /// first line is the title, which the number of cells is put behind. Empty for a netlist from
    /// elsewhere: its name is the title, and what its nets are called is nobody's to explain.
    std::vector<std::string> head{};
};

/// One row per format. Every format can hold every netlist, and the same netlist gives the same
/// bytes.
struct NetlistFormat {
    std::string_view name;
    std::string_view extension;  ///< of its files, with the dot
    Message<> description;       ///< for `--help`
    /// The file without its head. Call write_netlist(), which puts the head in front and does what
    /// `needs_counted_timers` asks for.
    std::string (*write)(const Netlist& netlist, const WriteOptions& options);
    /// The netlist of such a file, or messages with their places; nullptr where the format is
    /// written only.
    std::optional<Netlist> (*read)(const SourceFile& source, Diagnostics& diagnostics) = nullptr;
    /// A second file, which applies WriteOptions::bench to the netlist in the first, without its
    /// head (write_netlist_bench()): of formats that heed `--bench` and do not hold the stimuli in
    /// the file itself.
    std::string (*write_bench)(const Netlist& netlist, const WriteOptions& options) = nullptr;
    /// The options that it heeds, as they are called on the command line: `--scan --stim --bench`.
    std::string_view options = "";
    /// The format has no clocked timers: counters of flip-flops stand in their place.
    bool needs_counted_timers = false;
    /// Adds a line that is a comment, with its end; nullptr where the format has no comments, and
    /// so no head.
    void (*add_comment)(std::string& out, std::string_view line) = nullptr;
};

/// All formats, in the order in which help shows them.
std::span<const NetlistFormat> netlist_formats();

/// The format of that name; nullptr where there is none.
const NetlistFormat* netlist_format_named(std::string_view name);

/// The names of all formats, for "did you mean".
std::vector<std::string_view> netlist_format_names();

/// The format with a reader whose extension a file has; nullptr where there is none.
const NetlistFormat* readable_format_of(std::string_view path);

/// The file of a netlist in a format.
std::string write_netlist(const NetlistFormat& format, const Netlist& netlist,
                          const WriteOptions& options = {});

/// The bench that applies WriteOptions::bench to it; empty of formats that keep none in a file of
/// its own.
std::string write_netlist_bench(const NetlistFormat& format, const Netlist& netlist,
                                const WriteOptions& options);

}  // namespace grafwire
