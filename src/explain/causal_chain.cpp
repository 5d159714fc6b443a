// Why a gate changed, found backwards through what the simulation did.
//
// A gate changes one delay after the pin that made it change. Where its output is the one that a
// single pin decides (a 0 at an AND), that pin alone is the cause. Where all pins had to agree (the
// 1 of an AND) those that came earlier in the same instant had their part in it too, so the way
// back is a tree; in clocked netlists, where every cycle follows from the one before, only the last
// to come is followed. Of a pulse (a net that changes and changes back in one instant) both ends
// belong to the walk. A flip-flop changes because of its data, a pulse ends because it began, and
// the end of a delay is where a chain begins, as the change of an input is.
//
// So of an AND of `X0` and `a` that rises 1 ns after `a` the chain names `a`; if `X0` has risen in
// the same instant, `X0` as well, and what made it rise; if `X0` has been 1 for long, it does not.
// When the AND falls again, the first of its pins to fall is all that counts.
//
// The changes of every net are kept in their order, so that the last one before a moment is found
// by halving; the walk takes every change once.

#include "explain/causal_chain.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include "simulate/netlist_machine.h"
#include "trace/input_values.h"

namespace grafwire {

namespace {

/// What there is before the first change: the values of all nets once the netlist has been
/// initialised with the inputs of time 0.
std::vector<Logic> start_values(const Grafcet& grafcet, const Netlist& netlist,
                                const CellDelays& delays, const Witness& witness) {
    StimuliPlayer player(witness.stimuli, grafcet.all_input_count());
    player.advance(0);
    NetlistMachine machine(grafcet, netlist, delays, witness.delays);
    machine.start(known_inputs(player.inputs()));
    std::vector<Logic> values;
    for (std::size_t net = 0; net < netlist.net_count(); ++net) {
        values.push_back(machine.simulator().value(static_cast<NetId>(net)));
    }
    return values;
}

}  // namespace

NetHistory::NetHistory(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                       const Witness& witness)
    : start(start_values(grafcet, netlist, delays, witness)) {
    SimulateOptions options;
    options.scan_period = witness.scan_period;
    options.schedule = witness.delays;
    options.observer = [&](Time at, NetId net, Logic value) {
        changes.push_back({at, net, value});
    };
    oscillating = simulate(grafcet, netlist, delays, witness.stimuli, options).oscillating;
    const auto first = std::find_if(changes.begin(), changes.end(), [&](const NetChange& change) {
        return change.at >= witness.stimuli.end;
    });
    first_of_end = static_cast<std::size_t>(first - changes.begin());
}

std::vector<Logic> NetHistory::before_end() const {
    std::vector<Logic> values = start;
    for (std::size_t i = 0; i < first_of_end; ++i) {
        values[index_of(changes[i].net)] = changes[i].value;
    }
    return values;
}

namespace {

/// One step back: from a change of a net to those that brought it about. Changes are indices into
/// the history.
class CauseWalk {
  public:
    CauseWalk(const Netlist& netlist, const CellDelays& delays, const NetHistory& history,
              const DelaySchedule& schedule)
        : netlist_(netlist),
          delays_(delays),
          history_(history),
          drivers_(drivers_of(netlist)),
          of_net_(netlist.net_count()) {
        for (std::size_t i = 0; i < history.changes.size(); ++i) {
            of_net_[index_of(history.changes[i].net)].push_back(i);
        }
        for (const DelayChange& change : schedule.changes) schedule_[change.cell].push_back(change);
    }

    /// None where a chain begins.
    std::vector<std::size_t> causes_of(std::size_t index) const {
        const NetChange& change = history_.changes[index];
        const CellId driver = drivers_[change.net];
        if (driver == no_cell) return {};
        const Cell& cell = netlist_.cells[driver];
        switch (cell.type) {
            case CellType::flip_flop:
            case CellType::scan_timer:
                return of_data(cell, index);
            case CellType::timer:
            case CellType::scan_timer_next:
                return at_once(cell, evaluated_at(driver, index), index);
            case CellType::rise_pulse:
            case CellType::fall_pulse:
                return change.value == Logic::zero ? list(last_before(change.net, index))
                                                   : list(last_before(pin_of(cell, 0), index));
            default:
                return of_gate(cell, change, evaluated_at(driver, index), index);
        }
    }

    /// The change of the same net that this one ends, if it belongs to the same instant.
    std::optional<std::size_t> pulse_before(std::size_t index) const {
        const auto before = last_before(history_.changes[index].net, index);
        const bool is_pulse = before && *before >= history_.first_of_end &&
                              drivers_[history_.changes[index].net] != no_cell &&
                              !netlist_.is_clocked();
        return is_pulse ? before : std::nullopt;
    }

  private:
    static std::vector<std::size_t> list(std::optional<std::size_t> index) {
        if (!index) return {};
        return {*index};
    }
    NetId pin_of(const Cell& cell, std::size_t pin) const { return netlist_.pins_of(cell)[pin]; }

    /// The last change of a net before another change.
    std::optional<std::size_t> last_before(NetId net, std::size_t index) const {
        const std::vector<std::size_t>& changes = of_net_[index_of(net)];
        const auto after = std::lower_bound(changes.begin(), changes.end(), index);
        if (after == changes.begin()) return std::nullopt;
        return *(after - 1);
    }
    /// The last change of a net up to a time, among those before another change.
    std::optional<std::size_t> last_until(NetId net, Time time, std::size_t index) const {
        auto found = last_before(net, index);
        while (found && history_.changes[*found].at > time) found = last_before(net, *found);
        return found;
    }

    bool has_pin_changed(CellId cell, Time at, std::size_t index) const {
        const auto pins = netlist_.pins_of(netlist_.cells[cell]);
        return std::any_of(pins.begin(), pins.end(), [&](NetId pin) {
            const auto last = last_until(pin, at, index);
            return last && history_.changes[*last].at == at;
        });
    }

    /// When a cell was evaluated that changed its output then: one delay before. Under a schedule
    /// that is the delay in force at that earlier moment; of several that may have been, the one at
    /// whose moment a pin changed.
    Time evaluated_at(CellId cell, std::size_t index) const {
        const NetChange& change = history_.changes[index];
        const bool falls = change.value == Logic::zero;
        const Time by_itself = (falls ? delays_.fall : delays_.rise)[index_of(cell)];
        const auto scheduled = schedule_.find(cell);
        if (scheduled == schedule_.end()) return change.at - by_itself;
        Time until = never;
        for (auto delays = scheduled->second.rbegin(); delays != scheduled->second.rend();
             ++delays) {
            const Time at = change.at - (falls ? delays->fall : delays->rise);
            const bool in_force = (delays->at <= 0 || delays->at <= at) && at < until;
            if (in_force && has_pin_changed(cell, at, index)) return at;
            until = delays->at;
        }
        return change.at - by_itself;
    }

    /// The data; the clock where that has never changed.
    std::vector<std::size_t> of_data(const Cell& cell, std::size_t index) const {
        const auto data = last_before(pin_of(cell, 0), index);
        return list(data ? data : last_before(netlist_.clock, index));
    }

    /// A timer that follows its operand at once has it as its cause; else its delay has ended.
    std::vector<std::size_t> at_once(const Cell& cell, Time time, std::size_t index) const {
        const auto cause = last_until(pin_of(cell, 0), time, index);
        if (cause && history_.changes[*cause].at == time) return {*cause};
        return {};
    }

    /// Whether a pin at this value decides the output of a gate by itself.
    static bool decides(CellType type, Logic pin) {
        switch (type) {
            case CellType::and_gate:
            case CellType::nand_gate:
                return pin == Logic::zero;
            case CellType::or_gate:
            case CellType::nor_gate:
                return pin == Logic::one;
            default:
                return false;
        }
    }

    /// The pins that changed just as the gate was evaluated, one delay before its output; of these
    /// the one that decides by itself, if one does. Where none did (a change came about otherwise,
    /// as when a net is let go), the last one before.
    std::vector<std::size_t> of_gate(const Cell& cell, const NetChange& change, Time time,
                                     std::size_t index) const {
        std::vector<std::size_t> just;    // changed as the gate was evaluated
        std::vector<std::size_t> before;  // earlier in the instant
        for (const NetId pin : netlist_.pins_of(cell)) {
            const auto last = last_until(pin, time, index);
            if (!last || pin == change.net) continue;
            const bool is_just = history_.changes[*last].at == time;
            (is_just ? just : before).push_back(*last);
        }
        const auto decisive = std::find_if(just.begin(), just.end(), [&](std::size_t i) {
            return decides(cell.type, history_.changes[i].value);
        });
        if (decisive != just.end()) return {*decisive};
        if (just.empty() && !before.empty()) {
            just.push_back(*std::max_element(before.begin(), before.end()));
        }
        const bool all_have_a_part =
            cell.type == CellType::and_gate || cell.type == CellType::nand_gate ||
            cell.type == CellType::or_gate || cell.type == CellType::nor_gate;
        if (all_have_a_part && !netlist_.is_clocked()) {
            for (const std::size_t i : before) {
                if (i >= history_.first_of_end) just.push_back(i);
            }
        }
        std::sort(just.begin(), just.end());
        just.erase(std::unique(just.begin(), just.end()), just.end());
        return just;
    }

    const Netlist& netlist_;
    const CellDelays& delays_;
    const NetHistory& history_;
    Table<NetId, CellId> drivers_;
    std::vector<std::vector<std::size_t>> of_net_;
    std::unordered_map<CellId, std::vector<DelayChange>> schedule_;
};

}  // namespace

std::vector<CausalLink> causal_chain(const Netlist& netlist, const CellDelays& delays,
                                     const NetHistory& history,
                                     const std::vector<std::size_t>& targets,
                                     const DelaySchedule& schedule) {
    const CauseWalk walk(netlist, delays, history, schedule);
    std::vector<bool> seen(history.changes.size(), false);
    std::vector<std::size_t> waiting;
    const auto add = [&](std::size_t change) {
        if (seen[change]) return;
        seen[change] = true;
        waiting.push_back(change);
    };
    for (const std::size_t target : targets) add(target);
    std::vector<CausalLink> links;
    while (!waiting.empty()) {
        const std::size_t change = waiting.back();
        waiting.pop_back();
        links.push_back({change, walk.causes_of(change)});
        for (const std::size_t cause : links.back().causes) add(cause);
        // A net that changes back had to change first.
        const auto first = walk.pulse_before(change);
        if (first) add(*first);
    }
    std::sort(links.begin(), links.end(),
              [](const CausalLink& a, const CausalLink& b) { return a.change < b.change; });
    return links;
}

}  // namespace grafwire
