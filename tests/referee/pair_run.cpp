#include "referee/pair_run.h"

#include <algorithm>

#include "text/time.h"

namespace grafwire::testing {

// The reference.

void ReferenceRun::start(const InputValues& inputs) {
    if (is_plain_) {
        plain_state_ = plain_.start(inputs);
    } else {
        state_ = evolution_.start({inputs});
    }
}

bool ReferenceRun::instant(Time now, const InputValues& inputs) {
    if (is_plain_) {
        if (now != 0) plain_.end_delays(plain_state_, inputs, now);
        std::vector<std::string> changing;
        return plain_.settle(plain_state_, inputs, now, changing);
    }
    if (now != 0) evolution_.end_delays(state_, {inputs}, now);
    return evolution_.settle(state_, {inputs}, now).stable;
}

void ReferenceRun::scan(Time now, const InputValues& inputs) {
    if (is_plain_) {
        plain_.scan(plain_state_, inputs, now);
    } else {
        evolution_.scan(state_, {inputs}, now);
    }
}

Time ReferenceRun::next_end() const {
    Time first = never;
    if (!is_plain_) {
        for (const Time due : state_.due) first = std::min(first, due);
        return first;
    }
    const Expressions& pool = grafcet_.expressions;
    for (std::size_t i = 0; i < plain_state_.waiting.size(); ++i) {
        if (!plain_state_.waiting[i]) continue;
        const TimeCondition& condition = pool.time_condition_of(pool.time_conditions()[i]);
        const Time delay = plain_state_.times[i] ? condition.off_delay : condition.on_delay;
        first = std::min(first, add_times(plain_state_.since[i], delay));
    }
    return first;
}

std::vector<bool> ReferenceRun::shown(const InputValues& inputs) const {
    std::vector<bool> values;
    if (is_plain_) {
        values = plain_state_.ts;
        const std::vector<bool> outputs = plain_.outputs(plain_state_, inputs);
        values.insert(values.end(), outputs.begin(), outputs.end());
        return values;
    }
    const OutputValues outputs = evolution_.outputs(state_, {inputs});
    for (std::size_t i = 0; i < state_.situation.size(); ++i) {
        values.push_back(state_.situation.test(i));
    }
    for (std::size_t i = 0; i < outputs.size(); ++i) values.push_back(outputs.test(i));
    return values;
}

std::string differences(const Grafcet& grafcet, const std::vector<bool>& expected,
                        const std::vector<bool>& got) {
    const std::size_t steps = grafcet.steps.size();
    std::string text;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (expected[i] == got[i]) continue;
        const std::string name = i < steps ? "X" + grafcet.steps.items()[i].name
                                           : grafcet.outputs.items()[i - steps].name;
        text += " " + name + (got[i] ? " is 1, not 0" : " is 0, not 1");
    }
    return text;
}

// Both.

bool PairRun::start(const InputValues& inputs, const std::vector<bool>& power_up) {
    reference_.start(inputs);
    return gates_.start(inputs, power_up);
}

Comparison PairRun::compared(const InputValues& inputs) const {
    return reference_.shown(inputs) == gates_.shown() ? Comparison::alike : Comparison::differ;
}

Comparison PairRun::instant(Time now, const InputValues& inputs) {
    if (!reference_.instant(now, inputs)) return Comparison::unstable;
    if (!gates_.instant(now, inputs)) return Comparison::unsettled;
    return compared(inputs);
}

Comparison PairRun::scan(Time now, const InputValues& inputs) {
    reference_.scan(now, inputs);
    if (!gates_.scan(now, inputs)) return Comparison::unsettled;
    return compared(inputs);
}

std::string PairRun::difference(const InputValues& inputs) const {
    return differences(grafcet_, reference_.shown(inputs), gates_.shown());
}

std::optional<std::string> replayed(const Grafcet& grafcet, const Netlist& netlist,
                                    const Stimuli& stimuli, Time scan_period, bool is_plain,
                                    const std::vector<bool>& power_up) {
    PairRun pair(grafcet, netlist, is_plain);
    InputValues inputs(grafcet.all_input_count(), 0);
    std::size_t next = 0;
    for (Time now = 0; now <= stimuli.end;) {
        for (; next < stimuli.changes.size() && stimuli.changes[next].at <= now; ++next) {
            for (const auto& set : stimuli.changes[next].assignments) {
                inputs[set.input] = set.value ? 1 : 0;
            }
        }
        if (now == 0 && !pair.start(inputs, power_up)) return "does not settle at power-up";
        const Comparison comparison =
            scan_period != 0 ? pair.scan(now, inputs) : pair.instant(now, inputs);
        const std::string at = "at " + format_milliseconds(now) + " ms";
        if (comparison == Comparison::differ) return at + pair.difference(inputs);
        if (comparison == Comparison::unsettled) return at + " it does not settle";
        if (comparison == Comparison::unstable || now == stimuli.end) break;
        Time then = add_times(now, scan_period);
        if (scan_period == 0) {
            then = std::min(pair.next_end(), stimuli.end);
            if (next < stimuli.changes.size()) then = std::min(then, stimuli.changes[next].at);
        }
        now = then;
    }
    return std::nullopt;
}

}  // namespace grafwire::testing
