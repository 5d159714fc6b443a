#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "random/features.h"
#include "random/random_source.h"

namespace grafwire::testing {

inline constexpr std::size_t nothing = static_cast<std::size_t>(-1);

/// A step or macro-step of a block.
struct PlannedNode {
    enum class Kind { step, macro, entry, exit };
    Kind kind = Kind::step;
    std::string name;
    bool initial = false;
    std::size_t expansion = nothing;  ///< of a macro-step: a block
    std::size_t encloses = nothing;   ///< of a step: a graph
};

struct PlannedBlock {
    std::string name;
    std::size_t graph = 0;
    bool is_expansion = false;
    std::vector<PlannedNode> nodes;
};

/// The bones of a random GRAFCET: which steps there are, and where. Orders and enclosures go from a
/// graph to one of a higher number, so that they never form a circle.
struct ChartPlan {
    std::vector<PlannedBlock> blocks;  ///< the graphs come first, in their order
    std::size_t graph_count = 0;

    /// The names of the steps of a graph, expansions included.
    std::vector<std::string> steps_of(std::size_t graph) const;
};

ChartPlan random_plan(RandomSource& random, const Features& features);

}  // namespace grafwire::testing
