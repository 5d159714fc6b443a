// A netlist written to a file and read back does the same under the same stimuli.

#include <doctest/doctest.h>

#include "check/compare_ports.h"
#include "formats/blif/read_blif.h"
#include "formats/blif/write_blif.h"
#include "formats/yosys/read_yosys_json.h"
#include "formats/yosys/write_yosys_json.h"
#include "properties/netlist_in.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "simulate/simulate.h"

namespace grafwire::testing {

namespace {

/// The trace as text, without vars and counters, whose nets a file does not name.
std::string trace_of(const Grafcet& grafcet, const Netlist& netlist, const Stimuli& stimuli) {
    const SimulateResult result = simulate(grafcet, netlist, cell_delays(netlist, {}), stimuli, {});
    Trace visible;
    const std::size_t columns =
        grafcet.all_input_count() + grafcet.steps.size() + grafcet.outputs.size();
    visible.columns.assign(result.trace.columns.begin(),
                           result.trace.columns.begin() + static_cast<std::ptrdiff_t>(columns));
    visible.times = result.trace.times;
    for (std::size_t row = 0; row < result.trace.row_count(); ++row) {
        const auto begin = result.trace.values.begin() +
                           static_cast<std::ptrdiff_t>(row * result.trace.columns.size());
        visible.values.insert(visible.values.end(), begin,
                              begin + static_cast<std::ptrdiff_t>(columns));
    }
    std::string text = write_csv(visible);
    if (result.unsettled_at) text += "unsettled at " + format_milliseconds(*result.unsettled_at);
    return text;
}

template <typename Write, typename Read>
std::string file_keeps_behaviour(const Grafcet& grafcet, const Netlist& netlist,
                                 const Stimuli& stimuli, const Write& write, const Read& read) {
    const SourceFile file{"netlist", write(netlist)};
    Diagnostics diagnostics;
    std::optional<Netlist> again = read(file, diagnostics);
    if (!again) return "cannot be read back:\n" + format_diagnostics(diagnostics, file);
    if (const std::string fault = fault_of(*again); !fault.empty()) return fault;
    const PortComparison ports = compare_ports(grafcet, *again);
    if (!ports.fits()) return "other ports:\n" + write_port_table(ports, Language::english);
    adopt_ports(grafcet, *again);
    const std::string before = trace_of(grafcet, netlist, stimuli);
    const std::string after = trace_of(grafcet, *again, stimuli);
    if (before != after) return "before\n" + before + "after\n" + after + "file\n" + file.text;
    return {};
}

std::string files_keep_behaviour(const RandomCase& item) {
    const auto grafcet = read_grafcet(item.chart);
    const auto stimuli = read_stimuli(item.stimuli, *grafcet);
    for (const StyleRow& row : style_table) {
        const auto netlist = netlist_in(*grafcet, row.style);
        if (!netlist) continue;
        if (const std::string in_memory = fault_of(*netlist); !in_memory.empty()) {
            return std::string(row.name) + ": " + in_memory;
        }
        std::string fault =
            file_keeps_behaviour(*grafcet, *netlist, *stimuli, write_yosys_json, read_yosys_json);
        if (!fault.empty()) return "JSON of style " + std::string(row.name) + ": " + fault;
        fault = file_keeps_behaviour(*grafcet, *netlist, *stimuli, write_blif, read_blif);
        if (!fault.empty()) return "BLIF of style " + std::string(row.name) + ": " + fault;
    }
    return {};
}

}  // namespace

TEST_CASE("a netlist that is written to a file and read back behaves alike") {
    Features features;
    check_property(files_keep_behaviour, features, 1'300'000, 150);
    features.counters = 0;
    check_property(files_keep_behaviour, features, 1'400'000, 150);
}

}  // namespace grafwire::testing
