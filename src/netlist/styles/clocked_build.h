#pragma once

#include <fmt/format.h>

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

/// Makes the netlist of the clocked style (see style_clocked.cpp); the members are what its parts
/// share.
class ClockedBuild {
  public:
    explicit ClockedBuild(Equations& equations)
        : equations_(equations),
          grafcet_(*equations.grafcet),
          pool_(equations.expressions),
          builder_(grafcet_),
          links_(transitions_by_step(grafcet_)) {}

    Netlist make() {
        make_ports();
        make_edge_nets();
        make_edges();
        make_clearing();
        make_evolution();
        make_stored();
        make_time_conditions();
        make_outputs();
        Netlist netlist = builder_.finish();
        netlist.has_modes = equations_.options.modes;
        netlist.step_count = grafcet_.steps.size();
        netlist.clock = clock_;
        return netlist;
    }

  private:
    void make_ports();
    void make_counters();
    void make_edge_nets();
    void make_edges();
    void make_clearing();
    NetId frozen_gate(GraphId graph);
    void make_evolution();
    NetId scan_end_without_orders(StepId step);
    void apply_forcing(std::vector<NetId>& situation);
    void apply_enclosures(std::vector<NetId>& situation);
    void make_stored();
    void write_bit(const StoredEquation& stored);
    void write_counter(const StoredEquation& stored);
    NetId trigger(const StoredWrite& write);
    void make_time_conditions();
    void make_outputs();

    NetId net(View& view, ExprId id);
    NetId make_net(View& view, ExprId id);
    NetId variable_net(const View& view, Variable variable) const;
    NetId time_net(View& view, ExprId id);
    Timing timing_of(std::size_t ordinal) const;
    std::uint32_t time_origin(std::size_t ordinal);
    NetId gate(CellType type, std::vector<NetId> pins, std::string_view role) {
        return builder_.gate(type, pins, owner_, role);
    }
    std::string next_role() { return fmt::format("{}", ++role_); }
    void work_on(const std::string& module, std::uint32_t origin, const std::string& comment = {}) {
        builder_.work_on(builder_.add_module(module, comment), origin);
        owner_ = module;
    }
    void flip_flop(NetId output, NetId data, bool initial) {
        const NetId pins[] = {data, clock_};
        builder_.add_cell(CellType::flip_flop, output, pins, {logic_of(initial), {}});
    }

    Equations& equations_;
    const Grafcet& grafcet_;
    const Expressions& pool_;
    ChartNetlist builder_;
    StepTransitions links_;
    std::vector<NetId> inputs_;
    NetId clock_ = no_net;
    NetId not_init_ = no_net;
    NetId not_au_dur_ = no_net;
    View now_;
    View writing_;
    View after_;
    std::vector<NetId> edges_;       ///< per edge of the pool
    std::vector<NetId> times_;       ///< per time condition: the output of its clocked timer
    std::vector<NetId> may_evolve_;  ///< per graph: Tfig, no_net where nothing freezes it
    std::vector<NetId> clearing_;    ///< per transition
    std::vector<NetId> after_step_4_;
    std::string owner_;
    std::uint32_t role_ = 0;
};

}  // namespace grafwire
