// Layout of an SFC. A depth-first walk from the initial steps finds the links that close a loop
// (those that lead to a step on the way that the walk has come); they become jumps. The level of a
// step is the length of the longest way to it without jumps, so that the branches of a selection or
// of simultaneous sequences meet below all of them. A branch after the first opens a new column.
//
// The bar below a transition and the bar above a step must not touch: the standard has a step
// between them, and tools fail without one. A jump parts them as well.

#include "sfc/layout.h"

#include <algorithm>

namespace grafwire::sfc {

namespace {

class Walk {
  public:
    Walk(const Chart& chart, Layout& layout)
        : chart_(chart), layout_(layout), states_(chart.step_count(), State::unseen) {
        layout.steps.resize(chart.step_count());
        layout.transitions.resize(chart.transition_count());
        layout.out_of.resize(chart.step_count());
        layout.into.resize(chart.step_count());
        placed_.resize(chart.transition_count(), false);
        for (std::uint32_t t = 0; t < chart.transition_count(); ++t) {
            for (const StepId step : chart.preceding(TransitionId{t})) {
                layout.out_of[index_of(step)].push_back(TransitionId{t});
            }
        }
    }

    void walk_graph(GraphId graph) {
        for (const bool initial : {true, false}) {
            for (const StepId step : chart_.steps_of(graph)) {
                if (chart_.is_initial(step) != initial) continue;
                if (states_[index_of(step)] == State::unseen) walk_from(step);
            }
        }
        ++layout_.columns;  // a gap between graphs
    }

    void set_levels() {
        std::reverse(finished_.begin(), finished_.end());
        for (const StepId step : finished_) {
            const int level = layout_.steps[index_of(step)].level;
            for (const TransitionId id : layout_.out_of[index_of(step)]) {
                Layout::Place& place = layout_.transitions[index_of(id)];
                place.level = std::max(place.level, level);
                for (const StepId next : chart_.following(id)) {
                    if (is_jump(id, next)) continue;
                    int& below = layout_.steps[index_of(next)].level;
                    below = std::max(below, level + 1);
                }
            }
        }
        for (std::uint32_t t = 0; t < chart_.transition_count(); ++t) {
            const TransitionId id{t};
            for (const StepId step : chart_.following(id)) {
                layout_.into[index_of(step)].push_back({id, step, is_jump(id, step)});
            }
        }
        for (std::vector<Layout::Link>& links : layout_.into) part_bars(links);
    }

  private:
    enum class State : std::uint8_t { unseen, on_the_way, finished };
    struct Frame {
        StepId step{};
        std::size_t next = 0;  ///< of its successors
        std::vector<StepId> successors;
    };

    /// Where several links meet, those of simultaneous sequences become jumps.
    void part_bars(std::vector<Layout::Link>& links) {
        const auto is_joined = [](const Layout::Link& link) { return !link.is_jump; };
        if (std::count_if(links.begin(), links.end(), is_joined) < 2) return;
        for (Layout::Link& link : links) {
            if (chart_.following(link.transition).size() > 1) link.is_jump = true;
        }
    }

    void place(TransitionId id, int column) {
        layout_.transitions[index_of(id)].column = column;
        placed_[index_of(id)] = true;
    }

    Frame enter(StepId step, int column) {
        states_[index_of(step)] = State::on_the_way;
        layout_.steps[index_of(step)].column = column;
        Frame frame{step, 0, {}};
        bool is_first = true;
        for (const TransitionId id : layout_.out_of[index_of(step)]) {
            if (!placed_[index_of(id)]) place(id, is_first ? column : layout_.columns++);
            is_first = false;
            for (const StepId next : chart_.following(id)) {
                frame.successors.push_back(next);
            }
        }
        return frame;
    }

    /// The column of the transition that leads to a step, where no other step stands below it yet.
    int column_for(StepId step, StepId from) {
        for (const TransitionId id : layout_.out_of[index_of(from)]) {
            const auto following = chart_.following(id);
            if (following.front() == step) return layout_.transitions[index_of(id)].column;
        }
        return layout_.columns++;
    }

    void walk_from(StepId first) {
        std::vector<Frame> way;
        way.push_back(enter(first, layout_.columns++));
        while (!way.empty()) {
            Frame& frame = way.back();
            if (frame.next == frame.successors.size()) {
                states_[index_of(frame.step)] = State::finished;
                finished_.push_back(frame.step);
                way.pop_back();
                continue;
            }
            const StepId next = frame.successors[frame.next++];
            const State state = states_[index_of(next)];
            if (state == State::on_the_way) jumps_.emplace_back(frame.step, next);
            if (state == State::unseen) way.push_back(enter(next, column_for(next, frame.step)));
        }
    }

    /// Whether a link from any step before the transition closes a loop.
    bool is_jump(TransitionId id, StepId to) {
        if (!sorted_) std::sort(jumps_.begin(), jumps_.end());
        sorted_ = true;
        const auto preceding = chart_.preceding(id);
        return std::any_of(preceding.begin(), preceding.end(), [&](StepId from) {
            return std::binary_search(jumps_.begin(), jumps_.end(), std::pair(from, to));
        });
    }

    const Chart& chart_;
    Layout& layout_;
    std::vector<State> states_;
    std::vector<bool> placed_;  ///< per transition
    std::vector<StepId> finished_;
    std::vector<std::pair<StepId, StepId>> jumps_;
    bool sorted_ = false;
};

}  // namespace

Layout layout_of(const Chart& chart) {
    Layout layout;
    Walk walk(chart, layout);
    for (std::uint32_t g = 0; g < chart.graph_count(); ++g) walk.walk_graph(GraphId{g});
    walk.set_levels();
    return layout;
}

}  // namespace grafwire::sfc
