#pragma once

#include <vector>

#include "netlist/styles/asynchronous.h"

namespace grafwire {

/// Per step: 1 where its activation, or the clearing of a transition before it, writes a stored
/// output or var.
std::vector<std::uint8_t> writing_steps(const Equations& equations);

/// Builds one netlist; the members are what its parts share.
class AsynchronousFrame {
  public:
    AsynchronousFrame(Equations& equations, PhaseMaker make_phase, Time set_time)
        : equations_(equations),
          grafcet_(*equations.grafcet),
          builder_(grafcet_),
          logic_(equations, builder_),
          build_{equations,
                 builder_,
                 logic_,
                 transitions_by_step(grafcet_),
                 std::vector<NetId>(grafcet_.transitions.size(), no_net),
                 writing_steps(equations)},
          make_phase_(make_phase) {
        logic_.pulse_width = set_time;
    }

    Netlist make() {
        make_ports();
        make_steps();
        make_outputs();
        make_stored();
        Netlist netlist = builder_.finish();
        netlist.has_modes = equations_.options.modes;
        netlist.step_count = grafcet_.steps.size();
        return netlist;
    }

  private:
    void make_ports();
    void make_steps();
    PhaseSignals phase_of(StepId step);
    std::vector<std::vector<NetId>> cdx_of(StepId step);
    void make_outputs();
    void make_stored();
    void make_latch(const StoredEquation& stored);
    void make_hold(const StoredEquation& stored);
    NetId trigger_net(const StoredWrite& write);
    NetId stored_net(Variable target) const;

    Equations& equations_;
    const Grafcet& grafcet_;
    ChartNetlist builder_;
    LogicBuilder logic_;
    AsynchronousBuild build_;
    PhaseMaker make_phase_;
    NetId init_ = no_net;
    NetId au_dur_ = no_net;
    NetId au_doux_ = no_net;
    std::vector<NetId> held_outputs_;
    std::vector<NetId> held_vars_;
};

}  // namespace grafwire
