// The delay models that leave delays open, and what answers for each.

#include "settling/settling_model.h"

#include "settling/any_order.h"
#include "settling/cell_bands.h"
#include "settling/timed_order.h"

namespace grafwire {

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
    }
    return nullptr;
}

}  // namespace grafwire
