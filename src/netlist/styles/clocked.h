#pragma once

#include <string>
#include <vector>

#include "equations/equations.h"
#include "netlist/styles/arithmetic.h"
#include "netlist/styles/chart_netlist.h"

namespace grafwire {

/// What an expression reads at one point of the scan.
struct View {
    bool is_after = false;
    std::vector<NetId> steps;
    std::vector<NetId> outputs;
    std::vector<NetId> vars;
    std::vector<Word> counters;
    std::vector<NetId> made;  ///< per expression; no_net where not yet made
};

/// The gates of one owner, of which those of expressions are numbered.
struct NumberedGates {
    GateMaker gates;
    std::uint32_t count = 0;

    std::string next_role() { return std::to_string(++count); }
};

/// What the parts of a clocked netlist share while it is being made; style_clocked.cpp tells what
/// they are.
class ClockedBuild {
  public:
    ClockedBuild(const Grafcet& grafcet, const Equations& equations);
    ClockedBuild(const ClockedBuild&) = delete;
    ClockedBuild& operator=(const ClockedBuild&) = delete;

    const Grafcet& grafcet;
    const Equations& equations;
    ChartNetlist chart;
    NetId clock = no_net;
    NetId init = no_net;  ///< these three: no_net without modes
    NetId not_init = no_net;
    NetId not_au_dur = no_net;
    View now;
    View writing;
    View after;
    std::vector<NetId> clearing;  ///< per transition, once make_clearing has been called

    /// The net of an expression, made in the place where it is first asked for in this view.
    NetId net(View& view, ExprId id, NumberedGates& at);
    void add_flip_flop(NetId output, NetId data, bool initial, const GateMaker& gates) const {
        const NetId pins[] = {data, clock};
        gates.add_cell(CellType::flip_flop, output, pins, {logic_of(initial), {}});
    }
    NumberedGates add_module(const std::string& name, std::uint32_t origin) {
        return {chart.add_module(name, origin)};
    }

    // Expressions, edges and time conditions: clocked_logic.cpp. Edges come before all that reads
    // them, time conditions after what they read.

    void make_edges();
    void make_time_conditions();

  private:
    void add_ports();
    void add_counters();
    NetId make_net(View& view, ExprId id, NumberedGates& at);
    NetId variable_net(const View& view, Variable variable) const;
    NetId time_net(View& view, ExprId id, NumberedGates& at);
    Timing timing_of(std::size_t ordinal) const;
    std::uint32_t time_origin(std::size_t ordinal);

    const Expressions& pool_;
    std::vector<NetId> inputs_;
    std::vector<NetId> edges_;  ///< per edge of the GRAFCET
    std::vector<NetId> times_;  ///< per time condition: the output of its clocked timer
};

/// The situation after a scan, clocked_evolution.cpp: `clearing`, then the nets `writing.steps` and
/// the flip-flops of the X variables.
void make_evolution(ClockedBuild& build);

/// Stored outputs, vars and counters, clocked_stored.cpp: registers, and `after`, what they will
/// hold.
void make_registers(ClockedBuild& build);

}  // namespace grafwire
