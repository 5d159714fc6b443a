// A simulation is told while it runs: the changes of one instant are kept until the next begins,
// and what follows from what is found backwards from the steps and outputs that have changed
// (causal_chain). Of that tree one way is told for each of them: where a gate needed several
// changes, the last to come decided when it switched. A way that comes by another step or output
// begins there, since that one has a way of its own.

#include "explain/gate_story.h"

#include <algorithm>
#include <utility>

#include "explain/causal_chain.h"
#include "simulate/netlist_machine.h"
#include "trace/input_values.h"

namespace grafwire {

namespace {

constexpr std::size_t most_changes = 12;  ///< of an instant that are told
constexpr std::size_t most_links = 8;     ///< of a way

class SimulationTeller {
  public:
    SimulationTeller(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                     const DelaySchedule& schedule, const Stimuli& stimuli, bool by_scans)
        : netlist_(netlist),
          delays_(delays),
          schedule_(schedule),
          player_(stimuli, grafcet.all_input_count()),
          by_scans_(by_scans),
          inputs_(grafcet.all_input_count(), 0),
          drivers_(drivers_of(netlist)) {
        const PortMap ports = map_ports(grafcet, netlist);
        for (std::size_t i = 0; i < ports.steps.size(); ++i) {
            add_target("X" + grafcet.steps[grafcet.steps.id_at(i)].name, ports.steps[i]);
        }
        step_count_ = targets_.size();
        for (std::size_t i = 0; i < ports.outputs.size(); ++i) {
            add_target(grafcet.outputs[grafcet.outputs.id_at(i)].name, ports.outputs[i]);
        }
    }

    /// An instant begins, and so the one before it is over.
    void begin(Time at, const Simulator& simulator) {
        if (is_under_way_) finish_instant();
        if (!is_under_way_) {
            for (Target& target : targets_) target.value = simulator.value(target.net);
        }
        story_ = {};
        story_.at = at;
        story_.last = at;
        story_.by_scans = by_scans_;
        story_.is_first = !is_under_way_;
        is_under_way_ = true;
        player_.advance(at);
        for (std::size_t i = 0; i < inputs_.size(); ++i) {
            const bool value = player_.inputs()[i] != 0;
            if (value == (inputs_[i] != 0)) continue;
            story_.inputs.push_back({static_cast<std::uint32_t>(i), value});
        }
        inputs_ = player_.inputs();
    }

    void note(Time at, NetId net, Logic value) { history_.changes.push_back({at, net, value}); }

    /// Where the start does not settle there is no instant.
    std::vector<GateStory> finish(const SimulateResult& result) {
        story_.oscillating = result.oscillating;
        if (!is_under_way_) story_.is_first = true;
        if (is_under_way_ || result.unsettled_at) finish_instant();
        return std::move(stories_);
    }

  private:
    /// A step or output.
    struct Target {
        std::string name;
        NetId net = no_net;
        Logic value = Logic::unknown;
        std::size_t change = none;  ///< the last of its net in the instant
    };
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    void add_target(std::string name, NetId net) {
        if (net != no_net) targets_.push_back({std::move(name), net, Logic::unknown, none});
    }

    void finish_instant();
    std::vector<std::size_t> changed_targets();
    std::vector<std::size_t> timer_changes() const;
    void note_ended_delays(const std::vector<CausalLink>& links);
    GateChange change_of(const Target& target, const std::vector<CausalLink>& links) const;
    GateLink link_of(std::size_t change) const;
    bool is_target(std::size_t change) const {
        return std::any_of(targets_.begin(), targets_.end(),
                           [&](const Target& target) { return target.change == change; });
    }
    void note_end();
    void add_story();

    const Netlist& netlist_;
    const CellDelays& delays_;
    const DelaySchedule& schedule_;
    StimuliPlayer player_;
    bool by_scans_;
    InputValues inputs_;
    Table<NetId, CellId> drivers_;
    std::vector<Target> targets_;  ///< steps first
    std::size_t step_count_ = 0;
    NetHistory history_;  ///< of the instant
    GateStory story_;
    bool is_under_way_ = false;
    std::vector<GateStory> stories_;
};

void SimulationTeller::finish_instant() {
    const std::vector<std::size_t> changed = changed_targets();
    if (story_.oscillating.empty()) {
        std::vector<std::size_t> ends = timer_changes();
        for (const std::size_t target : changed) ends.push_back(targets_[target].change);
        const std::vector<CausalLink> links =
            causal_chain(netlist_, delays_, history_, ends, schedule_);
        note_ended_delays(links);
        for (const std::size_t target : changed) {
            if (story_.changes.size() == most_changes) break;
            story_.changes.push_back(change_of(targets_[target], links));
        }
        story_.untold = changed.size() - story_.changes.size();
        if (!history_.changes.empty()) {
            story_.settled_after = std::max<Time>(0, history_.changes.back().at - story_.at);
        }
    }
    note_end();
    history_.changes.clear();
    add_story();
}

/// Those that have another value than before, in the order in which they took it.
std::vector<std::size_t> SimulationTeller::changed_targets() {
    std::vector<std::size_t> last(netlist_.net_count(), none);
    for (std::size_t i = 0; i < history_.changes.size(); ++i) {
        last[index_of(history_.changes[i].net)] = i;
    }
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < targets_.size(); ++i) {
        Target& target = targets_[i];
        target.change = last[index_of(target.net)];
        if (target.change == none) continue;
        const Logic value = history_.changes[target.change].value;
        if (std::exchange(target.value, value) == value) {
            target.change = none;
        } else {
            changed.push_back(i);
        }
    }
    std::stable_sort(changed.begin(), changed.end(), [&](std::size_t a, std::size_t b) {
        return targets_[a].change < targets_[b].change;
    });
    return changed;
}

std::vector<std::size_t> SimulationTeller::timer_changes() const {
    std::vector<std::size_t> changes;
    for (std::size_t i = 0; i < history_.changes.size(); ++i) {
        const CellId driver = drivers_[history_.changes[i].net];
        if (driver != no_cell && netlist_.cells[driver].type == CellType::timer) {
            changes.push_back(i);
        }
    }
    return changes;
}

/// A timer that changes without a cause: its delay has ended.
void SimulationTeller::note_ended_delays(const std::vector<CausalLink>& links) {
    for (const CausalLink& link : links) {
        const NetId net = history_.changes[link.change].net;
        const CellId driver = drivers_[net];
        if (driver == no_cell || !link.causes.empty()) continue;
        const Cell& cell = netlist_.cells[driver];
        if (cell.type != CellType::timer) continue;
        const Origin& origin = netlist_.origin_of(cell);
        story_.ended.push_back(origin.kind == Origin::Kind::time_condition
                                   ? origin.name
                                   : std::string(netlist_.names[net]));
    }
}

GateLink SimulationTeller::link_of(std::size_t index) const {
    const NetChange& change = history_.changes[index];
    return {drivers_[change.net], change.net, change.value,
            std::max<Time>(0, change.at - story_.at), is_target(index)};
}

GateChange SimulationTeller::change_of(const Target& target,
                                       const std::vector<CausalLink>& links) const {
    GateChange result;
    result.name = target.name;
    result.value = target.value;
    result.after = link_of(target.change).after;
    const auto causes_of = [&](std::size_t change) -> const std::vector<std::size_t>& {
        return std::lower_bound(
                   links.begin(), links.end(), change,
                   [](const CausalLink& link, std::size_t number) { return link.change < number; })
            ->causes;
    };
    for (std::size_t change = target.change; !causes_of(change).empty();) {
        const std::vector<std::size_t>& causes = causes_of(change);
        change = *std::max_element(causes.begin(), causes.end());
        result.way.push_back(link_of(change));
        if (result.way.back().is_target) break;
    }
    std::reverse(result.way.begin(), result.way.end());
    if (result.way.size() > most_links) {
        result.left_out = result.way.size() - most_links;
        result.way.erase(result.way.begin() + 1,
                         result.way.begin() + 1 + static_cast<std::ptrdiff_t>(result.left_out));
    }
    return result;
}

void SimulationTeller::note_end() {
    for (std::size_t i = 0; i < targets_.size(); ++i) {
        const Target& target = targets_[i];
        if (target.value == Logic::one) {
            (i < step_count_ ? story_.active : story_.outputs).push_back(target.name);
        } else if (target.value == Logic::unknown) {
            story_.undefined.push_back(target.name);
        }
    }
}

/// Instants at which nothing changes are one story together.
void SimulationTeller::add_story() {
    story_.is_quiet = !story_.is_first && story_.inputs.empty() && story_.ended.empty() &&
                      story_.changes.empty() && story_.oscillating.empty();
    if (story_.is_quiet && !stories_.empty() && stories_.back().is_quiet) {
        ++stories_.back().repeated;
        stories_.back().last = story_.at;
    } else {
        stories_.push_back(std::move(story_));
    }
}

}  // namespace

ToldSimulation tell_simulation(const Grafcet& grafcet, const Netlist& netlist,
                               const CellDelays& delays, const Stimuli& stimuli,
                               SimulateOptions options) {
    const bool by_scans = netlist.is_clocked() && options.scan_period > 0;
    SimulationTeller teller(grafcet, netlist, delays, options.schedule, stimuli, by_scans);
    options.observer = [&](Time at, NetId net, Logic value) { teller.note(at, net, value); };
    options.instant = [&](Time at, const Simulator& simulator) { teller.begin(at, simulator); };
    ToldSimulation told;
    told.result = simulate(grafcet, netlist, delays, stimuli, options);
    told.stories = teller.finish(told.result);
    return told;
}

}  // namespace grafwire
