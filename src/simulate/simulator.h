#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "netlist/delay_model.h"
#include "netlist/delay_schedule.h"
#include "netlist/netlist.h"
#include "text/keep_going.h"
#include "text/time.h"

namespace grafwire {

/// What came of letting a netlist settle.
struct Settling {
    bool settled = true;
    bool broken_off = false;   ///< then it is not settled either; restore() before going on
    std::uint64_t events = 0;  ///< changes of nets that took place
    /// Not settled: the nets that keep changing, in the order of their ids.
    std::vector<NetId> oscillating;
};

/// The memory of a simulation between two changes of the inputs.
struct SimulatorState {
    std::vector<Logic> values;  ///< per net
    /// Per timer cell (in the order of cells): when its delay ends, `never` where none runs.
    std::vector<Time> due;
    Time now = 0;
    /// Per timer cell: the value its output takes when the running delay ends.
    std::vector<Logic> towards;

    /// Whether the simulation goes on alike from both within one instant; `now`, which moves on
    /// with the gates, does not count.
    bool operator==(const SimulatorState& other) const {
        return values == other.values && due == other.due && towards == other.towards;
    }
};

/// Event-driven simulation of a netlist with inertial delays and three values. All state lives in
/// the object; copies of it are taken and put back with save() and restore(). The netlist must
/// outlive it.
///
/// Unknown. An unknown input stands for any waveform, as long as it is unknown: it may change at
/// any time and many times, between two calls of settle() as well. Whatever it does, every net
/// shows at all times a value that the simulation with the unknown input allows.
///
/// Time. Gates work in picoseconds from `now`. The delays of timers count from the instant at which
/// their operand changed (begin_instant), not from the few nanoseconds later at which the gates had
/// worked it out, so that instants are those of the reference.
///
/// Delays that change in time. All changes of the schedule up to a moment are in force when cells
/// are evaluated at that moment. Of those after 0, none is before the last Preparation has gone. A
/// delay that changes while an input is unknown counts from the next change of an input on: only
/// then may the output be known too early.
class Simulator {
  public:
    /// `delays` hold until the schedule says otherwise.
    Simulator(const Netlist& netlist, const CellDelays& delays, const DelaySchedule& schedule = {});
    ~Simulator();
    Simulator(Simulator&&) noexcept;
    Simulator& operator=(Simulator&&) noexcept;

    /// Time 0: cells with a memory and nets with initial values hold those, all other nets
    /// (inputs included) are unknown, and every cell is due for evaluation.
    void power_up();

    /// A new instant at `at` (not before the last one). The clock of the simulation moves there
    /// unless gates have already taken it further.
    void begin_instant(Time at);

    /// The input takes the value now; what reads it is evaluated by settle().
    void set_input(NetId input, Logic value);

    /// Runs until nothing is left to happen but delays of timers. An oscillation is found exactly
    /// (a state of values and pending events that comes back) and ends there.
    Settling settle();

    /// Half a cycle of the clock of a clocked netlist: settled, then the rise or the fall, and
    /// settled again.
    Settling set_clock(Logic level);
    /// One cycle: the rise, then the fall.
    Settling clock_cycle();

    /// The cells that are timers (is_timer), in order; their numbers are used below.
    const std::vector<CellId>& timers() const;
    bool is_running(std::size_t timer) const;
    /// The earliest time at which a running delay ends; `never` if none runs.
    Time next_due() const;
    /// The time at which a running delay ends; `never` where none runs.
    Time due(std::size_t timer) const;
    /// Lets one running delay end at once, whatever its length, under this value of its operand,
    /// which the timer takes (gates see it with settle()); it becomes unknown where the delay may
    /// have run for another. False where it has run for the other one, and where none runs: then
    /// nothing ends. settle() itself never ends a delay of a timer (delay_ends.h does);
    /// clock_cycle() ends those of scan timers that have fallen due by the current instant.
    bool end_delay(std::size_t timer, Logic operand);

    Logic value(NetId net) const;
    Time now() const;

    /// To be called once all has settled.
    SimulatorState save() const;
    void restore(const SimulatorState& state);

    /// From now on asked while the netlist settles, which is broken off where it says no.
    void ask(KeepGoing keep_going);

    /// Called at every change of a net; for waveforms. Costs time: none by default.
    using Observer = std::function<void(Time, NetId, Logic)>;
    void observe(Observer observer);

  private:
    friend class Preparation;
    class Kernel;
    std::unique_ptr<Kernel> kernel_;
};

/// The time before an instant, in which a netlist is brought to rest. While the object lives, pulse
/// cells do not fire: the inputs are taken to have been what they are since always, even where they
/// are unknown. When it goes, no net is held any more, and the clock of the simulation stands at 0
/// if the netlist has settled. One at a time per simulator, which must outlive it.
class Preparation {
  public:
    explicit Preparation(Simulator& simulator);
    ~Preparation();
    Preparation(const Preparation&) = delete;
    Preparation& operator=(const Preparation&) = delete;

    /// Gives a net a value until it is released.
    void hold(NetId net, Logic value);
    /// Lets go of all nets held; their drivers are evaluated by Simulator::settle(). Cells with a
    /// memory and inputs keep the value.
    void release();
    /// Powers the netlist up; what pulse cells see now is what they compare with once they fire,
    /// whatever they see until then.
    void power_up_again();

  private:
    Simulator::Kernel& kernel_;
};

}  // namespace grafwire
