#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "netlist/delay_model.h"
#include "netlist/netlist.h"
#include "simulate/netlist_machine.h"
#include "story/instant_story.h"
#include "story/stepped_run.h"
#include "text/time.h"
#include "trace/input_values.h"
#include "trace/stimuli.h"
#include "trace/trace.h"
#include "workflow/chart.h"

namespace grafwire {

/// What the gates do at an instant, in the order of time.
struct GateInstant {
    /// A net takes another value, so long after the instant began.
    struct Change {
        Time after = 0;
        NetId net = no_net;
        Logic value = Logic::unknown;
    };
    Time at = 0;
    std::vector<Change> changes;  ///< the first of very many
    bool is_settled = true;
    std::vector<NetId> oscillating;  ///< not settled: what keeps changing
};

/// A chart with wiring for it.
struct WiredChart {
    Netlist netlist;
    DelayModel delays;
};

/// The two sides of one moment: what the reference does there, and what the gates do. A delay that
/// only one side ends is an instant of that side alone.
struct LiveInstant {
    std::optional<InstantStory> story;
    std::optional<GateInstant> gates;
    Time at() const { return story ? story->at : gates->at; }
};

/// A chart that somebody takes through a run step by step, and back; beside it, where there is one,
/// a netlist at the same inputs.
class LiveRun {
  public:
    /// By scans with that period, or until stable (none).
    LiveRun(Chart chart, std::optional<WiredChart> wiring, std::optional<Time> period);
    LiveRun(const LiveRun&) = delete;
    LiveRun& operator=(const LiveRun&) = delete;

    const Chart& chart() const { return chart_; }
    const SteppedRun& reference() const { return reference_; }
    /// nullptr where there is none.
    const Netlist* netlist() const { return wiring_ ? &wiring_->netlist : nullptr; }
    /// Not before the first instant; all unknown where there is no netlist.
    Logic value(NetId net) const;
    /// What the gates did from power-up, where all is unknown, to the initial situation.
    const GateInstant& power_up() const { return power_up_; }
    bool gates_are_settled() const { return is_settled_; }
    const std::vector<NetId>& oscillating() const { return oscillating_; }
    /// The X and outputs whose nets are other than the reference has them, by name.
    std::vector<std::string> differences() const;

    /// A step, as of SteppedRun::advance(); empty `way` instants are left out.
    struct Way {
        std::vector<LiveInstant> instants;
        bool is_done = true;  ///< not too long a way for one step
    };
    Way advance(Time to, const std::vector<Stimuli::Assignment>& assignments, bool has_instant);
    void go_back();

    /// All that was done, as a run from its beginning.
    ToldRun whole() const;

  private:
    /// Where the gates stand.
    struct GateMoment {
        std::optional<SimulatorState> state;  ///< none before the first instant
        bool is_settled = true;
        std::vector<NetId> oscillating;
    };

    void start_gates();
    std::optional<GateInstant> gates_at(Time at);
    void gates_until(Time end, std::vector<LiveInstant>& instants);
    void add(InstantStory story, std::vector<LiveInstant>& instants);

    Chart chart_;
    std::optional<WiredChart> wiring_;
    SteppedRun reference_;
    std::optional<NetlistMachine> machine_;
    GateInstant power_up_;
    bool has_started_ = false;
    InputValues inputs_;  ///< that the gates have
    bool is_settled_ = true;
    std::vector<NetId> oscillating_;
    std::vector<GateMoment> past_;
    GateInstant* recorded_ = nullptr;  ///< where changes of nets are noted
    Time began_ = 0;                   ///< the instant that is recorded, on the clock of the gates
};

}  // namespace grafwire
