#pragma once

#include <string>
#include <vector>

#include "equations/equations.h"
#include "netlist/styles/arithmetic.h"
#include "netlist/styles/chart_netlist.h"

namespace grafwire {

/// The gates of one owner, of which those of expressions are numbered.
struct NumberedGates {
    GateMaker gates;
    std::uint32_t count = 0;

    std::string next_role() { return std::to_string(++count); }
};

/// A clocked netlist while it is being made: its ports, its clock and its flip-flops.
class ClockedNetlist {
  public:
    /// Has the inputs, the clock among them, and the complements of Init and AUdur.
    ClockedNetlist(const Grafcet& grafcet, const Equations& equations);
    ClockedNetlist(const ClockedNetlist&) = delete;
    ClockedNetlist& operator=(const ClockedNetlist&) = delete;

    const Grafcet& grafcet;
    const Equations& equations;
    ChartNetlist chart;
    std::vector<NetId> inputs;  ///< as VariableNets has them
    NetId clock = no_net;
    NetId init = no_net;  ///< these three: no_net without modes
    NetId not_init = no_net;
    NetId not_au_dur = no_net;

    /// Drives `output` by a flip-flop, which every rise of the clock gives the value of `data`.
    void add_flip_flop(NetId output, NetId data, bool initial, const GateMaker& gates) const {
        const NetId pins[] = {data, clock};
        gates.add_cell(CellType::flip_flop, output, pins, {logic_of(initial), {}});
    }
    NumberedGates add_module(const std::string& name, std::uint32_t origin) {
        return {chart.add_module(name, origin)};
    }
};

/// What an expression reads at one point of the scan. The same expression is another net in another
/// view: X7 is the flip-flop now, `X7$next` once the situation has been worked out.
struct View {
    bool is_after = false;  ///< time conditions are read as the end of the scan leaves them
    std::vector<NetId> steps;
    std::vector<NetId> outputs;
    std::vector<NetId> vars;
    std::vector<Word> counters;
    std::vector<NetId> made;  ///< per expression; no_net where not yet made
};

/// Turns expressions into gates, each once in every view, and makes what remembers something for
/// them: the flip-flops of edges and the timers of time conditions.
class ClockedLogic {
  public:
    /// Names the nets of the time conditions. The netlist must outlive it.
    explicit ClockedLogic(ClockedNetlist& netlist);

    /// The net of an expression, made in the place where it is first asked for in this view.
    NetId net(View& view, ExprId id, NumberedGates& at);

    /// The edges of the GRAFCET, with operands as the flip-flops hold them; before anything that
    /// reads one.
    void make_edges(View& now);
    /// The timers, with operands as the end of the scan leaves them.
    void make_time_conditions(View& after);

  private:
    NetId make_net(View& view, ExprId id, NumberedGates& at);
    NetId variable_net(const View& view, Variable variable) const;
    NetId time_net(View& view, ExprId id, NumberedGates& at);
    Timing timing_of(std::size_t ordinal) const;
    std::uint32_t time_origin(std::size_t ordinal);

    ClockedNetlist& netlist_;
    const Expressions& pool_;
    std::vector<NetId> edges_;  ///< per edge of the GRAFCET
    std::vector<NetId> times_;  ///< per time condition: the output of its clocked timer
};

}  // namespace grafwire
