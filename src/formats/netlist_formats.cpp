// The table of formats. Writers take the options that their rows name; those without options are
// adapted by plain<>.

#include "formats/netlist_formats.h"

#include <fmt/format.h>

#include <array>

#include "formats/blif/read_blif.h"
#include "formats/blif/write_blif.h"
#include "formats/dot/write_dot.h"
#include "formats/spice/write_spice.h"
#include "formats/stats/write_stats.h"
#include "formats/verilog/write_verilog.h"
#include "formats/yosys/read_yosys_json.h"
#include "formats/yosys/write_yosys_json.h"
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
    return write_spice(netlist, options.bench, options.remark, options.delays);
}

constexpr auto table = std::to_array<NetlistFormat>({
    {.name = "verilog",
     .extension = ".v",
     .description = {"structural Verilog (IEEE 1364-2005)", "Verilog structurel (IEEE 1364-2005)"},
     .write = verilog,
     .write_bench = verilog_bench,
     .options = "--scan --stim --bench"},
    {.name = "spice",
     .extension = ".cir",
     .description = {"ngspice deck of XSPICE digital gates",
                     "description ngspice en portes logiques XSPICE"},
     .write = spice,
     .options = "--scan --stim --bench",
     .needs_counted_timers = true},
    {.name = "blif",
     .extension = ".blif",
     .description = {"Berkeley logic interchange format", "format d'échange de Berkeley (BLIF)"},
     .write = plain<write_blif>,
     .read = read_blif},
    {.name = "json",
     .extension = ".json",
     .description = {"Yosys JSON netlist", "câblage en JSON de Yosys"},
     .write = plain<write_yosys_json>,
     .read = read_yosys_json},
    {.name = "dot",
     .extension = ".dot",
     .description = {"Graphviz graph, a cluster per module",
                     "graphe pour Graphviz, un groupe par module"},
     .write = plain<write_dot>},
    {.name = "stats",
     .extension = ".txt",
     .description = {"cells, feedback loops, fan-out and depth in figures",
                     "cellules, boucles, sortances et profondeur en chiffres"},
     .write = plain<write_stats>},
    {.name = "text",
     .extension = ".txt",
     .description = {"plain list of the cells, one a line",
                     "simple liste des cellules, une par ligne"},
     .write = plain<write_netlist_text>},
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

/// The counters that stand for clocked timers are named at the head of the file, since they are
/// most of its cells.
std::string write_netlist(const NetlistFormat& format, const Netlist& netlist,
                          const WriteOptions& options) {
    if (!format.needs_counted_timers || !has_scan_timers(netlist)) {
        return format.write(netlist, options);
    }
    const CountedTimers counted = with_counted_timers(netlist, options.scan_period);
    WriteOptions with_remark = options;
    with_remark.remark = fmt::format(
        "Clocked timers: {} flip-flops that count scans of {}, at most {} for one delay.",
        counted.flip_flops, format_duration(options.scan_period), counted.longest);
    return format.write(counted.netlist, with_remark);
}

}  // namespace grafwire
