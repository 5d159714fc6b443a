// Most of a netlist has no part in what one net does at an instant: it keeps its value, or it moves
// behind gates at which another pin decides. What may move is taken from three values (reach.h),
// which is more than really can; so a cone may come out too large, never too small.

#include "settling/open_cone.h"

#include <algorithm>

namespace grafwire {

void OpenCone::make(const CircuitState& state) {
    std::vector<std::uint32_t> moving;
    for (const CellAction& action : circuit_.actions(state)) moving.push_back(action.cell);
    for (const CellAction& action : circuit_.ending_delays(state)) moving.push_back(action.cell);
    reach_.make(state, moving, none_);
}

std::vector<NetId> OpenCone::behind(NetId net) const {
    std::vector<NetId> nets{net};
    for (std::size_t next = 0; next < nets.size(); ++next) {
        const std::uint32_t driver = circuit_.driver(nets[next]);
        if (driver == Circuit::none) continue;
        for (const NetId pin : circuit_.pins(driver)) {
            const bool is_new = std::find(nets.begin(), nets.end(), pin) == nets.end();
            if (is_new && is_open(pin)) nets.push_back(pin);
        }
    }
    std::sort(nets.begin(), nets.end());
    return nets;
}

}  // namespace grafwire
