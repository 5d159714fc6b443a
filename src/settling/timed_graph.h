#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <unordered_map>
#include <vector>

#include "settling/cell_bands.h"
#include "settling/firing_domain.h"
#include "settling/firing_graph.h"
#include "settling/settling_model.h"
#include "settling/timed_stubborn_sets.h"
#include "text/keep_going.h"

namespace grafwire {

/// The states that a circuit can pass through within an instant, with the times at which its gates
/// can fire there, where delays have bounds.
class TimedGraph {
  public:
    TimedGraph(const Circuit& circuit, CellBands bands);

    using End = FiringGraph::End;
    struct Search {
        /// Classes of one state, before those that come after are merged with the last: more may be
        /// possible there than really is.
        std::size_t most_of_a_state = 0;
        std::size_t most_classes = 0;  ///< in all, each as often as it is gone on from
        /// After so many rests the search is over; 0: after all.
        std::size_t most_rests = 0;
        bool deep_first = false;  ///< else the ways to rests are as short as can be
    };
    /// With a net that is watched, states also differ in how often it has changed. A class in which
    /// that is too often is gone on from alone, until a rest.
    End build(const CircuitState& start, const Search& search, const KeepGoing& keep_going,
              const WatchedNet* watched = nullptr);

    std::size_t class_count() const { return classes_.size(); }
    /// Whether no class stands for more than can be.
    bool is_exact() const { return !is_merged_; }
    /// The states in which nothing more happens, each once.
    std::vector<Rest> rests(bool with_firings) const;
    /// What can be gone through again and again. As a class may stand for others that it includes,
    /// that is more than can be, and for a replay to decide.
    std::vector<Rest> oscillations() const;
    /// Whether times were left out because a part of the circuit seemed to go round for ever.
    bool is_drifting() const { return drifting_ != nowhere; }
    /// The firings of the last class that was gone on from.
    std::vector<Firing> last_way() const { return way_to(last_); }

  private:
    struct Edge {
        std::uint32_t to = 0;
        Firing firing;
    };
    /// A state with the times at which its excited cells can fire.
    struct StateClass {
        const std::string* encoding = nullptr;
        std::vector<CellAction> pending;  ///< the components of the domain
        FiringDomain domain;
        std::uint32_t parent = 0;
        Firing firing;  ///< that led to it from there
        std::vector<Edge> edges;
        std::uint32_t mergers = 0;
        bool is_waiting = true;    ///< to be gone on from
        std::uint8_t changes = 0;  ///< of a net that is watched
    };
    std::uint32_t add(const CircuitState& state, StateClass&& reached);
    void merge(std::uint32_t known, const FiringDomain& domain);
    bool turns_before(std::uint32_t number, const std::string& state) const;
    bool expand(std::uint32_t number);
    bool follow_excess(std::size_t first_new);
    void fire(std::uint32_t number, const CircuitState& from, const Firing& firing);
    std::vector<CellAction> pending_in(const CircuitState& state) const;
    std::vector<FiringDomain::Origin> origins_after(const std::vector<CellAction>& before,
                                                    const Firing& firing, const CircuitState& to,
                                                    const std::vector<CellAction>& pending) const;
    DelayBand band_of(const CircuitState& state, const CellAction& action,
                      bool is_first_answer) const;
    CircuitState state(std::uint32_t number) const;
    Rest oscillation(std::uint32_t number, std::vector<NetId> changing) const;
    Rest drifting() const;
    std::vector<Firing> way_to(std::uint32_t number) const;

    const Circuit& circuit_;
    const CellBands bands_;
    TimedStubbornSets sets_;
    Search search_;
    CircuitState like_;
    /// Per state, the classes that have been reached with it.
    std::unordered_map<std::string, std::vector<std::uint32_t>> classes_of_;
    std::vector<StateClass> classes_;
    std::deque<std::uint32_t> waiting_;
    static constexpr std::uint32_t nowhere = 0xffffffffU;
    const WatchedNet* watched_ = nullptr;
    std::uint32_t last_ = 0;  ///< the last that was gone on from
    bool is_exceeded_ = false;
    bool is_merged_ = false;
    std::uint32_t drifting_ = nowhere;  ///< a class before a state with too many classes
};

}  // namespace grafwire
