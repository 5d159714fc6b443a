#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "netlist/netlist.h"

namespace grafwire::testing {

/// The value of every net of a small netlist, one bit each.
struct NetValues {
    static constexpr std::size_t most_nets = 512;
    std::array<std::uint64_t, most_nets / 64> words{};

    bool get(NetId net) const {
        return (words[index_of(net) / 64] >> (index_of(net) % 64) & 1) != 0;
    }
    void set(NetId net, bool value) {
        const std::uint64_t bit = std::uint64_t{1} << (index_of(net) % 64);
        words[index_of(net) / 64] =
            value ? words[index_of(net) / 64] | bit : words[index_of(net) / 64] & ~bit;
    }
    bool operator==(const NetValues&) const = default;
    std::size_t hash() const;
};

/// Which gates may fire at one instant.
enum class Firing {
    one_gate,       ///< one after the other: all orders
    several_gates,  ///< any of the excited ones at once as well: the general multiple-winner model
};

/// Everything that a netlist of gates and timers can do when no delay of a gate is known but that
/// it is finite. A gate is excited while its output is not what its inputs say; any excited gate
/// may fire next. Nothing is left out to save time, and nothing is shared with the product: this is
/// what a netlist is held against that claims to be right under any delay.
///
/// A timer falls like a gate. Its rise is an event: time is longer than any delay of a gate.
class GateOrders {
  public:
    /// The netlist is one that `why_not` has nothing against, and outlives this.
    explicit GateOrders(const Netlist& netlist);

    /// Why a netlist cannot be run here; empty where it can.
    static std::string why_not(const Netlist& netlist);

    struct Outcomes {
        std::vector<NetValues> stable;  ///< all situations in which no gate is excited
        bool may_oscillate = false;     ///< a cycle that no gate has to leave
        bool is_complete = true;        ///< false: there were more states than asked for
        std::size_t states = 0;
    };
    Outcomes outcomes(const NetValues& start, Firing firing, std::size_t most_states) const;

    /// The inputs are given and the nets with an initial value have it; every other net that
    /// follows from these whatever the delays are. The rest is 0, and said in `unknown`.
    NetValues power_up(const NetValues& inputs, std::vector<NetId>& unknown) const;

    struct Timer {
        NetId operand = no_net;
        NetId output = no_net;
        std::uint32_t condition = 0;  ///< its number in the chart
    };
    const std::vector<Timer>& timers() const { return timers_; }

  private:
    struct Gate {
        CellType type = CellType::buffer;
        NetId output = no_net;
        std::vector<std::pair<std::size_t, std::uint64_t>> pins;  ///< words and masks
        std::vector<NetId> pin_nets;
    };
    bool wanted(const Gate& gate, const NetValues& values) const;
    std::vector<std::uint32_t> excited(const NetValues& values) const;

    const Netlist& netlist_;
    std::vector<Gate> gates_;
    std::vector<Timer> timers_;
};

}  // namespace grafwire::testing
