// The two ways of running the reference over stimuli: until stable (IEC 60848 with stability
// search) and scan by scan (a PLC without it).

#include "evolution/run.h"

#include <algorithm>
#include <cassert>

#include "trace/input_values.h"

namespace grafwire {

namespace {

/// A run under way: the inputs as they are, the state, and the result so far.
class Runner {
  public:
    Runner(const Grafcet& grafcet, const Stimuli& stimuli)
        : grafcet_(grafcet),
          end_(stimuli.end),
          evolution_(grafcet),
          player_(stimuli, grafcet.all_input_count()),
          is_broken_(grafcet.assumptions.size(), false) {
        result_.trace = empty_trace(grafcet);
        change_inputs(0);
        state_ = evolution_.start({player_.inputs()});
    }

    RunResult until_stable() {
        for (Time now = 0; now <= end_; now = next_instant()) {
            change_inputs(now);
            if (now != 0) evolution_.end_delays(state_, {player_.inputs()}, now);
            SettleResult settled = evolution_.settle(state_, {player_.inputs()}, now);
            if (!settled.stable) {
                result_.unstable_at = now;
                result_.changing = std::move(settled.changing);
                break;
            }
            add_row(now);
            if (now == end_) break;
        }
        return std::move(result_);
    }

    RunResult scan_by_scan(Time period) {
        for (Time now = 0; now <= end_; now += period) {
            change_inputs(now);
            evolution_.scan(state_, {player_.inputs()}, now);
            add_row(now);
            if (period > end_ - now) break;
        }
        return std::move(result_);
    }

  private:
    /// Applies every change up to and including `now`.
    void change_inputs(Time now) {
        const bool any = player_.advance(now);
        if (any || now == 0) check_assumptions(now);
    }

    void check_assumptions(Time now) {
        for (std::size_t i = 0; i < is_broken_.size(); ++i) {
            if (is_broken_[i] || assumption_holds(grafcet_, i, player_.inputs())) continue;
            is_broken_[i] = true;
            result_.broken_assumptions.push_back({now, i});
        }
    }

    /// The first time after the present at which something can happen.
    Time next_instant() const {
        Time next = std::min(end_, player_.next_change());
        for (const Time due : state_.due) next = std::min(next, due);
        return next;
    }

    void add_row(Time now) {
        Trace& trace = result_.trace;
        trace.times.push_back(now);
        const InputValues& inputs = player_.inputs();
        trace.values.insert(trace.values.end(), inputs.begin(), inputs.end());
        add_bits(state_.situation);
        add_bits(evolution_.outputs(state_, {player_.inputs()}));
        for (std::size_t i = 0; i < grafcet_.vars.size(); ++i) {
            const bool value = evolution_.var(grafcet_.vars.id_at(i), state_, {inputs});
            trace.values.push_back(value ? 1 : 0);
        }
        trace.values.insert(trace.values.end(), state_.counters.begin(), state_.counters.end());
        assert(trace.values.size() == trace.times.size() * trace.columns.size());
    }

    void add_bits(const BitTable& table) {
        for (std::size_t i = 0; i < table.size(); ++i) {
            result_.trace.values.push_back(table.test(i) ? 1 : 0);
        }
    }

    const Grafcet& grafcet_;
    Time end_;
    Evolution evolution_;
    StimuliPlayer player_;
    EvolutionState state_;
    std::vector<bool> is_broken_;
    RunResult result_;
};

}  // namespace

RunResult run_until_stable(const Grafcet& grafcet, const Stimuli& stimuli) {
    return Runner(grafcet, stimuli).until_stable();
}

RunResult run_scans(const Grafcet& grafcet, const Stimuli& stimuli, Time period) {
    assert(period > 0);
    return Runner(grafcet, stimuli).scan_by_scan(period);
}

}  // namespace grafwire
