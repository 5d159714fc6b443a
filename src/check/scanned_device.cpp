#include "check/scanned_device.h"

#include <algorithm>
#include <numeric>

#include "evolution/run.h"

namespace grafwire {

namespace {

std::int64_t shown(Logic value) {
    if (value == Logic::unknown) return Trace::unknown;
    return value == Logic::one ? 1 : 0;
}

}  // namespace

Time natural_period(const Grafcet& grafcet, const ScannedDevice& device) {
    Time divisor = 0;
    for (const Time delay : device.delays()) divisor = std::gcd(divisor, delay);
    const auto conditions = grafcet.expressions.time_conditions();
    for (const ExprId id : conditions) {
        const TimeCondition& condition = grafcet.expressions.time_condition_of(id);
        divisor = std::gcd(divisor, std::gcd(condition.on_delay, condition.off_delay));
    }
    if (divisor == 0) return 10 * millisecond;
    return conditions.size() > 1 && divisor > 1 ? divisor / 2 : divisor;
}

Trace run_device(const Grafcet& grafcet, const ScannedDevice& device, const Stimuli& stimuli,
                 Time period) {
    Trace trace = empty_trace(grafcet);
    PartialInputs inputs(grafcet.all_input_count(), Logic::zero);
    std::string memory = device.start();
    std::size_t next = 0;
    for (Time now = 0;; now += period) {
        for (; next < stimuli.changes.size() && stimuli.changes[next].at <= now; ++next) {
            for (const Stimuli::Assignment& set : stimuli.changes[next].assignments) {
                inputs[set.input] = logic_of(set.value);
            }
        }
        ScannedDevice::Outcome outcome = device.scan(memory, inputs, now);
        memory = std::move(outcome.memory);
        trace.times.push_back(now);
        for (const std::vector<Logic>* values : {&inputs, &outcome.steps, &outcome.outputs}) {
            for (const Logic value : *values) trace.values.push_back(shown(value));
        }
        trace.values.resize(trace.times.size() * trace.columns.size(), Trace::unknown);
        if (period > stimuli.end - now) return trace;
    }
}

std::optional<Witness> replay_scans(const Grafcet& grafcet, const ScannedDevice& device,
                                    const Stimuli& stimuli, Time period) {
    auto witness = first_difference(grafcet, stimuli, run_scans(grafcet, stimuli, period),
                                    run_device(grafcet, device, stimuli, period));
    if (witness) witness->scan_period = period;
    return witness;
}

}  // namespace grafwire
