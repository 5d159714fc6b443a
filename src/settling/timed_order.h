#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "settling/any_order.h"
#include "settling/cell_bands.h"
#include "settling/firing_domain.h"
#include "settling/settling_model.h"
#include "settling/stubborn_sets.h"

namespace grafwire {

/// The model in which every change of a gate takes any time between two bounds, each for itself.
class TimedOrder : public SettlingModel {
  public:
    TimedOrder(const Circuit& circuit, CellBands bands, KeepGoing keep_going);
    Rests settle(const CircuitState& start, bool with_firings, std::size_t most_states) override;

  private:
    using End = FiringGraph::End;
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
    };
    End build(const CircuitState& start, std::size_t most_classes);
    std::uint32_t add(const CircuitState& state, StateClass&& reached);
    bool turns_before(std::uint32_t number, const std::string& state) const;
    bool expand(std::uint32_t number);
    void fire(std::uint32_t number, const CircuitState& from, const Firing& firing);
    std::vector<CellAction> pending_in(const CircuitState& state) const;
    std::vector<FiringDomain::Origin> origins_after(const std::vector<CellAction>& before,
                                                    const Firing& firing, const CircuitState& to,
                                                    const std::vector<CellAction>& pending) const;
    DelayBand band_of(const CircuitState& state, const CellAction& action,
                      bool is_first_answer) const;
    CircuitState state(std::uint32_t number) const;
    void append_rests(Rests& rests, bool with_firings) const;
    void append_endless(Rests& rests) const;
    void append_drifting(Rests& rests) const;
    void append_oscillation(std::uint32_t number, std::vector<NetId> changing, Rests& rests) const;
    std::vector<Firing> way_to(std::uint32_t number) const;

    const Circuit& circuit_;
    const CellBands bands_;
    const KeepGoing keep_going_;
    AnyOrder any_order_;
    StubbornSets sets_;
    CircuitState like_;
    /// Per state, the classes that have been reached with it.
    std::unordered_map<std::string, std::vector<std::uint32_t>> classes_of_;
    std::vector<StateClass> classes_;
    static constexpr std::uint32_t nowhere = 0xffffffffU;
    std::uint32_t drifting_ = nowhere;  ///< a class before a state with too many classes
};

}  // namespace grafwire
