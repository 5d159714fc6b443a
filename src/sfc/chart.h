#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "grafcet/grafcet.h"

namespace grafwire::sfc {

/// The steps and transitions of a sequential function chart: those of a GRAFCET, and auxiliary
/// steps behind them, for in SFC every transition has a step before it and one after it.
///
/// - A source transition leaves a step that is always active: an initial one, which is also among
///   the steps that follow. Each has one of its own: two that shared one would be a selection.
/// - A sink transition leads to a step that nothing leaves.
/// - Steps that no initial one leads to, since orders activate them or nothing does, follow a step
///   `idle` of their graph after a transition whose condition is FALSE: tools leave out what an
///   initial step does not lead to.
class Chart {
  public:
    explicit Chart(const Grafcet& grafcet);

    /// The auxiliary steps have the numbers from Grafcet::steps.size() on, auxiliary transitions
    /// those from Grafcet::transitions.size() on.
    std::size_t step_count() const { return initial_.size(); }
    std::size_t graph_count() const { return graphs_.size(); }
    std::size_t transition_count() const { return transitions_.size(); }
    bool is_initial(StepId step) const { return initial_[index_of(step)]; }
    /// The steps of a graph, in the order of the file, then the auxiliary ones.
    std::span<const StepId> steps_of(GraphId graph) const { return graphs_[index_of(graph)]; }
    std::span<const StepId> preceding(TransitionId id) const {
        return transitions_[index_of(id)].preceding;
    }
    std::span<const StepId> following(TransitionId id) const {
        return transitions_[index_of(id)].following;
    }

    struct Auxiliary {
        enum class Kind : std::uint8_t { source, end, idle };
        Kind kind = Kind::source;
        TransitionId transition{};  ///< that a source stands before, an end after
        GraphId graph{};
    };
    const std::vector<Auxiliary>& auxiliaries() const { return auxiliaries_; }

  private:
    struct Links {
        std::vector<StepId> preceding;
        std::vector<StepId> following;
    };
    StepId add_step(const Auxiliary& auxiliary);
    void add_idle_steps();
    void mark_reached(StepId first, std::vector<bool>& reached) const;

    std::vector<bool> initial_;
    std::vector<Links> transitions_;
    std::vector<std::vector<StepId>> graphs_;
    std::vector<Auxiliary> auxiliaries_;
};

}  // namespace grafwire::sfc
