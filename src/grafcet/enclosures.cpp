#include "grafcet/enclosures.h"

#include <algorithm>
#include <utility>

namespace grafwire {

std::vector<std::uint32_t> enclosures_inwards(const Grafcet& grafcet) {
    std::vector<std::pair<std::size_t, std::uint32_t>> by_depth;
    for (std::uint32_t e = 0; e < grafcet.enclosures.size(); ++e) {
        std::size_t depth = 0;
        for (std::uint32_t outer = e; outer != none; ++depth) {
            const Step& enclosing = grafcet.steps[grafcet.enclosures[outer].step];
            outer = grafcet.graphs[enclosing.graph].enclosed_by;
        }
        by_depth.emplace_back(depth, e);
    }
    std::sort(by_depth.begin(), by_depth.end());
    std::vector<std::uint32_t> inwards;
    for (const auto& [depth, e] : by_depth) inwards.push_back(e);
    return inwards;
}

}  // namespace grafwire
