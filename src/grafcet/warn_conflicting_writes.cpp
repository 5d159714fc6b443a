// Two stored actions on one variable are a conflict where both may run in the same scan: only the
// last of them then counts. The test is a structural one and errs towards a warning.
//
// - A graph has one token if it has at most one initial step, none of its transitions has several
//   steps on a side or none before it, and no order or enclosing step puts more than one of its
//   steps on. Selections are taken to be exclusive, and what forcing deactivates is not followed.
// - Within such a graph a scan clears one transition or none. Each write is entered under every
//   transition whose clearing runs it (those into its step for `on activation`, those out of it for
//   `on deactivation`, the transition itself for an action on clearing) and, for `on` another
//   event, under its step as well. Two writes entered under one transition or one step may
//   coincide.
// - Any two writes of which one lies in another graph, or in a graph that may have several tokens,
//   may coincide.
//
// One conflict is reported for each variable. The work is proportional to the number of links.

#include <fmt/format.h>

#include <algorithm>

#include "grafcet/messages.h"
#include "grafcet/warnings.h"

namespace grafwire {

namespace {

struct Site {
    Variable target;
    GraphId graph{};
    bool is_clearing = false;
    Trigger trigger = Trigger::activation;
    StepId step{};
    TransitionId transition{};
    Location where;
};

/// All stored actions, by the variable that they write.
std::vector<Site> write_sites(const Grafcet& grafcet) {
    std::vector<Site> sites;
    for (const Action& action : grafcet.actions) {
        if (action.kind == ActionKind::stored) {
            sites.push_back({action.write.target,
                             grafcet.steps[action.step].graph,
                             false,
                             action.trigger,
                             action.step,
                             {},
                             action.where});
        }
    }
    for (const ClearingAction& action : grafcet.clearing_actions) {
        sites.push_back({action.write.target,
                         grafcet.transitions[action.transition].graph,
                         true,
                         {},
                         {},
                         action.transition,
                         action.where});
    }
    std::stable_sort(sites.begin(), sites.end(),
                     [](const Site& a, const Site& b) { return a.target < b.target; });
    return sites;
}

/// Per graph, whether one step at most is ever active: it starts with one, and neither transitions
/// nor orders nor activation links make it several.
std::vector<bool> single_token_graphs(const Grafcet& grafcet) {
    std::vector<std::uint32_t> initial(grafcet.graphs.size(), 0);
    std::vector<bool> single(grafcet.graphs.size(), true);
    for (const Step& step : grafcet.steps) {
        if (step.initial && ++initial[index_of(step.graph)] > 1) {
            single[index_of(step.graph)] = false;
        }
    }
    for (const Transition& transition : grafcet.transitions) {
        if (transition.preceding.count != 1 || transition.following.count > 1) {
            single[index_of(transition.graph)] = false;
        }
    }
    for (const Order& order : grafcet.orders) {
        if (order.steps.size() > 1) single[index_of(order.graph)] = false;
    }
    for (const Enclosure& enclosure : grafcet.enclosures) {
        if (enclosure.links.size() > 1) single[index_of(enclosure.graph)] = false;
    }
    return single;
}

/// The transitions into and out of each step that has a stored action.
struct StepLinks {
    std::vector<std::vector<TransitionId>> into;
    std::vector<std::vector<TransitionId>> out_of;
    std::vector<std::uint32_t> place;  ///< of a step in the two, or none

    StepLinks(const Grafcet& grafcet, const std::vector<Site>& sites)
        : place(grafcet.steps.size(), none) {
        for (const Site& site : sites) {
            if (site.is_clearing || place[index_of(site.step)] != none) continue;
            place[index_of(site.step)] = static_cast<std::uint32_t>(into.size());
            into.emplace_back();
            out_of.emplace_back();
        }
        for (std::size_t i = 0; i < grafcet.transitions.size(); ++i) {
            const Transition& transition = grafcet.transitions.items()[i];
            add(grafcet.following(transition), into, static_cast<TransitionId>(i));
            add(grafcet.preceding(transition), out_of, static_cast<TransitionId>(i));
        }
    }

  private:
    void add(std::span<const StepId> steps, std::vector<std::vector<TransitionId>>& lists,
             TransitionId transition) const {
        for (const StepId step : steps) {
            if (place[index_of(step)] != none) lists[place[index_of(step)]].push_back(transition);
        }
    }
};

class ConflictSearch {
  public:
    explicit ConflictSearch(const Grafcet& grafcet)
        : grafcet_(grafcet),
          sites_(write_sites(grafcet)),
          single_(single_token_graphs(grafcet)),
          links_(grafcet, sites_),
          by_transition_(grafcet.transitions.size(), none),
          by_step_(grafcet.steps.size(), none) {}

    void report(Diagnostics& diagnostics) {
        for (std::size_t first = 0; first < sites_.size();) {
            std::size_t last = first + 1;
            while (last < sites_.size() && sites_[last].target == sites_[first].target) ++last;
            report_target(first, last, diagnostics);
            first = last;
        }
    }

  private:
    void report_target(std::size_t first, std::size_t last, Diagnostics& diagnostics) {
        for (std::size_t i = first + 1; i < last; ++i) {
            const bool is_elsewhere = sites_[i].graph != sites_[first].graph;
            if (is_elsewhere || !single_[index_of(sites_[first].graph)]) {
                return report_pair(first, i, diagnostics);
            }
        }
        for (std::size_t i = first; i < last; ++i) {
            const std::uint32_t other = enter(first, i);
            if (other != none) return report_pair(other, i, diagnostics);
        }
    }

    /// Enters a write under its transitions and step; gives an earlier write of the same variable
    /// found there, or none.
    std::uint32_t enter(std::size_t first, std::size_t index) {
        const Site& site = sites_[index];
        std::uint32_t found = none;
        const auto enter_at = [&](std::uint32_t& slot) {
            if (slot != none && slot >= first && slot != index) found = std::min(found, slot);
            slot = static_cast<std::uint32_t>(index);
        };
        if (site.is_clearing) {
            enter_at(by_transition_[index_of(site.transition)]);
            return found;
        }
        const std::uint32_t place = links_.place[index_of(site.step)];
        const bool is_leaving = site.trigger == Trigger::deactivation;
        for (const TransitionId transition :
             is_leaving ? links_.out_of[place] : links_.into[place]) {
            enter_at(by_transition_[index_of(transition)]);
        }
        if (!is_leaving) enter_at(by_step_[index_of(site.step)]);
        return found;
    }

    void report_pair(std::size_t a, std::size_t b, Diagnostics& diagnostics) const {
        const bool b_is_later = sites_[a].where.line != sites_[b].where.line
                                    ? sites_[a].where.line < sites_[b].where.line
                                    : sites_[a].where.column <= sites_[b].where.column;
        const Site& later = sites_[b_is_later ? b : a];
        const Site& earlier = sites_[b_is_later ? a : b];
        diagnostics
            .warning(code::conflicting_writes, later.where,
                     messages::grafcet::conflicting_writes(
                         quoted(variable_name(grafcet_, later.target))))
            .notes.push_back({earlier.where, messages::grafcet::another_one_here()});
    }

    const Grafcet& grafcet_;
    std::vector<Site> sites_;  ///< by variable
    std::vector<bool> single_;
    StepLinks links_;
    /// The last write entered; one before the first of the present variable counts as none.
    std::vector<std::uint32_t> by_transition_;
    std::vector<std::uint32_t> by_step_;
};

}  // namespace

void warn_conflicting_writes(const Grafcet& grafcet, Diagnostics& diagnostics) {
    const bool has_writes =
        !grafcet.clearing_actions.empty() ||
        std::any_of(grafcet.actions.begin(), grafcet.actions.end(),
                    [](const Action& action) { return action.kind == ActionKind::stored; });
    if (has_writes) ConflictSearch(grafcet).report(diagnostics);
}

}  // namespace grafwire
