#pragma once

#include <vector>

#include "check/witness.h"
#include "grafcet/grafcet.h"
#include "netlist/delay_schedule.h"
#include "netlist/netlist.h"
#include "simulate/simulate.h"

namespace grafwire {

/// A change of a net.
struct NetChange {
    Time at = 0;
    NetId net = no_net;
    Logic value = Logic::unknown;
};

/// All that the nets do in the simulation of a witness, after the initialisation.
struct NetHistory {
    NetHistory() = default;
    /// Simulates the netlist over the stimuli of the witness, up to its end.
    NetHistory(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
               const Witness& witness);

    std::vector<Logic> start;        ///< per net
    std::vector<NetChange> changes;  ///< in their order
    std::size_t first_of_end = 0;    ///< the first change that belongs to the last instant
    std::vector<NetId> oscillating;  ///< where the netlist does not settle

    /// The values of all nets before the last instant.
    std::vector<Logic> before_end() const;
    /// Calls `use(values, at)` with the values of all nets before the last instant (`at`: its
    /// moment) and after every moment of it at which something changes.
    template <typename Use>
    void replay_end(Time end, const Use& use) const {
        std::vector<Logic> values = before_end();
        use(values, end);
        for (std::size_t i = first_of_end; i < changes.size(); ++i) {
            values[index_of(changes[i].net)] = changes[i].value;
            if (i + 1 == changes.size() || changes[i + 1].at != changes[i].at) {
                use(values, changes[i].at);
            }
        }
    }
};

/// A change and those that brought it about, as indices into a history.
struct CausalLink {
    std::size_t change = 0;
    /// Empty where it began: an input changed, or a delay ended.
    std::vector<std::size_t> causes;
};

/// Everything that led to some changes (`targets`, as indices into the history), in the order in
/// which it happened: a tree read from its leaves. What has several parts in it comes once.
/// `schedule`: on the clock of the history.
std::vector<CausalLink> causal_chain(const Netlist& netlist, const CellDelays& delays,
                                     const NetHistory& history,
                                     const std::vector<std::size_t>& targets,
                                     const DelaySchedule& schedule = {});

}  // namespace grafwire
