#include "grafcet/forcing_hierarchy.h"

namespace grafwire {

std::vector<std::size_t> forcing_depths(const Grafcet& grafcet) {
    std::vector<std::size_t> depths(grafcet.graphs.size(), 0);
    // Orders form no circle, so this comes to an end.
    for (bool deepened = true; deepened;) {
        deepened = false;
        for (const Order& order : grafcet.orders) {
            if (order.kind == OrderKind::freeze) continue;
            const std::size_t giver = depths[index_of(grafcet.steps[order.step].graph)];
            std::size_t& forced = depths[index_of(order.graph)];
            if (forced > giver) continue;
            forced = giver + 1;
            deepened = true;
        }
    }
    return depths;
}

}  // namespace grafwire
