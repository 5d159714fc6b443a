#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "netlist/netlist.h"
#include "simulate/evaluate_cell.h"
#include "simulate/event_wheel.h"
#include "simulate/oscillation.h"
#include "simulate/simulator.h"

namespace grafwire {

/// The simulation proper; run_kernel.cpp tells how it works. As every net has one driver, a net and
/// the cell that drives it are one node, numbered as the net. Time is counted in ticks, which
/// never go back; the origin says which time tick 0 stands for.
class Simulator::Kernel {
  public:
    Kernel(const Netlist& netlist, const CellDelays& delays, const DelaySchedule& schedule);

    void power_up();
    void begin_instant(Time at);
    /// Where nothing is left to happen.
    void restart_clock();
    void set_input(std::uint32_t net, Logic value);
    void hold_pulses() { pulses_held_ = true; }
    void release_pulses();
    void remember_pulse_inputs() { pulses_remember_ = true; }
    void force(std::uint32_t net, Logic value);
    void release_all();
    Settling settle();
    Settling set_clock(Logic level);
    Settling clock_cycle();

    const std::vector<CellId>& timer_cells() const { return timer_cells_; }
    bool is_running(std::size_t timer) const { return due_[timer] != never; }
    Time next_due() const;
    Time due(std::size_t timer) const { return due_[timer]; }
    bool end_delay(std::size_t timer, Logic operand);

    Logic value(std::uint32_t net) const { return values_[net]; }
    Time now() const { return origin_ + tick_ * tick_length_; }
    SimulatorState save() const { return {values_, due_, now(), towards_}; }
    void restore(const SimulatorState& state);
    void ask(KeepGoing keep_going) { keep_going_ = std::move(keep_going); }
    void observe(Observer observer) { observer_ = std::move(observer); }

  private:
    /// As the target of an evaluation: leave things as they are.
    static constexpr std::uint8_t no_change = 3;
    static constexpr std::uint32_t no_memory = 0xffffffffU;
    /// How many entries ahead apply_current() asks for what an entry will need.
    static constexpr std::size_t read_ahead = 12;
    /// What a list of changes has room for besides one entry per net: those that are read ahead,
    /// and the one that evaluate_touched() writes before it knows whether it counts.
    static constexpr std::size_t spare_entries = 64;
    static_assert(spare_entries >= read_ahead && spare_entries >= 1);

    /// Who reads a net, one entry per pin: twice the node number, plus the controlling value of the
    /// reader. More than three stand in more_readers_, from readers[0] to before readers[1].
    struct Readers {
        std::array<std::uint32_t, 3> readers{};
        std::uint32_t count = 0;
    };
    /// Delays of a node in ticks, and its pending changes. Only where delays differ.
    struct NodeTiming {
        Tick rise = 1;
        Tick fall = 1;
        Tick low_due = no_tick;   ///< when the lower bound of its value turns over
        Tick high_due = no_tick;  ///< likewise the upper bound
    };
    /// A cell that is evaluated from its pins.
    struct MemoryCell {
        std::uint32_t node = 0;
        std::uint32_t data = 0;            ///< first pin
        std::uint32_t control = 0;         ///< last pin: the clock, where there is one
        std::uint32_t held = 0;            ///< scan_timer_next: the output of the timer
        std::uint32_t detail = 0;          ///< index into pulses_ or the timers
        Logic data_seen = Logic::unknown;  ///< values of the pins when last evaluated
        Logic control_seen = Logic::unknown;
        Logic held_seen = Logic::unknown;
    };
    /// From one tick to before another.
    struct Span {
        Tick from = 0;
        Tick to = 0;
    };
    /// Spans in order, apart from each other.
    using Spans = std::vector<Span>;
    /// The output is 1 during the certain spans, else unknown during the possible ones, else 0.
    struct Pulse {
        std::uint32_t memory = 0;
        Tick delay = 1;
        Tick width = 1;
        Tick due = no_tick;  ///< when the output changes next
        Spans certain;
        Spans possible;
        /// The beginning of a possible span that lasts as long as the input is unknown.
        Tick open_from = no_tick;
    };

    /// The delays of a node from a moment on.
    struct NodeDelays {
        Time at = 0;
        std::uint32_t node = 0;
        Tick rise = 1;
        Tick fall = 1;
        Tick width = 0;  ///< 0: as it is
    };

    // kernel.cpp
    void choose_tick(const Netlist& netlist, const CellDelays& delays,
                     const DelaySchedule& schedule);
    void add_schedule(const Netlist& netlist, const CellDelays& delays,
                      const DelaySchedule& schedule);
    void add_cell(const Netlist& netlist, const CellDelays& delays, CellId id);
    void add_memory(const Netlist& netlist, const CellDelays& delays, CellId id);
    void link_readers(const Netlist& netlist);

    void look_at_pins();
    void begin_schedule(Time until);
    void take_delays(Time until);
    void release(std::uint32_t net);

    // run_kernel.cpp
    template <bool uniform, bool observed>
    Settling run();
    template <bool uniform, bool observed>
    void watch(Settling& settling);
    template <bool uniform, bool observed, bool watched>
    void next_tick(RecurrenceWatch* watch);
    template <bool observed, bool watched>
    void apply_current(RecurrenceWatch* watch);
    template <bool observed, bool watched>
    void apply_wheel(RecurrenceWatch* watch);
    template <bool observed, bool watched>
    void apply_far(RecurrenceWatch* watch);
    template <bool observed, bool watched>
    void change(std::uint32_t net, Logic value, RecurrenceWatch* watch);
    template <bool uniform>
    void evaluate_touched();
    void take_delays_of_now();
    void aim(std::uint32_t net, Logic target);
    Logic aimed_value(std::uint32_t net) const;
    template <bool observed, bool watched>
    bool apply_due(std::uint32_t net, RecurrenceWatch* watch);
    Logic take_due(std::uint32_t net);
    void touch(std::uint32_t net);
    void change_unseen(std::uint32_t net, Logic value);
    void change_now(std::uint32_t net, Logic value);
    void drop_change(std::uint32_t net);
    void drop_pending(std::uint32_t net);
    void drop_all_pending();
    void take_snapshot(Snapshot& snapshot);
    bool is_broken_off(std::uint64_t ticks, Settling& settling) const;
    bool is_live() const { return next_.size != 0 || live_ != 0; }

    // memory_cells.cpp
    std::uint8_t evaluate_special(std::uint32_t net);
    std::uint8_t evaluate_flip_flop(MemoryCell& cell);
    std::uint8_t evaluate_timer(std::size_t timer, Logic operand, Logic aimed);
    std::uint8_t count_scan(std::size_t timer, Logic operand, Logic shown);
    std::uint8_t evaluate_scan_timer(MemoryCell& cell);
    std::uint8_t evaluate_scan_timer_next(MemoryCell& cell);
    bool is_lost(std::size_t timer) const;
    void lose_delay(std::size_t timer);
    bool follows_at_once(std::size_t timer, Logic operand, Logic shown) const;
    void count_ahead(std::size_t timer, Logic operand, Logic shown);
    Logic looked_ahead(std::size_t timer, Logic operand, Logic shown) const;

    // memory_cells.cpp: pulse cells
    void evaluate_pulse(MemoryCell& cell);
    void look_at_pulse_input(Pulse& pulse);
    void rest_pulses();
    void aim_pulse(Pulse& pulse);
    static Logic pulse_value(const Pulse& pulse, Tick tick);
    static void append_coming(const Pulse& pulse, std::uint32_t net, Tick now,
                              std::vector<ComingChange>& coming);

    bool is_pulse(std::uint32_t net) const { return grafwire::is_pulse(types_[net]); }
    Pulse& pulse_of(std::uint32_t net) { return pulses_[memories_[memory_of_[net]].detail]; }

    template <typename Visit>
    void for_each_reader(std::uint32_t net, Visit visit) const {
        const Readers& readers = readers_[net];
        if (readers.count <= readers.readers.size()) [[likely]] {
            for (std::uint32_t i = 0; i < readers.count; ++i) visit(readers.readers[i]);
        } else {
            const std::uint32_t* const more = more_readers_.data();
            for (std::uint32_t i = readers.readers[0]; i < readers.readers[1]; ++i) visit(more[i]);
        }
    }

    /// A list that is filled without asking for room: it has room for every node once.
    struct NodeList {
        std::vector<std::uint32_t> items;
        std::size_t size = 0;
    };

    // Per node. What a change of a net touches comes first: its readers and their words.
    std::vector<CellWord> words_;
    std::vector<Readers> readers_;
    std::vector<Logic> values_;  ///< those in the words once more, for save() and restore()
    std::vector<CellType> types_;
    std::vector<std::uint32_t>
        memory_of_;  ///< index into memories_, for cells with pins of meaning

    std::vector<std::uint32_t> more_readers_;
    std::vector<MemoryCell> memories_;
    std::vector<Pulse> pulses_;
    NodeList touched_;
    std::vector<std::uint32_t> forced_;
    std::vector<std::pair<std::uint32_t, Logic>> held_at_power_up_;
    std::uint32_t clock_ = no_memory;

    Time tick_length_ = nanosecond;
    Time origin_ = 0;
    Tick tick_ = 0;
    Time instant_ = 0;

    /// All delays are one tick, now and ever: all changes but those of pulse cells happen at the
    /// next tick, and the two lists hold them as four times the net plus the value. Else the wheel
    /// is used.
    bool uniform_ = true;
    NodeList current_;
    NodeList next_;
    std::vector<NodeTiming> timings_;
    EventWheel wheel_{0};
    std::uint64_t live_ = 0;  ///< pending changes of bounds and pulses that still stand
    /// The schedule, which begins with the delays that its nodes have before it says anything. Its
    /// first change yet to come is next_delays_, at that time.
    std::vector<NodeDelays> schedule_;
    std::size_t next_delays_ = 0;
    Time next_delays_at_ = never;
    std::uint64_t changes_ = 0;
    std::uint64_t changes_told_ = 0;  ///< of these, in earlier results of settle()

    std::vector<CellId> timer_cells_;
    std::vector<std::uint32_t> timer_nodes_;
    std::vector<Time> rise_delays_;
    std::vector<Time> fall_delays_;
    std::vector<Time> due_;
    std::vector<Logic> towards_;  ///< per timer: what its output takes when the delay ends
    std::vector<std::uint32_t> look_ahead_nodes_;  ///< those that depend on the present time

    bool pulses_held_ = false;
    bool pulses_remember_ = false;
    KeepGoing keep_going_;
    Observer observer_;
};

}  // namespace grafwire
