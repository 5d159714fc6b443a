// The changes of one instant are kept while the simulation runs, and what made each gate change is
// found through causal_chain. That knows all changes that had a part in it, since a wrong value has
// to be followed to where it began; here only what the gate switched on counts, and of a flip-flop
// the edge of the clock.
//
// A netlist that does not settle repeats itself; so its instant is cut.

#include "explain/instant_detail.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "text/table.h"

namespace grafwire {

namespace {

/// Moments of an instant in which the netlist does not settle.
constexpr std::size_t most_moments = 64;
/// A bound for memory alone.
constexpr std::size_t most_kept = 1'000'000;

/// The links of every change as causes.
class DirectCauses {
  public:
    DirectCauses(const Netlist& netlist, const std::vector<NetChange>& changes)
        : netlist_(netlist), drivers_(drivers_of(netlist)), changes_(changes) {}

    InstantDetail::Cause of(const CausalLink& link) const {
        InstantDetail::Cause cause;
        const NetId net = changes_[link.change].net;
        const CellId driver = drivers_[net];
        if (driver == no_cell) return cause;
        const Cell& cell = netlist_.cells[driver];
        if (cell.type == CellType::flip_flop || cell.type == CellType::scan_timer) {
            if (const auto edge = clock_before(link.change)) cause.changes.push_back(*edge);
            return cause;
        }
        if (link.causes.empty()) {
            if (cell.type == CellType::timer) cause.ended = condition_of(cell, net);
            return cause;
        }
        const Time last = changes_[link.causes.back()].at;
        for (const std::size_t change : link.causes) {
            // A pulse ends by itself.
            if (changes_[change].at == last && changes_[change].net != net) {
                cause.changes.push_back(change);
            }
        }
        return cause;
    }

  private:
    std::optional<std::size_t> clock_before(std::size_t change) const {
        while (change > 0) {
            if (changes_[--change].net == netlist_.clock) return change;
        }
        return std::nullopt;
    }

    std::string condition_of(const Cell& timer, NetId net) const {
        const Origin& origin = netlist_.origin_of(timer);
        return origin.kind == Origin::Kind::time_condition ? origin.name
                                                           : std::string(netlist_.names[net]);
    }

    const Netlist& netlist_;
    Table<NetId, CellId> drivers_;
    const std::vector<NetChange>& changes_;
};

/// Leaves out what comes after the first moments of change.
void cut(InstantDetail& detail) {
    std::size_t moments = 0;
    for (std::size_t i = 0; i < detail.changes.size(); ++i) {
        const bool is_new = i == 0 || detail.changes[i].at != detail.changes[i - 1].at;
        if (!is_new || ++moments <= most_moments) continue;
        detail.changes.resize(i);
    }
}

void find_causes(const Netlist& netlist, const CellDelays& delays, const DelaySchedule& schedule,
                 InstantDetail& detail) {
    NetHistory history;
    history.changes = detail.changes;
    std::vector<std::size_t> all(history.changes.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    const DirectCauses causes(netlist, detail.changes);
    for (const CausalLink& link : causal_chain(netlist, delays, history, all, schedule)) {
        detail.causes.push_back(causes.of(link));
    }
}

}  // namespace

DetailedSimulation simulate_in_detail(const Grafcet& grafcet, const Netlist& netlist,
                                      const CellDelays& delays, const Stimuli& stimuli,
                                      SimulateOptions options, Time at) {
    DetailedSimulation simulation;
    std::optional<InstantDetail>& detail = simulation.detail;
    bool is_there = false;
    Time begin = 0;  // of the instant on the clock of the gates, which may have gone on beyond it
    options.instant = [&](Time now, const Simulator& simulator) {
        simulation.instants.push_back(now);
        is_there = now == at;
        if (!is_there) return;
        begin = std::max(at, simulator.now());
        detail.emplace();
        detail->at = at;
        for (std::size_t net = 0; net < netlist.net_count(); ++net) {
            detail->before.push_back(simulator.value(static_cast<NetId>(net)));
        }
    };
    options.observer = [&](Time now, NetId net, Logic value) {
        if (!is_there || detail->changes.size() == most_kept) return;
        detail->changes.push_back({now - begin, net, value});
    };
    simulation.result = simulate(grafcet, netlist, delays, stimuli, options);
    if (!detail) return simulation;
    detail->is_settled = simulation.result.unsettled_at != at;
    if (!detail->is_settled) cut(*detail);
    for (DelayChange& change : options.schedule.changes) change.at -= begin;
    find_causes(netlist, delays, options.schedule, *detail);
    return simulation;
}

}  // namespace grafwire
