#include "sfc/chart.h"

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
            const StepId source = add_step(TransitionId{t}, transition.graph, true);
            links.preceding.push_back(source);
            links.following.push_back(source);
        }
        if (following.empty()) {
            links.following.push_back(add_step(TransitionId{t}, transition.graph, false));
        }
        transitions_.push_back(std::move(links));
    }
}

StepId Chart::add_step(TransitionId transition, GraphId graph, bool is_source) {
    const StepId id{static_cast<std::uint32_t>(initial_.size())};
    initial_.push_back(is_source);
    graphs_[index_of(graph)].push_back(id);
    auxiliaries_.push_back({transition, is_source});
    return id;
}

}  // namespace grafwire::sfc
