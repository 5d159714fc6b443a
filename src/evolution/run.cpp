// The two ways of running the reference over stimuli: until stable (IEC 60848 with stability
// search) and scan by scan (a PLC without it).

#include "evolution/run.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "evolution/evolution.h"
#include "evolution/run_record.h"
#include "trace/input_values.h"

namespace grafwire {

namespace {

/// A run under way: the inputs as they are, the state, and what has become of it so far.
class Runner {
  public:
    Runner(const Grafcet& grafcet, const Stimuli& stimuli)
        : end_(stimuli.end),
          evolution_(grafcet),
          player_(stimuli, grafcet.all_input_count()),
          record_(grafcet) {
        change_inputs(0);
        state_ = evolution_.start({player_.inputs()});
    }

    RunResult until_stable() {
        for (Time now = 0; now <= end_; now = next_instant()) {
            change_inputs(now);
            if (now != 0) evolution_.end_delays(state_, {player_.inputs()}, now);
            SettleResult settled = evolution_.settle(state_, {player_.inputs()}, now);
            if (!settled.stable) {
                record_.end_unstable(now, std::move(settled.changing));
                break;
            }
            add_row(now);
            if (now == end_) break;
        }
        return record_.take();
    }

    RunResult scan_by_scan(Time period) {
        for (Time now = 0; now <= end_; now += period) {
            change_inputs(now);
            evolution_.scan(state_, {player_.inputs()}, now);
            add_row(now);
            if (period > end_ - now) break;
        }
        return record_.take();
    }

  private:
    /// Applies every change up to and including `now`.
    void change_inputs(Time now) {
        const bool any = player_.advance(now);
        if (any || now == 0) record_.check_assumptions(now, player_.inputs());
    }

    /// The first time after the present at which something can happen.
    Time next_instant() const {
        Time next = std::min(end_, player_.next_change());
        for (const Time due : state_.due) next = std::min(next, due);
        return next;
    }

    void add_row(Time now) { record_.add_row(now, evolution_, state_, player_.inputs()); }

    Time end_;
    Evolution evolution_;
    StimuliPlayer player_;
    EvolutionState state_;
    RunRecord record_;
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
