#pragma once

#include <cstdint>
#include <vector>

#include "netlist/netlist.h"
#include "simulate/simulator.h"

namespace grafwire {

/// Ends the delays of timers at the instants at which they fall due, as the reference does: the
/// inputs change first, then the delays that end exactly now take effect, except those whose
/// operand no longer asks for it; then the gates work. The netlist must outlive it.
class DelayEnds {
  public:
    explicit DelayEnds(const Netlist& netlist);

    /// At the beginning of an instant, once its inputs are set and before anything settles: every
    /// timer whose delay is due takes the value that the delay leads to if its operand, read under
    /// the new inputs while all memories hold what they have, still asks for it.
    /// Whether any did.
    bool take_effect(Simulator& simulator, Time now);

    /// Lets the netlist settle at an instant. A delay that is due and whose operand asks for it
    /// once all is settled ends then.
    Settling settle(Simulator& simulator, Time now);

  private:
    Logic read(const Simulator& simulator, NetId net);
    Logic gate_output(const Cell& cell) const;
    NetId shown_by(NetId net) const;
    bool keeps_value(CellId cell) const;
    void find_registers();
    void hold_edges();
    void add_timers_before(NetId net, std::vector<std::uint8_t>& seen);

    const Netlist& netlist_;
    Table<NetId, CellId> drivers_;
    std::vector<std::uint8_t> is_held_;  ///< per cell, 1 where its output is held
    /// Per net: the register that takes it at the rise of the clock, where that holds an X, an
    /// output, a var or a counter; else no_net.
    std::vector<NetId> register_of_;
    std::vector<CellId> timers_;                  ///< in the order of Simulator::timers
    std::vector<std::uint32_t> number_of_timer_;  ///< per cell: its place there
    std::vector<std::uint32_t> order_;            ///< timers, each after those its operand reads
    /// What read() has worked out: per net its value, or `unread`.
    static constexpr std::uint8_t unread = 3;
    std::vector<std::uint8_t> values_;
    std::vector<NetId> worked_out_;
    std::vector<NetId> waiting_;
};

}  // namespace grafwire
