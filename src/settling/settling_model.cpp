// The delay models that leave delays open, and what answers for each.

#include "settling/settling_model.h"

#include <algorithm>

#include "settling/any_order.h"
#include "settling/any_wire.h"
#include "settling/cell_bands.h"
#include "settling/timed_order.h"

namespace grafwire {

void ChangedNets::add(const Firing& firing) {
    for (const CellAction& action : firing) nets_.push_back(circuit_.output(action.cell));
}

std::vector<NetId> ChangedNets::take() {
    std::sort(nets_.begin(), nets_.end());
    nets_.erase(std::unique(nets_.begin(), nets_.end()), nets_.end());
    return std::move(nets_);
}

std::unique_ptr<SettlingModel> make_settling_model(const DelayModel& model, const Circuit& circuit,
                                                   KeepGoing keep_going) {
    switch (model.kind) {
        case DelayModel::Kind::fixed:
            return nullptr;
        case DelayModel::Kind::bounded:
            return std::make_unique<TimedOrder>(circuit, cell_bands(circuit.netlist(), model),
                                                std::move(keep_going));
        case DelayModel::Kind::any:
            return std::make_unique<AnyOrder>(circuit, std::move(keep_going));
        case DelayModel::Kind::any_wire:
            return std::make_unique<AnyWire>(circuit, std::move(keep_going));
    }
    return nullptr;
}

}  // namespace grafwire
