// The table of formats. Writers take the options that their rows name; those without options are
// adapted by plain<>.

#include "formats/netlist_formats.h"

#include <fmt/format.h>

#include <array>

#include "formats/blif/read_blif.h"
#include "formats/blif/write_blif.h"
#include "formats/dot/write_dot.h"
#include "formats/shared/append.h"
#include "formats/spice/write_spice.h"
#include "formats/stats/write_stats.h"
#include "formats/verilog/verilog_names.h"
#include "formats/verilog/write_verilog.h"
#include "formats/yosys/read_yosys_json.h"
#include "formats/yosys/write_yosys_json.h"
#include "netlist/net_roles.h"
#include "netlist/passes/counted_timers.h"

namespace grafwire {

namespace {

template <auto write>
std::string plain(const Netlist& netlist, const WriteOptions&) {
    return write(netlist);
}

std::string verilog(const Netlist& netlist, const WriteOptions& options) {
    return write_verilog(netlist, options.scan_period, options.delays);
}

std::string verilog_bench(const Netlist& netlist, const WriteOptions& options) {
    return write_verilog_bench(netlist, options.bench, options.scan_period, options.delays);
}

std::string spice(const Netlist& netlist, const WriteOptions& options) {
    return write_spice(netlist, options.bench, options.delays);
}

/// A line behind a sign that begins comments.
template <char... sign>
void behind_sign(std::string& out, std::string_view line) {
    (out.push_back(sign), ...);
    out.push_back(' ');
    append_comment(out, line);
    out.push_back('\n');
}

constexpr auto table = std::to_array<NetlistFormat>({
    {.name = "verilog",
     .extension = ".v",
     .description = {"structural Verilog (IEEE 1364-2005)", "Verilog structurel (IEEE 1364-2005)"},
     .write = verilog,
     .write_bench = verilog_bench,
     .options = "--scan --stim --bench",
     .add_comment = append_verilog_comment},
    {.name = "spice",
     .extension = ".cir",
     .description = {"ngspice deck of XSPICE digital gates",
                     "description ngspice en portes logiques XSPICE"},
     .write = spice,
     .options = "--scan --stim --bench",
     .needs_counted_timers = true,
     .add_comment = behind_sign<'*'>},
    {.name = "blif",
     .extension = ".blif",
     .description = {"Berkeley logic interchange format", "format d'échange de Berkeley (BLIF)"},
     .write = plain<write_blif>,
     .read = read_blif,
     .add_comment = behind_sign<'#'>},
    {.name = "json",
     .extension = ".json",
     .description = {"Yosys JSON netlist", "câblage en JSON de Yosys"},
     .write = plain<write_yosys_json>,
     .read = read_yosys_json},
    {.name = "dot",
     .extension = ".dot",
     .description = {"Graphviz graph, a cluster per module",
                     "graphe pour Graphviz, un groupe par module"},
     .write = plain<write_dot>,
     .add_comment = behind_sign<'/', '/'>},
    {.name = "stats",
     .extension = ".txt",
     .description = {"cells, feedback loops, fan-out and depth in figures",
                     "cellules, boucles, sortances et profondeur en chiffres"},
     .write = plain<write_stats>},
    {.name = "text",
     .extension = ".txt",
     .description = {"plain list of the cells, one a line",
                     "simple liste des cellules, une par ligne"},
     .write = plain<write_netlist_text>,
     .add_comment = behind_sign<'#'>},
});

}  // namespace

std::span<const NetlistFormat> netlist_formats() {
    return table;
}

const NetlistFormat* netlist_format_named(std::string_view name) {
    for (const NetlistFormat& format : table) {
        if (format.name == name) return &format;
    }
    return nullptr;
}

std::vector<std::string_view> netlist_format_names() {
    std::vector<std::string_view> names;
    for (const NetlistFormat& format : table) names.push_back(format.name);
    return names;
}

const NetlistFormat* readable_format_of(std::string_view path) {
    for (const NetlistFormat& format : table) {
        if (format.read != nullptr && path.ends_with(format.extension)) return &format;
    }
    return nullptr;
}

namespace {

/// The head with the title as a sentence: what the file holds of it.
std::string written_head(const NetlistFormat& format, const Netlist& netlist,
                         const WriteOptions& options, std::string_view contents) {
    std::string text;
    if (format.add_comment == nullptr) return text;
    const std::string& title = options.head.empty() ? netlist.name : options.head.front();
    format.add_comment(text, fmt::format("{}: {}.", title, contents));
    for (std::size_t i = 1; i < options.head.size(); ++i) {
        format.add_comment(text, options.head[i]);
    }
    return text;
}

/// What the names of inner nets say, as far as they occur.
void add_legend(const NetlistFormat& format, const Netlist& netlist, std::string& text) {
    const std::vector<std::string> legend = legend_of_roles(netlist);
    if (legend.empty()) return;
    format.add_comment(text, "Inner nets are called OWNER$ROLE (N: a number, T: a transition):");
    for (const std::string& line : legend) format.add_comment(text, "  " + line);
}

std::string written_file(const NetlistFormat& format, const Netlist& netlist,
                         const WriteOptions& options, std::string_view remark) {
    std::string text =
        written_head(format, netlist, options, fmt::format("{} cells", netlist.cells.size()));
    if (format.add_comment != nullptr) {
        if (!remark.empty()) format.add_comment(text, remark);
        if (!options.head.empty()) add_legend(format, netlist, text);
    }
    return text + format.write(netlist, options);
}

}  // namespace

/// The counters that stand for clocked timers are named at the head of the file, since they are
/// most of its cells.
std::string write_netlist(const NetlistFormat& format, const Netlist& netlist,
                          const WriteOptions& options) {
    if (!format.needs_counted_timers || !has_scan_timers(netlist)) {
        return written_file(format, netlist, options, {});
    }
    const CountedTimers counted = with_counted_timers(netlist, options.scan_period);
    return written_file(
        format, counted.netlist, options,
        fmt::format("Clocked timers: {} flip-flops that count scans of {}, at most {} for one "
                    "delay.",
                    counted.flip_flops, format_duration(options.scan_period), counted.longest));
}

std::string write_netlist_bench(const NetlistFormat& format, const Netlist& netlist,
                                const WriteOptions& options) {
    if (format.write_bench == nullptr) return {};
    return written_head(format, netlist, options, "test bench") +
           format.write_bench(netlist, options);
}

}  // namespace grafwire
