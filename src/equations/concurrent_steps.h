#pragma once

#include <cstdint>
#include <span>
#include <unordered_set>
#include <vector>

#include "grafcet/grafcet.h"

namespace grafwire {

/// Which steps of one graph can be active together, as far as the structure tells: transition
/// conditions count only where they are constantly 0, and of the branches of a selection one is
/// taken.
class ConcurrentSteps {
  public:
    /// `most_pairs`: where more pairs are found, the search ends and is_complete() is false.
    explicit ConcurrentSteps(const Grafcet& grafcet, std::size_t most_pairs = 1'000'000);

    /// Never of a step with itself.
    bool are_concurrent(StepId a, StepId b) const { return pairs_.contains(key(a, b)); }
    /// Whether a step is concurrent with every step of the list (other than itself), and these with
    /// each other.
    bool are_concurrent(StepId step, std::span<const StepId> others) const;
    bool is_complete() const { return is_complete_; }

  private:
    struct Pair {
        StepId a{};
        StepId b{};
    };
    static std::uint64_t key(StepId a, StepId b);
    // Situations that come about at once, and the first things that follow from them.
    void start();
    void start_together(std::span<const StepId> steps);
    void reach(StepId step);
    void pair(StepId a, StepId b);
    // What a pair leads to.
    void follow(const Pair& pair);
    void extend(StepId from, StepId other);
    // What a transition leads to.
    bool is_enabled(const Transition& transition) const;
    void enable(TransitionId id);
    void spread(const Transition& transition, StepId bystander);

    const Grafcet& grafcet_;
    std::size_t most_pairs_;
    bool is_complete_ = true;
    std::vector<std::uint32_t> first_out_of_;  ///< as in StepTransitions
    std::vector<TransitionId> out_of_;
    std::vector<bool> can_clear_;  ///< per transition
    std::vector<bool> enabled_;    ///< per transition
    std::vector<bool> reached_;    ///< per step
    std::vector<StepId> reached_steps_;
    std::vector<std::vector<StepId>> neighbours_;  ///< per step: those it is concurrent with
    std::vector<TransitionId> sources_;            ///< transitions without a step before them
    std::unordered_set<std::uint64_t> pairs_;      ///< by key()
    std::vector<Pair> open_;                       ///< found, not yet followed
    std::vector<StepId> open_steps_;
};

}  // namespace grafwire
