#include "check/pair_state.h"

#include <algorithm>

#include "check/keys.h"

namespace grafwire {

namespace {

/// Four values to a byte.
void append_logic(std::string& key, const std::vector<Logic>& values) {
    for (std::size_t i = 0; i < values.size(); i += 4) {
        unsigned packed = 0;
        for (std::size_t j = i; j < std::min(i + 4, values.size()); ++j) {
            packed = packed * 4 + static_cast<unsigned>(values[j]);
        }
        key += static_cast<char>(packed);
    }
}

}  // namespace

std::string key_of(const PairState& pair) {
    std::string key;
    append_key(key, pair.reference);
    pair.delays.append_key(key);
    append_logic(key, pair.inputs);
    append_logic(key, pair.netlist.values);
    return key;
}

bool SeenPairs::add(const PairState& pair) {
    const Zone& zone = pair.delays.zone();
    std::vector<Zone>& zones = zones_[key_of(pair)];
    for (const Zone& seen : zones) {
        if (seen.includes(zone)) return false;
    }
    std::erase_if(zones, [&](const Zone& seen) { return zone.includes(seen); });
    zones.push_back(zone);
    return true;
}

bool SeenPairs::is_covered(const PairState& pair) const {
    const std::vector<Zone>& zones = zones_.at(key_of(pair));
    return std::find(zones.begin(), zones.end(), pair.delays.zone()) == zones.end();
}

}  // namespace grafwire
