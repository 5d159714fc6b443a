#pragma once

#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "netlist/netlist_builder.h"

namespace grafwire {

/// Where the variables of a GRAFCET are found, by their index.
struct VariableNets {
    std::vector<NetId> inputs;  ///< declared inputs, Init, AUdur, AUdoux (no_net without modes)
    std::vector<NetId> steps;
    std::vector<NetId> outputs;
    std::vector<NetId> vars;

    NetId control(const Grafcet& grafcet, ControlInput input) const {
        return inputs[grafcet.inputs.size() + static_cast<std::size_t>(input)];
    }
};

/// The netlist of a GRAFCET while it is being made: a builder that keeps declared names free, and
/// what its cells are made for.
class ChartNetlist {
  public:
    explicit ChartNetlist(const Grafcet& grafcet);

    NetlistBuilder& builder() { return builder_; }
    /// The gates of the module `inputs`, which is the first one; their origin is the first as well,
    /// of no kind.
    GateMaker at_inputs() { return {builder_, {ModuleId{0}, 0}, {}}; }
    /// The gates of a further module, named after it.
    GateMaker add_module(const std::string& name, std::uint32_t origin) {
        return {builder_, {builder_.add_module(name), origin}, name};
    }

    std::uint32_t origin_of(StepId step);
    std::uint32_t origin_of(TransitionId transition);
    std::uint32_t origin_of(OutputId output);
    std::uint32_t origin_of(VarId var);
    std::uint32_t origin_of(CounterId counter);
    std::uint32_t origin_of(GraphId graph);
    /// Of an edge or a time condition, read at `where`.
    std::uint32_t origin_of(const Expressions& pool, ExprId id, Location where);

    // Ports and observed nets under the names declared; each function is called once.

    std::vector<NetId> add_inputs(bool modes);
    std::vector<NetId> add_steps();
    std::vector<NetId> add_outputs();
    std::vector<NetId> add_vars();
    /// All of them.
    VariableNets add_ports(bool modes) {
        // Braces keep this order.
        return {add_inputs(modes), add_steps(), add_outputs(), add_vars()};
    }

    /// `clock`: no_net for an asynchronous netlist.
    Netlist finish(bool modes, NetId clock);

  private:
    const Grafcet& grafcet_;
    NetlistBuilder builder_;
    std::vector<std::uint32_t> step_origins_;
    std::vector<std::uint32_t> transition_origins_;
};

}  // namespace grafwire
