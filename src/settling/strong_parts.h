#pragma once

#include <cstdint>
#include <vector>

namespace grafwire {

/// The strongly connected parts of a graph: which nodes can be gone round among.
struct StrongParts {
    std::vector<std::uint32_t> of_node;  ///< per node the number of its part
    std::size_t count = 0;
};

/// `successors`: per node.
StrongParts strong_parts(const std::vector<std::vector<std::uint32_t>>& successors);

}  // namespace grafwire
