#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grafcet/grafcet.h"
#include "netlist/netlist_builder.h"

namespace grafwire {

/// The netlist of a GRAFCET while it is being made: a builder that knows the declared names and
/// what cells are made for.
class ChartNetlist {
  public:
    explicit ChartNetlist(const Grafcet& grafcet);

    ModuleId add_module(std::string name, std::string comment = {}) {
        return builder_.add_module(std::move(name), std::move(comment));
    }
    /// The module and origin that cells added from now on belong to.
    void work_on(ModuleId module, std::uint32_t origin) { place_ = {module, origin}; }
    ModuleId module() const { return place_.module; }
    std::uint32_t origin() const { return place_.origin; }

    std::uint32_t origin_of_step(StepId step);
    std::uint32_t origin_of_transition(TransitionId transition);
    std::uint32_t add_origin(Origin::Kind kind, std::string name, Location where) {
        return builder_.add_origin(kind, std::move(name), where);
    }

    /// A net under exactly this name: for ports.
    NetId add_port_net(std::string_view name) { return builder_.add_net(name); }
    NetId add_net(std::string_view owner, std::string_view role) {
        return builder_.add_inner_net(owner, role);
    }
    void add_input(const std::string& name, NetId net) { builder_.add_input(name, net); }
    void add_output(const std::string& name, NetId net) { builder_.add_output(name, net); }
    void add_var(Observed var) { builder_.add_var(std::move(var)); }
    void add_counter(Observed counter) { builder_.add_counter(std::move(counter)); }
    void set_initial(NetId net, bool value) { builder_.set_initial(net, value); }

    void add_cell(CellType type, NetId output, std::span<const NetId> pins,
                  const CellDetails& details) {
        builder_.add_cell(place_, type, output, pins, details);
    }
    void add_cell(CellType type, NetId output, std::span<const NetId> pins) {
        builder_.add_cell(place_, type, output, pins);
    }
    NetId gate(CellType type, std::span<const NetId> pins, std::string_view owner,
               std::string_view role) {
        return builder_.gate(place_, type, pins, owner, role);
    }
    void drive(NetId output, CellType type, std::span<const NetId> pins) {
        builder_.drive(place_, output, type, pins);
    }
    NetId inverted(NetId net) { return builder_.inverted(place_, net); }
    NetId delayed(NetId net, std::uint32_t levels) { return builder_.delayed(place_, net, levels); }
    NetId low() { return builder_.constant(place_, false); }
    NetId high() { return builder_.constant(place_, true); }
    bool is_low(NetId net) const { return builder_.is_constant(net, false); }
    bool is_high(NetId net) const { return builder_.is_constant(net, true); }

    const Netlist& netlist() const { return builder_.netlist(); }
    Netlist finish() { return builder_.finish(); }

  private:
    const Grafcet& grafcet_;
    NetlistBuilder builder_;
    std::vector<std::uint32_t> step_origins_;
    std::vector<std::uint32_t> transition_origins_;
    Place place_;
};

}  // namespace grafwire
