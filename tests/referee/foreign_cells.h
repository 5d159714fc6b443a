#pragma once

#include <string_view>
#include <vector>

#include "netlist/netlist.h"

namespace grafwire::testing {

/// Adds cells to a finished netlist, in its last module.
class ForeignCells {
  public:
    explicit ForeignCells(Netlist& netlist) : netlist_(netlist) {}

    /// A new cell; a memory starts at 0. `width`: of a pulse cell. Returns its output.
    NetId add(CellType type, const std::vector<NetId>& pins, Time width = 0);
    /// So many buffers one behind the other.
    NetId delayed(NetId net, std::size_t buffers);
    /// One more pin for the cell that drives a net.
    void lead_to(NetId pin, NetId driven);
    /// The net of that name, which must be there.
    NetId net(std::string_view name) const;

  private:
    void set_pins(Cell& cell, const std::vector<NetId>& pins);

    Netlist& netlist_;
};

}  // namespace grafwire::testing
