// A netlist under stimuli: its rows, and a waveform of all its nets.
//
// The instants are those of the reference, so that the rows of the two traces can be laid side by
// side. Within an asynchronous netlist the gates race on by themselves until nothing moves. A
// clocked netlist makes one scan of the method per clock cycle: either one cycle per period, or at
// every instant as many as it takes until a cycle changes nothing. (The memory of an edge is a
// flip-flop too, so a cycle in which an edge is 1 changes something.)

#include "simulate/simulate.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "trace/input_values.h"
#include "trace/trace.h"

namespace grafwire {

namespace {

bool is_whole(Time time) {
    return time % nanosecond == 0;
}

bool all_whole(const Netlist& netlist, const CellDelays& delays) {
    const bool cells = std::all_of(delays.rise.begin(), delays.rise.end(), is_whole) &&
                       std::all_of(delays.fall.begin(), delays.fall.end(), is_whole);
    return cells &&
           std::all_of(netlist.timings.begin(), netlist.timings.end(),
                       [](const Timing& t) { return is_whole(t.rise) && is_whole(t.fall); });
}

bool all_whole(const DelaySchedule& schedule) {
    return std::all_of(schedule.changes.begin(), schedule.changes.end(), [](const DelayChange& c) {
        return is_whole(c.rise) && is_whole(c.fall) && is_whole(c.width);
    });
}

/// Records every net of a netlist while it is simulated.
class Recorder {
  public:
    /// `delays` and the times of the stimuli decide the timescale: nanoseconds where they fit.
    Recorder(const Netlist& netlist, const CellDelays& delays, bool whole_nanoseconds);

    /// Writes down the present values as those of time 0 and follows the simulator from there,
    /// with another observer behind it, if there is one.
    /// The recorder must stay where it is until the simulator has gone or stop() was called.
    void follow(Simulator& simulator, const Simulator::Observer& other);
    /// `trace`: its columns of one bit are the signals worth showing.
    Waveform stop(Simulator& simulator, Time end, const Trace& trace);

  private:
    VcdWriter writer_;
    std::size_t net_count_;
    std::unordered_map<std::string_view, std::uint32_t> signals_;  ///< by name
};

Recorder::Recorder(const Netlist& netlist, const CellDelays& delays, bool whole_nanoseconds)
    : writer_(netlist.name, whole_nanoseconds && all_whole(netlist, delays) ? nanosecond : 1),
      net_count_(netlist.net_count()) {
    for (std::size_t net = 0; net < net_count_; ++net) {
        const std::string_view name = netlist.names[static_cast<NetId>(net)];
        signals_.emplace(name, writer_.add_signal(name));
    }
    writer_.begin();
}

void Recorder::follow(Simulator& simulator, const Simulator::Observer& other) {
    for (std::size_t net = 0; net < net_count_; ++net) {
        writer_.change(0, static_cast<std::uint32_t>(net),
                       digit_of(simulator.value(static_cast<NetId>(net))));
    }
    simulator.observe([this, other](Time at, NetId net, Logic value) {
        writer_.change(at, static_cast<std::uint32_t>(net), digit_of(value));
        if (other) other(at, net, value);
    });
}

Waveform Recorder::stop(Simulator& simulator, Time end, const Trace& trace) {
    simulator.observe({});
    Waveform waveform;
    for (const Trace::Column& column : trace.columns) {
        const auto signal = signals_.find(column.name);
        if (column.width == 1 && signal != signals_.end()) {
            waveform.add(column, writer_, signal->second);
        }
    }
    waveform.vcd = writer_.finish(std::max(end, simulator.now()));
    return waveform;
}

/// Where the columns of the trace after the inputs come from.
class RowReader {
  public:
    RowReader(const Grafcet& grafcet, const Netlist& netlist, const PortMap& ports) {
        for (const NetId net : ports.steps) add_net(net);
        for (const NetId net : ports.outputs) add_net(net);
        const auto vars = by_name(netlist.vars);
        for (const Var& var : grafcet.vars) add_named(vars, var.name);
        const auto counters = by_name(netlist.counters);
        for (const Counter& counter : grafcet.counters) add_named(counters, counter.name);
    }

    void append_row(const Simulator& simulator, Time at, const InputValues& inputs,
                    Trace& trace) const {
        trace.times.push_back(at);
        for (const std::uint8_t input : inputs) trace.values.push_back(input);
        for (const Observed& source : sources_) trace.values.push_back(read(simulator, source));
    }

  private:
    using ByName = std::unordered_map<std::string_view, const Observed*>;

    static ByName by_name(const std::vector<Observed>& observed) {
        ByName names;
        for (const Observed& item : observed) names.emplace(item.name, &item);
        return names;
    }
    void add_net(NetId net) { sources_.push_back({{}, {net}, 0}); }
    void add_named(const ByName& names, std::string_view name) {
        const auto found = names.find(name);
        if (found == names.end()) {
            add_net(no_net);
        } else {
            sources_.push_back(*found->second);
        }
    }
    static std::int64_t read(const Simulator& simulator, const Observed& source) {
        std::uint64_t number = 0;
        for (std::size_t bit = 0; bit < source.bits.size(); ++bit) {
            if (source.bits[bit] == no_net) return Trace::unknown;
            const Logic value = simulator.value(source.bits[bit]);
            if (value == Logic::unknown) return Trace::unknown;
            number |= std::uint64_t{value == Logic::one} << bit;
        }
        return source.offset + static_cast<std::int64_t>(number);
    }

    std::vector<Observed> sources_;
};

class Run {
  public:
    Run(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
        const Stimuli& stimuli, const SimulateOptions& options)
        : netlist_(netlist),
          stimuli_(stimuli),
          options_(options),
          machine_(grafcet, netlist, delays, options.schedule),
          rows_(grafcet, netlist, machine_.ports()),
          player_(stimuli, grafcet.all_input_count()) {
        result_.trace = empty_trace(grafcet);
        if (options.waveform) {
            const bool whole = is_in_nanoseconds(stimuli) && all_whole(options.schedule);
            recorder_.emplace(netlist, delays, whole);
        }
        player_.advance(0);
        started_ = note(0, machine_.start(known_inputs(player_.inputs())));
        if (recorder_) {
            recorder_->follow(simulator(), options.observer);
        } else if (options.observer) {
            simulator().observe(options.observer);
        }
    }

    SimulateResult make() {
        const Time scan_period = options_.scan_period;
        const bool scans = netlist_.is_clocked() && scan_period > 0;
        Time at = 0;
        bool goes_on = started_;
        while (goes_on) {
            if (!(scans ? scan(at) : instant(at))) break;
            rows_.append_row(simulator(), at, player_.inputs(), result_.trace);
            const Time next = scans ? add_times(at, scan_period) : next_instant(at);
            goes_on = next <= stimuli_.end && next != never;
            if (goes_on) at = next;
        }
        if (recorder_) result_.waveform = recorder_->stop(simulator(), at, result_.trace);
        return std::move(result_);
    }

  private:
    static bool is_in_nanoseconds(const Stimuli& stimuli) {
        return stimuli.end % nanosecond == 0 &&
               std::all_of(stimuli.changes.begin(), stimuli.changes.end(),
                           [](const Stimuli::Change& c) { return c.at % nanosecond == 0; });
    }

    Simulator& simulator() { return machine_.simulator(); }

    /// Counts the events of a part of an instant; false if it did not settle.
    bool note(Time at, const Settling& settling) {
        result_.events += settling.events;
        if (settling.settled) return true;
        result_.unsettled_at = at;
        result_.oscillating = settling.oscillating;
        return false;
    }

    void begin_instant(Time at) {
        if (options_.instant) options_.instant(at, simulator());
        player_.advance(at);
    }

    bool instant(Time at) {
        begin_instant(at);
        return note(at, machine_.instant(at, known_inputs(player_.inputs())));
    }

    bool scan(Time at) {
        begin_instant(at);
        return note(at, machine_.scan(at, known_inputs(player_.inputs())));
    }

    /// The instant after this one; `never` after the last.
    Time next_instant(Time at) const {
        if (at >= stimuli_.end) return never;
        return std::min({machine_.simulator().next_due(), stimuli_.end, player_.next_change()});
    }

    const Netlist& netlist_;
    const Stimuli& stimuli_;
    const SimulateOptions& options_;
    NetlistMachine machine_;
    RowReader rows_;
    std::optional<Recorder> recorder_;
    StimuliPlayer player_;
    bool started_ = false;
    SimulateResult result_;
};

}  // namespace

SimulateResult simulate(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                        const Stimuli& stimuli, const SimulateOptions& options) {
    return Run(grafcet, netlist, delays, stimuli, options).make();
}

}  // namespace grafwire
