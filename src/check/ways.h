#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "check/path.h"

namespace grafwire {

/// The ways by which an exploration has reached its states: a tree of steps. A state keeps the
/// number of the step that led to it; the numbers grow along every way.
class Ways {
  public:
    static constexpr std::uint32_t start = 0xffffffffU;  ///< before the first instant

    /// `inserts`: whether a path gets steps of its own for what changes without an effect; where
    /// not, the inputs before a step may differ from those that the step before it leads to.
    Ways(const Assumptions& assumptions, bool inserts)
        : assumptions_(assumptions), inserts_(inserts) {}

    /// The number that the next step will have.
    std::uint32_t next() const { return static_cast<std::uint32_t>(steps_.size()); }
    /// A step onwards from where `parent` led. The instants in its `running` are numbers of steps.
    void add(std::uint32_t parent, PathStep step);

    /// The path from the start to where `parent` led, and `last`. The instants in `running` are
    /// places in the path then.
    std::vector<PathStep> path(std::uint32_t parent, PathStep last) const;

  private:
    void close_all_along(PathStep& step, const PartialInputs& wanted, bool is_first) const;

    struct Step {
        std::uint32_t parent;
        PathStep step;
    };
    const Assumptions& assumptions_;
    bool inserts_;
    std::vector<Step> steps_;
};

}  // namespace grafwire
