#pragma once

#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "grafcet/grafcet.h"
#include "netlist/netlist.h"

namespace grafwire {

/// Puts a netlist together cell by cell. Cells may be added to any module at any time; finish()
/// brings those of a module together.
class NetlistBuilder {
  public:
    enum class ModuleId : std::uint32_t {};

    explicit NetlistBuilder(const Grafcet& grafcet);

    ModuleId add_module(std::string name, std::string comment = {});
    /// The module and origin that cells added from now on belong to.
    void work_on(ModuleId module, std::uint32_t origin);
    ModuleId module() const { return module_; }
    std::uint32_t origin() const { return origin_; }

    std::uint32_t origin_of_step(StepId step);
    std::uint32_t origin_of_transition(TransitionId transition);
    std::uint32_t add_origin(Origin::Kind kind, std::string name, Location where);

    /// A net under exactly this name: for ports.
    NetId add_port_net(std::string_view name);
    /// An inner net, named `owner$role`; where a declared name is in the way, with further `$`.
    NetId add_net(std::string_view owner, std::string_view role);

    void add_cell(CellType type, NetId output, std::span<const NetId> pins);
    void add_memory(CellType type, NetId output, std::span<const NetId> pins, Logic initial,
                    const Timing* timing = nullptr);
    void add_pulse(CellType type, NetId output, NetId input, Time width);

    /// The same with a net of its own. A gate of one pin becomes a buffer or an inverter.
    NetId gate(CellType type, std::span<const NetId> pins, std::string_view owner,
               std::string_view role);
    /// Drives an existing net by a gate; a gate of one pin becomes a buffer or an inverter.
    void drive(NetId output, CellType type, std::span<const NetId> pins);

    /// The complement of a net, made once.
    NetId inverted(NetId net);
    /// The net through so many buffers, each made once.
    NetId delayed(NetId net, std::uint32_t levels);
    NetId low();
    NetId high();
    bool is_low(NetId net) const { return net == low_; }
    bool is_high(NetId net) const { return net == high_; }

    Netlist& netlist() { return netlist_; }

    Netlist finish();

  private:
    struct Companion {
        NetId inverted = no_net;
        NetId delayed = no_net;
    };
    void reserve();
    /// Brings the cells of each module together.
    void sort_cells();
    Companion& companion(NetId net);
    std::uint32_t add_pins(std::span<const NetId> pins);

    const Grafcet& grafcet_;
    Netlist netlist_;
    std::vector<std::uint32_t> cell_modules_;
    std::vector<Companion> companions_;
    std::vector<std::uint32_t> step_origins_;
    std::vector<std::uint32_t> transition_origins_;
    std::unordered_set<std::string> names_with_dollar_;
    std::string scratch_;
    ModuleId module_{};
    std::uint32_t origin_ = 0;
    NetId low_ = no_net;
    NetId high_ = no_net;
};

}  // namespace grafwire
