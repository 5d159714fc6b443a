#include "ladder/run_ladder.h"

#include <map>

#include "ladder/machine.h"

namespace grafwire::testing {

Trace run_ladder(const Grafcet& grafcet, const ladder::Ladder& ladder, const Stimuli& stimuli,
                 Time period) {
    std::map<std::string, ladder::VariableId> ids;
    for (std::uint32_t v = 0; v < ladder.variables.size(); ++v) {
        ids.emplace(ladder.variables[v].name, ladder::VariableId{v});
    }
    Trace trace = empty_trace(grafcet);
    const ladder::Machine machine(ladder);
    ladder::MachineState state = machine.start();
    const auto value_of = [&](const std::string& name) -> std::int64_t {
        const auto found = ids.find(name);
        if (found == ids.end()) return Trace::unknown;
        const auto& cell = state.cells[static_cast<std::size_t>(found->second)];
        if (ladder.variable(found->second).type == ladder::Type::integer) return cell.number;
        return cell.bit.value == Logic::one ? 1 : 0;
    };
    std::size_t next = 0;
    for (Time now = 0; now <= stimuli.end; now += period) {
        for (; next < stimuli.changes.size() && stimuli.changes[next].at <= now; ++next) {
            for (const auto& [input, value] : stimuli.changes[next].assignments) {
                const auto found = ids.find(std::string(input_name(grafcet, input)));
                if (found == ids.end()) return empty_trace(grafcet);
                machine.set(state, found->second, value ? Logic::one : Logic::zero);
            }
        }
        if (machine.scan(state, now).needs) return empty_trace(grafcet);
        trace.times.push_back(now);
        for (const Trace::Column& column : trace.columns) {
            trace.values.push_back(value_of(column.name));
        }
    }
    return trace;
}

}  // namespace grafwire::testing
