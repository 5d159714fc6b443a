// A netlist is made of a chart, or read and made to fit one, and written with what a simulator
// needs beside it: the stimuli as a bench, and what the reference gives under them.

#include "workflow/netlists.h"

#include <unordered_map>
#include <utility>

#include "evolution/run.h"
#include "netlist/styles/messages.h"
#include "text/utf8.h"
#include "workflow/messages.h"

namespace grafwire {

const StyleRow* style_named(std::string_view name) {
    for (const StyleRow& row : style_table) {
        if (row.name == name) return &row;
    }
    return nullptr;
}

CdxForm cdx_form(const NetlistOptions& options) {
    return options.cdx.value_or(style_table[static_cast<std::size_t>(options.style)].default_cdx);
}

std::optional<Localized> conflict_in(const NetlistOptions& options) {
    const bool is_successor = cdx_form(options) == CdxForm::successor;
    if (options.style == Style::handshake && !is_successor) {
        return messages::workflow::handshake_has_successor_form();
    }
    if (options.style != Style::clocked) return std::nullopt;
    if (!options.delays.is_fixed()) return messages::workflow::clocked_has_no_races();
    if (!is_successor) return std::nullopt;
    return messages::workflow::clocked_has_transition_form();
}

std::optional<Netlist> make_netlist(const Chart& chart, const NetlistOptions& options,
                                    Diagnostics& diagnostics) {
    if (const auto conflict = conflict_in(options)) {
        diagnostics.error(code::unsupported_by_style, {}, *conflict);
        return std::nullopt;
    }
    const Equations equations = equations_from(chart.grafcet, {cdx_form(options), options.modes});
    return netlist_from(chart.grafcet, equations, options.style, diagnostics, options.delays);
}

std::optional<Against> against_of(std::string_view path) {
    if (readable_format_of(path) != nullptr) return Against::netlist;
    if (path.ends_with(".awl")) return Against::listing;
    if (path.ends_with(".xml")) return Against::ladder;
    return std::nullopt;
}

PortComparison fit_netlist(const Chart& chart, Netlist& netlist, bool starts_initially) {
    for (std::vector<Port>* side : {&netlist.inputs, &netlist.outputs}) {
        for (Port& port : *side) port.name = normalised(port.name);  // as the chart has its names
    }
    PortComparison ports = compare_ports(chart.grafcet, netlist);
    if (ports.missing_outputs.empty()) {
        adopt_ports(chart.grafcet, netlist);
        netlist.starts_initially = starts_initially;
    }
    return ports;
}

Localized port_table(const PortComparison& ports) {
    return {write_port_table(ports, Language::english), write_port_table(ports, Language::french)};
}

namespace {

/// What the outputs of the netlist are in every row of the trace.
std::vector<Logic> expected_rows(const Netlist& netlist, const Trace& trace) {
    std::unordered_map<std::string_view, std::size_t> column_of;
    for (std::size_t c = 0; c < trace.columns.size(); ++c) {
        if (trace.columns[c].width == 1) column_of[trace.columns[c].name] = c;
    }
    std::vector<std::optional<std::size_t>> columns;
    for (const Port& port : netlist.outputs) {
        const auto column = column_of.find(port.name);
        columns.push_back(column == column_of.end() ? std::nullopt : std::optional(column->second));
    }
    std::vector<Logic> expected;
    for (std::size_t row = 0; row < trace.row_count(); ++row) {
        for (const auto& column : columns) {
            Logic value = Logic::unknown;
            if (column) {
                const bool is_set = trace.values[row * trace.columns.size() + *column] != 0;
                value = is_set ? Logic::one : Logic::zero;
            }
            expected.push_back(value);
        }
    }
    return expected;
}

/// The bench that applies the stimuli; it looks at the outputs at the instants of the reference, or
/// at its scans where there is a clock, and expects what the reference has there.
Bench bench_for(const Grafcet& grafcet, const Netlist& netlist, const Stimuli& stimuli,
                Time period) {
    const RunResult run = netlist.is_clocked() ? run_scans(grafcet, stimuli, period)
                                               : run_until_stable(grafcet, stimuli);
    Bench bench = bench_from(netlist, stimuli, run.trace.times);
    bench.expected = expected_rows(netlist, run.trace);
    return bench;
}

}  // namespace

WrittenNetlist write_netlist(const Chart& chart, const Netlist& netlist,
                             const NetlistFormat& format, const Stimuli* stimuli, Time scan_period,
                             const DelayModel& delays, NetlistHeads heads) {
    WrittenNetlist written;
    WriteOptions options;
    options.scan_period = scan_period;
    options.delays = delays;
    if (stimuli != nullptr) {
        options.bench = bench_for(chart.grafcet, netlist, *stimuli, scan_period);
        options.head = std::move(heads.bench);
        written.bench = write_netlist_bench(format, netlist, options);
    }
    options.head = std::move(heads.netlist);
    written.text = write_netlist(format, netlist, options);
    return written;
}

}  // namespace grafwire
