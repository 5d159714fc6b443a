#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/compare_ports.h"
#include "equations/equations.h"
#include "formats/netlist_formats.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"
#include "netlist/styles/styles.h"
#include "text/diagnostics.h"
#include "text/time.h"
#include "trace/stimuli.h"
#include "workflow/chart.h"

namespace grafwire {

/// Which netlist to make of a GRAFCET.
struct NetlistOptions {
    Style style = Style::nand;
    std::optional<CdxForm> cdx;  ///< none: the style's own
    bool modes = true;           ///< with Init, AUdur and AUdoux
    DelayModel delays{};         ///< how long its gates will take
};

/// The style of that name; nullptr where there is none.
const StyleRow* style_named(std::string_view name);

/// The form of CDX that results.
CdxForm cdx_form(const NetlistOptions& options);

/// Why these options do not go together; none where they do.
std::optional<Localized> conflict_in(const NetlistOptions& options);

/// The netlist of a chart. What the style cannot hold goes into `diagnostics`, with its place in
/// the chart; empty then.
std::optional<Netlist> make_netlist(const Chart& chart, const NetlistOptions& options,
                                    Diagnostics& diagnostics);

/// What can be compared with a chart: a netlist in a format that has a reader, or a program.
enum class Against { netlist, listing, ladder };

/// What a file holds, by its extension; empty where it is none of these.
std::optional<Against> against_of(std::string_view path);

/// Gives the ports of a netlist from elsewhere the order of the chart, and settles whether its
/// steps start in the initial situation where nothing sets them. Nothing is changed where an X or
/// an output of the chart is missing.
PortComparison fit_netlist(const Chart& chart, Netlist& netlist, bool starts_initially);

/// The table of all ports, for people.
Localized port_table(const PortComparison& ports);

/// A netlist as a file, and the test bench that drives it, of formats that have one.
struct WrittenNetlist {
    std::string text;
    std::string bench;
};

/// What each of them says of how it was made (netlist_heads).
struct NetlistHeads {
    std::vector<std::string> netlist{};
    std::vector<std::string> bench{};
};

/// Writes the netlist of a chart. `stimuli`: what a deck or a test bench applies, or none;
/// `scan_period`: what clocked timers count with; `delays`: how long the gates take; `heads`: what
/// the files say at their heads.
WrittenNetlist write_netlist(const Chart& chart, const Netlist& netlist,
                             const NetlistFormat& format, const Stimuli* stimuli, Time scan_period,
                             const DelayModel& delays, NetlistHeads heads = {});

}  // namespace grafwire
