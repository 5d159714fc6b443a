#include "sfc/chart.h"

#include <algorithm>
#include <utility>

namespace grafwire::sfc {

Chart::Chart(const Grafcet& grafcet) {
    for (const Step& step : grafcet.steps) initial_.push_back(step.initial);
    for (const Graph& graph : grafcet.graphs) {
        graphs_.emplace_back();
        for (const StepId step : graph.steps) graphs_.back().push_back(step);
    }
    for (std::uint32_t t = 0; t < grafcet.transitions.size(); ++t) {
        const Transition& transition = grafcet.transitions[TransitionId{t}];
        const auto preceding = grafcet.preceding(transition);
        const auto following = grafcet.following(transition);
        Links links{{preceding.begin(), preceding.end()}, {following.begin(), following.end()}};
        if (preceding.empty()) {
            const StepId source =
                add_step({Auxiliary::Kind::source, TransitionId{t}, transition.graph});
            links.preceding.push_back(source);
            links.following.push_back(source);
        }
        if (following.empty()) {
            links.following.push_back(
                add_step({Auxiliary::Kind::end, TransitionId{t}, transition.graph}));
        }
        transitions_.push_back(std::move(links));
    }
    add_idle_steps();
}

StepId Chart::add_step(const Auxiliary& auxiliary) {
    const StepId id{static_cast<std::uint32_t>(initial_.size())};
    initial_.push_back(auxiliary.kind != Auxiliary::Kind::end);
    graphs_[index_of(auxiliary.graph)].push_back(id);
    auxiliaries_.push_back(auxiliary);
    return id;
}

void Chart::mark_reached(StepId first, std::vector<bool>& reached) const {
    std::vector<StepId> to_visit{first};
    reached[index_of(first)] = true;
    while (!to_visit.empty()) {
        const StepId step = to_visit.back();
        to_visit.pop_back();
        for (const Links& links : transitions_) {
            if (std::find(links.preceding.begin(), links.preceding.end(), step) ==
                links.preceding.end()) {
                continue;
            }
            for (const StepId next : links.following) {
                if (reached[index_of(next)]) continue;
                reached[index_of(next)] = true;
                to_visit.push_back(next);
            }
        }
    }
}

void Chart::add_idle_steps() {
    std::vector<bool> reached(initial_.size(), false);
    for (std::uint32_t s = 0; s < reached.size(); ++s) {
        if (initial_[s] && !reached[s]) mark_reached(StepId{s}, reached);
    }
    for (std::uint32_t g = 0; g < graphs_.size(); ++g) {
        const std::vector<StepId> steps = graphs_[g];
        std::vector<StepId> heads;
        for (const StepId step : steps) {
            if (reached[index_of(step)]) continue;
            heads.push_back(step);
            mark_reached(step, reached);
        }
        if (heads.empty()) continue;
        const StepId idle = add_step({Auxiliary::Kind::idle, {}, GraphId{g}});
        for (const StepId head : heads) transitions_.push_back({{idle}, {head}});
    }
}

}  // namespace grafwire::sfc
