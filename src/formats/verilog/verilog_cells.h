#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/shared/net_spelling.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"

namespace grafwire {

/// Writes the cells of a netlist as Verilog: a gate primitive each, or an instance of a helper
/// module for what has a memory or knows of time.
class VerilogCells {
  public:
    VerilogCells(std::string& out, const Netlist& netlist, const NetSpelling& nets,
                 const DelayModel& delays);

    void write(const Cell& cell);

    /// The initial values of nets that gates in these modules drive, held at the start of a
    /// simulation.
    void write_initial_values(std::span<const Module> modules);

  private:
    void write_gate(std::string_view primitive, const Cell& cell);
    void write_helper(const Cell& cell);
    void write_parameters(const Cell& cell);

    std::string& out_;
    const Netlist& netlist_;
    const NetSpelling& nets_;
    std::string suffix_;          ///< of instance names
    std::string helpers_;         ///< begins the names of helper modules
    std::string scan_parameter_;  ///< of modules whose timers count scans
    std::string gate_parameter_;  ///< of modules whose cells have delays
    const DelayModel& delays_;
    std::vector<Logic> initial_;  ///< per net: Netlist::initial_values
};

/// Whether cells of the netlist have delays, so that its modules have the parameter GATE_NS. The
/// gates of a clocked netlist have none: they only have to settle between two rises of the clock.
bool has_verilog_delays(const Netlist& netlist);

/// Writes the helper modules for the cells with memory or timing that the netlist has; nothing
/// where it has none.
void append_verilog_helpers(std::string& out, const Netlist& netlist, const DelayModel& delays,
                            std::string_view prefix);

/// Whether the netlist needs the macros GRAFWIRE_START and GRAFWIRE_INSTANT: where it has initial
/// values to hold at first (other than flip-flops') or delays to count.
bool needs_verilog_start(const Netlist& netlist);

/// Writes the defaults of those macros.
void append_verilog_start(std::string& out, std::string_view gate_parameter);

/// Visits the cells of some modules in order.
template <typename Visit>
void for_each_cell(const Netlist& netlist, std::span<const Module> modules, const Visit& visit) {
    for (const Module& module : modules) {
        for (std::uint32_t i = 0; i < module.cell_count; ++i) {
            visit(netlist.cells.items()[module.first_cell + i]);
        }
    }
}

}  // namespace grafwire
