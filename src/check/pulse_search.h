#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "check/check_result.h"
#include "check/netlist_case.h"
#include "check/partial_inputs.h"
#include "check/path.h"
#include "check/reference_case.h"
#include "settling/circuit.h"
#include "settling/open_cone.h"
#include "settling/settling_model.h"

namespace grafwire {

/// Looks, case by case, for X and outputs that an asynchronous netlist can change more often in an
/// instant than the reference does (see the source). What it is made of must outlive it.
class PulseSearch : private NetlistCases {
  public:
    PulseSearch(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& nominal,
                const CheckOptions& options);

    /// A case of an exploration: from a state of both sides, whose inputs were `left`.
    struct Case {
        const EvolutionState& reference;
        const SimulatorState& netlist;
        const PartialInputs& left;
        const PathStep& step;
    };
    /// Gives stimuli whose last instant is this step, as different as the times that they take.
    using StimuliFor = std::function<std::vector<Stimuli>(const PathStep&)>;
    void look_at(const Case& one, const StimuliFor& stimuli_for);

    /// Whether there are X and outputs of which it could not be told in some case.
    bool has_open() const;
    /// Keeps what was found, and forgets what stayed open.
    void begin_again();
    Pulses take();

  private:
    /// An X or output.
    struct Watched {
        std::string name;
        NetId net = no_net;
        std::optional<Pulse> found;
        std::uint64_t open_cases = 0;
        int failures = 0;      ///< that it was found and could not be shown
        bool is_open = false;  ///< in the case at hand
    };
    using Places = std::vector<std::size_t>;  ///< in watched_
    /// A part of a case, by its inputs, and what is to be looked at in it.
    struct Part {
        PathStep step;
        Places watched;
    };

    bool is_one_at_a_time() const { return options_.changes == Changes::one; }
    bool is_done(const Watched& watched) const;
    std::vector<PathStep> changes_in(const Case& one) const;
    std::vector<PathStep> changes_of_unassigned(const Case& one) const;
    void look_at_change(const Case& one, const PathStep& step, const StimuliFor& stimuli_for);
    CircuitState begin_part(const Case& one, const PathStep& step);
    void keep_unsteady(Places& places);
    std::optional<UnknownCause> unassigned_behind(std::size_t place, const CircuitState& from,
                                                  const PathStep& step) const;
    void look_at_part(const Case& one, Part part, std::vector<Part>& remaining,
                      const StimuliFor& stimuli_for);
    std::optional<PathStep> completed(const PathStep& step) const;
    void look_closely(const Case& one, const PathStep& step, const Places& places,
                      const StimuliFor& stimuli_for);
    Pulsing::Answer answer(const WatchedNet& watched, const CircuitState& from);
    std::string key_of(const WatchedNet& watched, const std::vector<NetId>& cone,
                       const CircuitState& from) const;
    bool show(Watched& watched, std::uint8_t expected, const std::vector<Stimuli>& stimuli);
    std::optional<Pulse> pulse_over(const Watched& watched, std::uint8_t expected,
                                    const Stimuli& stimuli) const;

    const CheckOptions& options_;
    const Assumptions assumptions_;
    const Evolution evolution_;
    const ReferenceCases reference_;
    const Circuit circuit_;
    OpenCone cone_;
    std::vector<Logic> left_;  ///< values of the nets before the part at hand
    std::vector<Watched> watched_;
    std::unordered_map<std::string, Pulsing::Answer> answers_;
    std::uint64_t cases_ = 0;
};

}  // namespace grafwire
