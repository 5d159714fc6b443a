#include "referee/random_walk.h"

#include <algorithm>

#include "referee/pair_run.h"

namespace grafwire::testing {

RandomInputs::RandomInputs(const Grafcet& grafcet, RandomSource& random, bool controls)
    : grafcet_(grafcet),
      random_(random),
      controls_(controls),
      values_(grafcet.all_input_count(), 0) {}

/// Control inputs are at 1 rarely, and not for long.
bool RandomInputs::may_change(const InputValues& values, std::size_t input) const {
    if (input < grafcet_.inputs.size()) return true;
    return controls_ && (values[input] != 0 ? random_.flip() : random_.one_in(12));
}

bool RandomInputs::begin() {
    for (int attempt = 0; attempt < 300; ++attempt) {
        InputValues values(values_.size(), 0);
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = random_.flip() && may_change(values, i) ? 1 : 0;
        }
        if (broken_assumption(grafcet_, values) != grafcet_.assumptions.size()) continue;
        values_ = values;
        return true;
    }
    return false;
}

bool RandomInputs::change(Happens happens) {
    for (int attempt = 0; attempt < 100; ++attempt) {
        InputValues values = values_;
        if (happens == Happens::one_thing || random_.flip()) {
            const std::size_t input = random_.below(values.size());
            if (may_change(values, input)) values[input] ^= 1U;
        } else {
            for (std::size_t i = 0; i < values.size(); ++i) {
                if (random_.one_in(2) && may_change(values, i)) values[i] ^= 1U;
            }
        }
        if (values == values_) continue;
        if (broken_assumption(grafcet_, values) != grafcet_.assumptions.size()) continue;
        values_ = values;
        return true;
    }
    return false;
}

Stimuli::Change change_between(const InputValues& before, const InputValues& after, Time at) {
    Stimuli::Change change;
    change.at = at;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (after[i] == before[i]) continue;
        change.assignments.push_back({static_cast<std::uint32_t>(i), after[i] != 0});
    }
    return change;
}

namespace {

class Walker {
  public:
    Walker(const Grafcet& grafcet, const Netlist& netlist, Happens happens, RandomSource& random)
        : grafcet_(grafcet),
          netlist_(netlist),
          happens_(happens),
          random_(random),
          pair_(grafcet, netlist, random.one_in(4)),
          inputs_(grafcet, random, netlist.has_modes) {}

    Walk make(Time scan_period, std::size_t length) {
        walk_.scan_period = scan_period;
        if (!inputs_.begin()) return walk_;
        const auto power_up = random_power_up(grafcet_, netlist_, inputs_.values(), random_);
        note_change(InputValues(inputs_.values().size(), 0));
        if (!pair_.start(inputs_.values(), power_up)) {
            walk_.contradiction = "does not settle at power-up";
            return walk_;
        }
        for (bool goes_on = true; goes_on && walk_.instants < length; ++walk_.instants) {
            goes_on = scan_period != 0 ? scan() : instant();
        }
        walk_.stimuli.end = now_;
        return walk_;
    }

  private:
    void note_change(const InputValues& before) {
        walk_.stimuli.changes.push_back(change_between(before, inputs_.values(), now_));
    }

    bool change_inputs() {
        const InputValues before = inputs_.values();
        if (!inputs_.change(happens_)) return false;
        note_change(before);
        return true;
    }

    bool scan() {
        if (walk_.instants != 0) {
            now_ += walk_.scan_period;
            if (random_.flip()) change_inputs();
        }
        return judge(pair_.scan(now_, inputs_.values()));
    }

    bool instant() {
        if (walk_.instants != 0 && !go_on()) return false;
        return judge(pair_.instant(now_, inputs_.values()));
    }

    /// To the next instant: the next end of a delay, or a change of inputs somewhere before it.
    bool go_on() {
        const Time end = pair_.next_end();
        if (end != never && random_.flip()) return end_delay(end);
        const Time left = end == never ? 4 * millisecond : end - now_;
        Time step = left / 2;
        switch (random_.below(4)) {
            case 0:
                step = millisecond;
                break;
            case 1:
                step = left - microsecond;
                break;
            case 2:
                step = left * static_cast<Time>(1 + random_.below(7)) / 8;
                break;
            default:
                break;
        }
        step = std::clamp(step / microsecond * microsecond, microsecond, left);
        if (end != never && step >= left) return end_delay(end);
        now_ += step;
        return change_inputs();
    }

    /// A delay ends, and now and then inputs change at that very moment.
    bool end_delay(Time end) {
        now_ = end;
        if (happens_ == Happens::many_things && random_.one_in(3)) change_inputs();
        return true;
    }

    bool judge(Comparison comparison) {
        if (comparison == Comparison::differ) {
            walk_.contradiction =
                "at " + format_milliseconds(now_) + " ms" + pair_.difference(inputs_.values());
        } else if (comparison == Comparison::unsettled) {
            walk_.contradiction = "at " + format_milliseconds(now_) + " ms it does not settle";
        }
        return comparison == Comparison::alike;
    }

    const Grafcet& grafcet_;
    const Netlist& netlist_;
    Happens happens_;
    RandomSource& random_;
    PairRun pair_;
    RandomInputs inputs_;
    Walk walk_;
    Time now_ = 0;
};

}  // namespace

Walk random_walk(const Grafcet& grafcet, const Netlist& netlist, Happens happens, Time scan_period,
                 RandomSource& random, std::size_t length) {
    return Walker(grafcet, netlist, happens, random).make(scan_period, length);
}

Time random_period(const Grafcet& grafcet, RandomSource& random) {
    std::vector<Time> delays;
    for (const ExprId id : grafcet.expressions.time_conditions()) {
        const TimeCondition& condition = grafcet.expressions.time_condition_of(id);
        for (const Time delay : {condition.on_delay, condition.off_delay}) {
            if (delay != 0) delays.push_back(delay);
        }
    }
    if (delays.empty()) return millisecond;
    const Time delay = random.pick(delays);
    const Time part = delay / static_cast<Time>(random.between(1, 5));
    return std::max(part / microsecond * microsecond, microsecond);
}

std::vector<bool> random_power_up(const Grafcet& grafcet, const Netlist& netlist,
                                  const InputValues& inputs, RandomSource& random) {
    std::vector<bool> values(netlist.net_count());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = random.flip();
    if (random.flip()) return values;
    GateSimulator gates(grafcet, netlist);
    gates.start(inputs, values);
    values = gates.values();
    const std::size_t one_in = random.between(2, 16);
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (random.one_in(one_in)) values[i] = !values[i];
    }
    return values;
}

}  // namespace grafwire::testing
