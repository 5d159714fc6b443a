// The states of a circuit within an instant, where delays have bounds.
//
// A state class is a state of the circuit with all the times at which its excited cells can fire
// (firing_domain.h). From class to class goes whatever can fire first in a stubborn set of cells
// (timed_stubborn_sets.cpp); cells that have been excited before and still are keep their times,
// others begin. Every rest that the bounds allow is at the end of a path through the classes, and
// every path is one that they allow. A class that another one with the same state includes is not
// gone through again.
//
// A merged class stands for all times at which its state has been reached, and for whatever lies
// between them: the smallest domain that includes both. So the classes of a state need not be more
// than a given number; no rest is missed, and some may be found that cannot be.
//
// As times of different corners are not compared, one corner may go round while another waits, and
// classes with ever other times come up. Then the circuit is taken to be able to go round for ever,
// and a replay decides.

#include "settling/timed_graph.h"

#include <algorithm>
#include <unordered_set>

#include "settling/strong_parts.h"

namespace grafwire {

namespace {

/// That a state may be passed on one way, with ever other times.
constexpr std::size_t most_turns = 5;

/// After so many mergers a class stands for all times.
constexpr std::uint32_t most_mergers = 12;

}  // namespace

TimedGraph::TimedGraph(const Circuit& circuit, CellBands bands)
    : circuit_(circuit), bands_(std::move(bands)), sets_(circuit) {}

/// The bounds of something that begins to be pending. `is_first_answer`: of a pulse cell that had
/// answered all edges before.
DelayBand TimedGraph::band_of(const CircuitState& state, const CellAction& action,
                              bool is_first_answer) const {
    const DelayBand& rise = bands_.rise[action.cell];
    const DelayBand& fall = bands_.fall[action.cell];
    switch (action.kind) {
        case CellAction::Kind::answer:
            return is_first_answer ? rise : DelayBand{0, rise.max};
        case CellAction::Kind::end_pulse:
            return fall;
        case CellAction::Kind::end_delay:
            return {0, 0};
        case CellAction::Kind::take:
            break;
    }
    const Logic to = circuit_.asked(state, action.cell);
    if (to == Logic::unknown) return {std::min(rise.min, fall.min), std::max(rise.max, fall.max)};
    // From unknown it may have been on its way already.
    const bool is_known = state.values[index_of(circuit_.output(action.cell))] != Logic::unknown;
    const DelayBand band = to == Logic::one ? rise : fall;
    return is_known ? band : DelayBand{0, band.max};
}

CircuitState TimedGraph::state(std::uint32_t number) const {
    CircuitState state = like_;
    circuit_.decode(*classes_[number].encoding, state);
    return state;
}

/// Whether the way to a class has passed a state too often not to be suspected of going round.
bool TimedGraph::turns_before(std::uint32_t number, const std::string& state) const {
    std::size_t times = 0;
    for (; number != 0; number = classes_[number].parent) {
        if (*classes_[number].encoding == state) ++times;
    }
    return times > most_turns;
}

/// The number of the class, or of one that includes it.
std::uint32_t TimedGraph::add(const CircuitState& state, StateClass&& reached) {
    const auto number = static_cast<std::uint32_t>(classes_.size());
    std::string encoding = circuit_.encoded(state);
    encoding += static_cast<char>(reached.changes);
    const auto place = classes_of_.try_emplace(std::move(encoding)).first;
    for (const std::uint32_t known : place->second) {
        if (classes_[known].domain.includes(reached.domain)) return known;
    }
    if (place->second.size() >= search_.most_of_a_state) {
        merge(place->second.back(), reached.domain);
        return place->second.back();
    }
    if (place->second.size() > most_turns && turns_before(reached.parent, place->first)) {
        drifting_ = std::min(drifting_, reached.parent);
        return place->second.back();
    }
    place->second.push_back(number);
    reached.encoding = &place->first;
    classes_.push_back(std::move(reached));
    waiting_.push_back(number);
    return number;
}

/// Lets a class stand for more times, and be gone on from again.
void TimedGraph::merge(std::uint32_t known, const FiringDomain& domain) {
    StateClass& merged = classes_[known];
    is_merged_ = true;
    if (++merged.mergers < most_mergers) {
        merged.domain.include(domain);
    } else {
        merged.domain.include_all();
    }
    if (!merged.is_waiting) waiting_.push_back(known);
    merged.is_waiting = true;
}

/// What is pending after a firing, as what it was before.
std::vector<FiringDomain::Origin> TimedGraph::origins_after(
    const std::vector<CellAction>& before, const Firing& firing, const CircuitState& to,
    const std::vector<CellAction>& pending) const {
    std::vector<FiringDomain::Origin> origins;
    for (const CellAction& action : pending) {
        const auto place = std::find(before.begin(), before.end(), action);
        const auto is_same_cell = [&](const CellAction& fired) {
            return fired.cell == action.cell;
        };
        const bool begins_anew = std::any_of(firing.begin(), firing.end(), is_same_cell);
        FiringDomain::Origin origin;
        const bool is_other_part = begins_anew && action.kind == CellAction::Kind::answer &&
                                   firing[0].kind == CellAction::Kind::end_pulse;
        if (place != before.end() && (!begins_anew || is_other_part)) {
            origin.firing = static_cast<std::size_t>(place - before.begin());
        } else {
            origin.band = band_of(to, action, !begins_anew);
        }
        origins.push_back(origin);
    }
    return origins;
}

void TimedGraph::fire(std::uint32_t number, const CircuitState& from, const Firing& firing) {
    const std::vector<CellAction>& pending = classes_[number].pending;
    std::vector<std::size_t> first;
    for (const CellAction& action : firing) {
        const auto place = std::find(pending.begin(), pending.end(), action);
        first.push_back(static_cast<std::size_t>(place - pending.begin()));
    }
    CircuitState to = from;
    circuit_.perform(firing, to);
    StateClass reached;
    reached.pending = pending_in(to);
    const auto origins = origins_after(pending, firing, to, reached.pending);
    std::vector<std::size_t> others;
    std::vector<std::size_t> quietened;
    for (std::size_t i = 0; i < pending.size(); ++i) {
        const auto is_among = [&](const std::vector<CellAction>& actions) {
            return std::find(actions.begin(), actions.end(), pending[i]) != actions.end();
        };
        if (!is_among(firing) && !is_among(reached.pending)) {
            quietened.push_back(i);
        } else if (sets_.contains(pending[i].cell)) {
            others.push_back(i);
        }
    }
    const FiringDomain& domain = classes_[number].domain;
    if (!domain.fire(first, others, quietened, origins, reached.domain)) return;
    reached.parent = number;
    reached.firing = firing;
    if (watched_ != nullptr) {
        reached.changes = watched_->count(classes_[number].changes, from, to);
    }
    const std::uint32_t next = add(to, std::move(reached));
    classes_[number].edges.push_back({next, firing});
}

/// What the gates can do next; where that is nothing, the delays that end.
std::vector<CellAction> TimedGraph::pending_in(const CircuitState& state) const {
    std::vector<CellAction> actions = circuit_.actions(state);
    return actions.empty() ? circuit_.ending_delays(state) : actions;
}

bool TimedGraph::expand(std::uint32_t number) {
    classes_[number].is_waiting = false;
    classes_[number].edges.clear();
    const CircuitState from = state(number);
    std::vector<Firing> firings;
    if (!sets_.choose(from, firings)) return false;
    for (const Firing& firing : firings) fire(number, from, firing);
    return true;
}

std::vector<Firing> TimedGraph::way_to(std::uint32_t number) const {
    std::vector<Firing> way;
    for (; number != 0; number = classes_[number].parent) way.push_back(classes_[number].firing);
    std::reverse(way.begin(), way.end());
    return way;
}

std::vector<Rest> TimedGraph::rests(bool with_firings) const {
    std::vector<Rest> rests;
    std::unordered_set<const std::string*> seen;
    for (std::uint32_t number = 0; number < classes_.size(); ++number) {
        const StateClass& reached = classes_[number];
        if (!reached.pending.empty() || !seen.insert(reached.encoding).second) continue;
        Rest& rest = rests.emplace_back();
        rest.state = state(number);
        if (with_firings) rest.firings = way_to(number);
    }
    return rests;
}

std::vector<Rest> TimedGraph::oscillations() const {
    std::vector<std::vector<std::uint32_t>> successors(classes_.size());
    for (std::uint32_t number = 0; number < classes_.size(); ++number) {
        for (const Edge& edge : classes_[number].edges) successors[number].push_back(edge.to);
    }
    const StrongParts parts = strong_parts(successors);
    std::vector<ChangedNets> changed(parts.count, ChangedNets(circuit_));
    std::vector<std::uint32_t> first(parts.count, nowhere);
    for (std::uint32_t number = 0; number < classes_.size(); ++number) {
        const std::uint32_t part = parts.of_node[number];
        for (const Edge& edge : classes_[number].edges) {
            if (parts.of_node[edge.to] != part) continue;
            first[part] = std::min(first[part], number);
            changed[part].add(edge.firing);
        }
    }
    std::vector<Rest> found;
    for (std::size_t part = 0; part < parts.count; ++part) {
        if (first[part] != nowhere) found.push_back(oscillation(first[part], changed[part].take()));
    }
    if (drifting_ != nowhere) found.push_back(drifting());
    return found;
}

Rest TimedGraph::oscillation(std::uint32_t number, std::vector<NetId> changing) const {
    Rest rest;
    rest.kind = Rest::Kind::oscillates;
    rest.state = state(number);
    rest.firings = way_to(number);
    rest.changing = std::move(changing);
    return rest;
}

/// Where a state comes back again and again with other times: one part of the circuit goes round
/// while another waits. It may be that it can do so for ever.
Rest TimedGraph::drifting() const {
    ChangedNets changed(circuit_);
    for (const Firing& firing : way_to(drifting_)) changed.add(firing);
    return oscillation(drifting_, changed.take());
}

/// Once a net has changed too often in a class, nothing else is gone on from; whether that is so.
bool TimedGraph::follow_excess(std::size_t first_new) {
    for (std::size_t number = first_new; number < classes_.size() && !is_exceeded_; ++number) {
        if (classes_[number].changes <= watched_->most) continue;
        is_exceeded_ = true;
        waiting_.assign(1, static_cast<std::uint32_t>(number));
    }
    return is_exceeded_;
}

TimedGraph::End TimedGraph::build(const CircuitState& start, const Search& search,
                                  const KeepGoing& keep_going, const WatchedNet* watched) {
    search_ = search;
    watched_ = watched;
    is_exceeded_ = false;
    is_merged_ = false;
    drifting_ = nowhere;
    classes_of_.clear();
    classes_.clear();
    waiting_.clear();
    like_ = start;
    StateClass first;
    first.pending = pending_in(start);
    std::vector<DelayBand> bands;
    for (const CellAction& action : first.pending) bands.push_back(band_of(start, action, true));
    first.domain = FiringDomain(bands);
    add(start, std::move(first));
    std::unordered_set<const std::string*> rests;
    for (std::size_t steps = 0; !waiting_.empty(); ++steps) {
        if (keep_going && !keep_going()) return End::broken_off;
        const bool is_deep = search.deep_first || is_exceeded_;
        const std::uint32_t number = is_deep ? waiting_.back() : waiting_.front();
        is_deep ? waiting_.pop_back() : waiting_.pop_front();
        const std::size_t first_new = classes_.size();
        if (steps > search.most_classes || !expand(number)) return End::too_large;
        last_ = number;
        if (watched != nullptr && follow_excess(first_new) && classes_[number].pending.empty()) {
            return End::exceeded;
        }
        if (classes_[number].pending.empty()) rests.insert(classes_[number].encoding);
        if (search.most_rests != 0 && rests.size() == search.most_rests) break;
    }
    return is_exceeded_ ? End::too_large : End::complete;
}

}  // namespace grafwire
