#include "formats/exporters.h"

#include <array>

#include "formats/blif/write_blif.h"
#include "formats/dot/write_dot.h"
#include "formats/spice/write_spice.h"
#include "formats/stats/write_stats.h"
#include "formats/verilog/write_verilog.h"
#include "formats/yosys/write_yosys_json.h"

namespace grafwire {

namespace {

template <auto write>
std::string plain(const Netlist& netlist, const ExportOptions&, Diagnostics&) {
    return write(netlist);
}

std::string verilog(const Netlist& netlist, const ExportOptions& options, Diagnostics&) {
    return write_verilog(netlist, options.scan_period);
}

std::string verilog_bench(const Netlist& netlist, const ExportOptions& options) {
    return write_verilog_testbench(netlist, *options.bench, options.scan_period);
}

std::string spice(const Netlist& netlist, const ExportOptions& options, Diagnostics&) {
    return write_spice(netlist, options.bench != nullptr ? *options.bench : idle_bench(),
                       options.scan_period);
}

constexpr std::array<Exporter, 7> table{{
    {"verilog", ".v", "structural Verilog (IEEE 1364-2005)", verilog, "--scan --stim --bench",
     verilog_bench},
    {"spice", ".cir", "ngspice deck of XSPICE digital gates", spice, "--scan --stim --bench"},
    {"blif", ".blif", "Berkeley logic interchange format", plain<write_blif>},
    {"json", ".json", "Yosys JSON netlist", plain<write_yosys_json>},
    {"dot", ".dot", "Graphviz graph, a cluster per module", plain<write_dot>},
    {"stats", ".txt", "cells, feedback loops, fan-out and depth in figures", plain<write_stats>},
    {"text", ".txt", "plain list of the cells, one a line", plain<write_netlist_text>},
}};

}  // namespace

std::span<const Exporter> exporters() {
    return table;
}

const Exporter* exporter_named(std::string_view name) {
    for (const Exporter& exporter : table) {
        if (exporter.name == name) return &exporter;
    }
    return nullptr;
}

std::vector<std::string_view> exporter_names() {
    std::vector<std::string_view> names;
    for (const Exporter& exporter : table) names.push_back(exporter.name);
    return names;
}

}  // namespace grafwire
