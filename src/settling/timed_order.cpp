// Gates whose delays have bounds: all orders in which they can fire, and no others.
//
// A state class is a state of the circuit with all the times at which its excited cells can fire
// (firing_domain.h). From class to class goes whatever can fire first in a stubborn set of cells
// (stubborn_sets.cpp); cells that have been excited before and still are keep their times, others
// begin. Every rest that the bounds allow is at the end of a path through the classes, and every
// path is one that they allow. A class that another one with the same state includes is not gone
// through again.
//
// As times of different corners are not compared, one corner may go round while another waits, and
// classes with ever other times come up. Then the circuit is taken to be able to go round for ever,
// and a replay decides. Where there are too many classes, gates of any delay answer for these,
// since they do all that these do, and more.

#include "settling/timed_order.h"

#include <algorithm>

#include "settling/strong_parts.h"
#include "settling/ternary.h"

namespace grafwire {

namespace {

/// That a state may be passed on one way, with ever other times.
constexpr std::size_t most_turns = 5;

}  // namespace

TimedOrder::TimedOrder(const Circuit& circuit, CellBands bands, KeepGoing keep_going)
    : circuit_(circuit),
      bands_(std::move(bands)),
      keep_going_(keep_going),
      any_order_(circuit, std::move(keep_going)),
      sets_(circuit, true) {}

/// The bounds of something that begins to be pending. `is_first_answer`: of a pulse cell that had
/// answered all edges before.
DelayBand TimedOrder::band_of(const CircuitState& state, const CellAction& action,
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

CircuitState TimedOrder::state(std::uint32_t number) const {
    CircuitState state = like_;
    circuit_.decode(*classes_[number].encoding, state);
    return state;
}

/// Whether the way to a class has passed a state too often not to be suspected of going round.
bool TimedOrder::turns_before(std::uint32_t number, const std::string& state) const {
    std::size_t times = 0;
    for (; number != 0; number = classes_[number].parent) {
        if (*classes_[number].encoding == state) ++times;
    }
    return times > most_turns;
}

/// The number of the class, or of one that includes it.
std::uint32_t TimedOrder::add(const CircuitState& state, StateClass&& reached) {
    const auto number = static_cast<std::uint32_t>(classes_.size());
    const auto place = classes_of_.try_emplace(circuit_.encoded(state)).first;
    for (const std::uint32_t known : place->second) {
        if (classes_[known].domain.includes(reached.domain)) return known;
    }
    if (place->second.size() > most_turns && turns_before(reached.parent, place->first)) {
        drifting_ = std::min(drifting_, reached.parent);
        return place->second.back();
    }
    place->second.push_back(number);
    reached.encoding = &place->first;
    classes_.push_back(std::move(reached));
    return number;
}

/// What is pending after a firing, as what it was before.
std::vector<FiringDomain::Origin> TimedOrder::origins_after(
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

void TimedOrder::fire(std::uint32_t number, const CircuitState& from, const Firing& firing) {
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
    const std::uint32_t next = add(to, std::move(reached));
    classes_[number].edges.push_back({next, firing});
}

/// What the gates can do next; where that is nothing, the delays that end.
std::vector<CellAction> TimedOrder::pending_in(const CircuitState& state) const {
    std::vector<CellAction> actions = circuit_.actions(state);
    return actions.empty() ? circuit_.ending_delays(state) : actions;
}

bool TimedOrder::expand(std::uint32_t number) {
    const CircuitState from = state(number);
    std::vector<Firing> firings;
    if (!sets_.choose(from, firings)) return false;
    for (const Firing& firing : firings) fire(number, from, firing);
    return true;
}

std::vector<Firing> TimedOrder::way_to(std::uint32_t number) const {
    std::vector<Firing> way;
    for (; number != 0; number = classes_[number].parent) way.push_back(classes_[number].firing);
    std::reverse(way.begin(), way.end());
    return way;
}

void TimedOrder::append_rests(Rests& rests, bool with_firings) const {
    std::vector<const std::string*> seen;
    for (std::uint32_t number = 0; number < classes_.size(); ++number) {
        const StateClass& reached = classes_[number];
        if (!reached.pending.empty()) continue;
        if (std::find(seen.begin(), seen.end(), reached.encoding) != seen.end()) continue;
        seen.push_back(reached.encoding);
        Rest rest;
        rest.state = state(number);
        if (with_firings) rest.firings = way_to(number);
        rests.rests.push_back(std::move(rest));
    }
}

/// The states that can be gone through again and again. As a class may stand for others that it
/// includes, that is more than can be, and for a replay to decide.
void TimedOrder::append_endless(Rests& rests) const {
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
    for (std::size_t part = 0; part < parts.count; ++part) {
        if (first[part] != nowhere) append_oscillation(first[part], changed[part].take(), rests);
    }
}

void TimedOrder::append_oscillation(std::uint32_t number, std::vector<NetId> changing,
                                    Rests& rests) const {
    Rest rest;
    rest.kind = Rest::Kind::oscillates;
    rest.state = state(number);
    rest.firings = way_to(number);
    rest.changing = std::move(changing);
    rests.rests.push_back(std::move(rest));
}

/// Where a state comes back again and again with other times: one part of the circuit goes round
/// while another waits. It may be that it can do so for ever.
void TimedOrder::append_drifting(Rests& rests) const {
    ChangedNets changed(circuit_);
    for (const Firing& firing : way_to(drifting_)) changed.add(firing);
    append_oscillation(drifting_, changed.take(), rests);
}

TimedOrder::End TimedOrder::build(const CircuitState& start, std::size_t most_classes) {
    drifting_ = nowhere;
    classes_of_.clear();
    classes_.clear();
    like_ = start;
    StateClass first;
    first.pending = pending_in(start);
    std::vector<DelayBand> bands;
    for (const CellAction& action : first.pending) bands.push_back(band_of(start, action, true));
    first.domain = FiringDomain(bands);
    add(start, std::move(first));
    for (std::uint32_t number = 0; number < classes_.size(); ++number) {
        if (keep_going_ && !keep_going_()) return End::broken_off;
        if (classes_.size() > most_classes || !expand(number)) return End::too_large;
    }
    return End::complete;
}

Rests TimedOrder::settle(const CircuitState& start, bool with_firings, std::size_t most_states) {
    if (!with_firings) {
        if (auto rest = rest_of_all_delays(circuit_, start)) return std::move(*rest);
    }
    const End end = build(start, most_states);
    // Gates of any delay do all that these do, and more.
    if (end == End::too_large) return any_order_.settle(start, with_firings, most_states);
    Rests rests;
    rests.states = classes_.size();
    rests.broken_off = end == End::broken_off;
    append_rests(rests, with_firings);
    append_endless(rests);
    if (drifting_ != nowhere) append_drifting(rests);
    return rests;
}

}  // namespace grafwire
