#include "check/pair_state.h"

#include <algorithm>

namespace grafwire {

bool SeenPairs::add(const PairState& pair) {
    const Zone& zone = pair.delays.zone();
    std::vector<Zone>& zones = zones_[pair.key];
    for (const Zone& seen : zones) {
        if (seen.includes(zone)) return false;
    }
    std::erase_if(zones, [&](const Zone& seen) { return zone.includes(seen); });
    zones.push_back(zone);
    return true;
}

bool SeenPairs::is_covered(const PairState& pair) const {
    const std::vector<Zone>& zones = zones_.at(pair.key);
    return std::find(zones.begin(), zones.end(), pair.delays.zone()) == zones.end();
}

}  // namespace grafwire
