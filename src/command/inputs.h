#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "command/chart_files.h"
#include "command/command_line.h"
#include "command/files.h"
#include "command/option_uses.h"
#include "command/standard_error.h"
#include "netlist/delay_schedule.h"
#include "netlist/netlist.h"
#include "trace/stimuli.h"
#include "trace/waveform.h"
#include "workflow/chart.h"
#include "workflow/drawings.h"
#include "workflow/netlists.h"
#include "workflow/programs.h"

namespace grafwire {

// What commands read. All messages are shown; the results are empty after an error.

/// A GRAFCET from a file; the file may be one that was looked for among others. With `--strict`
/// warnings are errors.
std::optional<Chart> load_chart(const std::string& path, const CommandLine& line);
std::optional<Chart> load_chart(const ChartFile& file, const CommandLine& line);
/// The same without that option.
std::optional<Chart> load_chart(const std::string& path);

/// Shows what the structure of a GRAFCET puts at risk in asynchronous wiring with this form of CDX;
/// false where that is an error.
[[nodiscard]] bool show_wiring_warnings(const Chart& chart, CdxForm cdx, const CommandLine& line);

/// The messages with every warning an error, with `--strict`.
Diagnostics as_asked(Diagnostics diagnostics, const CommandLine& line);

/// Stimuli for a GRAFCET.
std::optional<Stimuli> load_stimuli(const std::string& path, const Grafcet& grafcet);

/// How long single gates of the netlist take (`.delays`). Wires that the file names become cells of
/// the netlist.
std::optional<DelaySchedule> load_delays(const std::string& path, Netlist& netlist);

/// Whether both are to come from standard input, which can be read only once; shows it if so.
bool share_standard_input(const std::string& path, const std::string& stimuli);
bool share_standard_input(const std::vector<std::string>& paths, const std::string& stimuli);

/// A netlist from a file whose extension is that of a format with a reader.
std::optional<Netlist> load_netlist(const std::string& path);

/// A table of assignment, with the text that it was read from; an S7-200 listing for a controller.
struct LoadedAssignment {
    SourceFile source;
    s7::IoAssignment assignment;
};
std::optional<LoadedAssignment> load_assignment(const std::string& path);
std::optional<s7::Listing> load_listing(const std::string& path, s7::Cpu cpu,
                                        const s7::IoAssignment* io);

/// A duration option: its value. An empty one is none.
struct Period {
    std::optional<Time> value;
    bool is_wrong = false;  ///< it is no positive duration; shown
};
Period parse_period(const std::string& text);

/// Whether a run with one row per scan is refused, since its trace would take more memory than
/// there may be; shows it if so. No period: it is none.
bool has_too_many_scans(const Grafcet& grafcet, const Stimuli& stimuli, const Period& period);

/// A moment of a run: a duration, or 0. Empty, and shown, where it is neither.
std::optional<Time> parse_moment(const std::string& text);

/// The row of that name in a table; nullptr where there is none.
template <typename Rows>
auto row_named(const Rows& rows, std::string_view name) -> decltype(&*std::begin(rows)) {
    for (const auto& row : rows) {
        if (row.name == name) return &row;
    }
    return nullptr;
}

/// The same of a table of formats, where it is shown that there is none, with the nearest name.
template <typename Row>
const Row* format_named(std::span<const Row> rows, std::string_view name);

/// The options that say which netlist to make; shared by several commands.
struct NetlistRequest {
    std::string style;
    std::string cdx;
    std::string modes = "on";
    std::string delay{DelayModel().name};
    bool interlock = false;
    void declare(const CommandLine& line, bool style_is_required);
    /// All but the style.
    void declare_equations(const CommandLine& line);
    void declare_delay(const CommandLine& line);
    NetlistOptions options() const;
    DelayModel delays() const;
    bool is_handshake() const { return options().style == Style::handshake; }
};

/// The chart that wiring is made of: with interlocks, where they are asked for.
struct ChartToWire {
    Chart chart;
    std::vector<std::string> interlocks{};  ///< a sentence each, in English
};

/// The same of a chart that has been read. The interlocks are shown, and what they leave.
ChartToWire to_wire(Chart chart, const NetlistRequest& request);

/// Warns of what depends on the order in which transitions clear, in the style to which that
/// matters. Not of an interlocked chart, which to_wire() has looked at.
void warn_of_order(const Chart& chart, const NetlistRequest& request);

/// The generated netlist.
std::optional<Netlist> make_netlist(const Chart& chart, const NetlistRequest& request);

/// Where the trace and the waveform of a run go. A waveform is in VCD, or in FST where its file is
/// called so. Beside a waveform `OUT.vcd` or `OUT.fst` goes what GTKWave shows of it, `OUT.gtkw`,
/// unless there is one already: the user may have changed it.
struct TraceOutput {
    std::string csv;
    std::string vcd;
    std::string format = "csv";

    void declare(const CommandLine& line);
    /// Whether something is asked for in a format that is not written: a trace in one that is not
    /// in the table, a waveform in FST where this program cannot. Shows it if so. To be asked
    /// before anything is run.
    bool is_refused() const;
    /// Of commands whose trace belongs to a chart: also its format.
    void declare_format(const CommandLine& line);
    /// The format, once it is not refused, for the table of options.
    ChosenFormat chosen() const;
    /// Whether the format is a picture, which shows causes as well.
    bool is_picture() const;
    /// The trace in that format; CSV that goes to a terminal is a table.
    std::string text_of(const ShownRun& run, const Chart& chart, Language language) const;
    /// `explained`: standard output is taken by words, and the trace goes only where it was asked
    /// to. False, after having said why, where the waveform cannot be made.
    [[nodiscard]] bool add_files(OutputFiles& files, std::string trace, const Waveform& waveform,
                                 bool explained = false) const;
};

// Implementation.

void complain_of_format(std::string_view name, const std::vector<std::string_view>& names);

template <typename Row>
const Row* format_named(std::span<const Row> rows, std::string_view name) {
    if (const Row* row = row_named(rows, name)) return row;
    std::vector<std::string_view> names;
    for (const Row& row : rows) names.push_back(row.name);
    complain_of_format(name, names);
    return nullptr;
}

}  // namespace grafwire
