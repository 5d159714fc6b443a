#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "check/partial_inputs.h"
#include "check/path.h"
#include "check/zone.h"

namespace grafwire {

/// The states that an exploration has reached: each an encoding of everything that decides how it
/// goes on, except what can remain of its delays, and that as a zone.
class VisitedStates {
  public:
    /// Notes a state; false where it has been reached before, with all that can remain of its
    /// delays now.
    bool add(const std::string& encoding, const Zone& zone);
    /// Whether a state that was added has since been reached with more that can remain.
    bool is_covered(const std::string& encoding, const Zone& zone) const;

  private:
    std::unordered_map<std::string, std::vector<Zone>> zones_;  ///< none includes another
};

/// How an exploration has reached its states: a tree of steps, each with its predecessor. A state
/// keeps the number of the step that led to it; the numbers grow along every path.
class PredecessorTree {
  public:
    static constexpr std::uint32_t root = 0xffffffffU;  ///< before the first instant

    /// `inserts`: whether a path gets steps of its own for what changes without an effect; where
    /// not, the inputs before a step may differ from those that the step before it leads to.
    PredecessorTree(const Assumptions& assumptions, bool inserts)
        : assumptions_(assumptions), inserts_(inserts) {}

    /// The number that the next step will have.
    std::uint32_t next() const { return static_cast<std::uint32_t>(nodes_.size()); }
    /// A step onwards from where `predecessor` led. The instants in its `running` are numbers of
    /// steps.
    void add(std::uint32_t predecessor, PathStep step);

    /// The path from the root to where `predecessor` led, and `last`. The instants in `running` are
    /// places in the path then.
    std::vector<PathStep> path(std::uint32_t predecessor, PathStep last) const;

  private:
    void assign_throughout(PathStep& step, const PartialInputs& wanted, bool is_first) const;

    struct Node {
        std::uint32_t predecessor;
        PathStep step;
    };
    const Assumptions& assumptions_;
    bool inserts_;
    std::vector<Node> nodes_;
};

}  // namespace grafwire
