#pragma once

#include "settling/cell_bands.h"
#include "settling/settling_model.h"
#include "settling/timed_graph.h"

namespace grafwire {

/// The model in which every change of a gate takes any time between two bounds, each for itself.
class TimedOrder : public SettlingModel {
  public:
    TimedOrder(const Circuit& circuit, CellBands bands, KeepGoing keep_going);
    Rests settle(const CircuitState& start, bool with_firings, std::size_t most_states) override;
    Pulsing pulsing(const CircuitState& start, const WatchedNet& watched,
                    std::size_t most_states) override;

  private:
    Rests explore(const CircuitState& start, const TimedGraph::Search& search, bool with_firings);
    Rests with_ways(const CircuitState& start, std::size_t most_classes);

    const Circuit& circuit_;
    const KeepGoing keep_going_;
    TimedGraph graph_;
};

}  // namespace grafwire
