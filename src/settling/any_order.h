#pragma once

#include "settling/firing_graph.h"
#include "settling/settling_model.h"
#include "settling/stubborn_sets.h"

namespace grafwire {

/// The model in which every gate may take any finite time, and all that reads a net sees its change
/// at once (isochronic forks).
class AnyOrder : public SettlingModel {
  public:
    AnyOrder(const Circuit& circuit, KeepGoing keep_going)
        : circuit_(circuit), keep_going_(std::move(keep_going)), sets_(circuit), graph_(circuit) {}
    Rests settle(const CircuitState& start, bool with_firings, std::size_t most_states) override;
    Pulsing pulsing(const CircuitState& start, const WatchedNet& watched,
                    std::size_t most_states) override;
    /// Sequences side by side multiply, and all their states are found in some seconds.
    std::size_t most_states() const override { return 10 * usual_states; }

  private:
    FiringGraph::End build(const CircuitState& start, bool reduced, std::size_t most_states,
                           const WatchedNet* watched = nullptr);
    void append_settled(Rests& rests, bool with_firings) const;
    bool append_endless(Rests& rests, bool with_firings) const;

    const Circuit& circuit_;
    const KeepGoing keep_going_;
    StubbornSets sets_;
    FiringGraph graph_;
};

}  // namespace grafwire
