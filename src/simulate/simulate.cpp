#include "simulate/simulate.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "simulate/delay_ends.h"
#include "simulate/waveform.h"

// A netlist under stimuli
//
// The instants are those of the reference, so that the rows of the two traces can be laid side by
// side. Within an asynchronous netlist the gates race on by themselves until nothing moves. A
// clocked netlist makes one scan of the method per clock cycle: either one cycle per period, or at
// every instant as many as it takes until a cycle changes nothing. (The memory of an edge is a
// flip-flop too, so a cycle in which an edge is 1 changes something.) Cycles that come back to a
// state they have been in are found as oscillations of gates are, by Brent's scheme.

namespace grafwire {

namespace {

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
    void add_named(const ByName& names, const std::string& name) {
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
          ports_(map_ports(grafcet, netlist)),
          rows_(grafcet, netlist, ports_),
          simulator_(netlist, delays),
          delay_ends_(netlist),
          inputs_(grafcet.all_input_count(), 0) {
        result_.trace = empty_trace(grafcet);
        if (options.waveform) waveform_.emplace(netlist, delays, is_in_nanoseconds(stimuli));
        take_changes(0);
        const std::vector<Logic> start = logic_inputs();
        started_ = note(0, initialise(simulator_, grafcet, netlist, ports_, start));
        if (waveform_) waveform_->follow(simulator_);
        if (options.observer) simulator_.observe(options.observer);
    }

    SimulateResult make(Time scan_period) {
        const bool scans = netlist_.is_clocked() && scan_period > 0;
        Time at = 0;
        bool goes_on = started_;
        while (goes_on) {
            if (!(scans ? scan(at) : instant(at))) break;
            rows_.append_row(simulator_, at, inputs_, result_.trace);
            const Time next = scans ? add_times(at, scan_period) : next_instant(at);
            goes_on = next <= stimuli_.end && next != never;
            if (goes_on) at = next;
        }
        if (waveform_) result_.waveform = waveform_->stop(simulator_, at);
        return std::move(result_);
    }

  private:
    static bool is_in_nanoseconds(const Stimuli& stimuli) {
        return stimuli.end % nanosecond == 0 &&
               std::all_of(stimuli.changes.begin(), stimuli.changes.end(),
                           [](const Stimuli::Change& c) { return c.at % nanosecond == 0; });
    }

    /// The changes of the stimuli up to and including a moment go into the inputs.
    void take_changes(Time at) {
        for (; next_change_ < stimuli_.changes.size(); ++next_change_) {
            const Stimuli::Change& change = stimuli_.changes[next_change_];
            if (change.at > at) return;
            for (const Stimuli::Assignment& set : change.assignments)
                inputs_[set.input] = set.value;
        }
    }
    std::vector<Logic> logic_inputs() const {
        std::vector<Logic> values;
        for (const std::uint8_t input : inputs_) {
            values.push_back(logic_of(input != 0));
        }
        return values;
    }
    void set_inputs() {
        for (std::size_t i = 0; i < inputs_.size(); ++i) {
            if (ports_.inputs[i] == no_net) continue;
            simulator_.set_input(ports_.inputs[i], logic_of(inputs_[i] != 0));
        }
    }

    /// Counts the events of a part of an instant; false if it did not settle.
    bool note(Time at, const Settling& settling) {
        result_.events += settling.events;
        if (settling.settled) return true;
        result_.unsettled_at = at;
        result_.oscillating = settling.oscillating;
        return false;
    }

    bool instant(Time at) {
        take_changes(at);
        simulator_.begin_instant(at);
        set_inputs();
        if (at > 0) delay_ends_.take_effect(simulator_, at);
        return note(
            at, netlist_.is_clocked() ? cycle_until_stable() : delay_ends_.settle(simulator_, at));
    }

    bool scan(Time at) {
        take_changes(at);
        simulator_.begin_instant(at);
        set_inputs();
        return note(at, simulator_.clock_cycle());
    }

    /// The instant after this one; `never` after the last.
    Time next_instant(Time at) const {
        if (at >= stimuli_.end) return never;
        Time next = std::min(simulator_.next_due(), stimuli_.end);
        if (next_change_ < stimuli_.changes.size()) {
            next = std::min(next, stimuli_.changes[next_change_].at);
        }
        return next;
    }

    Settling cycle_until_stable();
    std::vector<NetId> changing_in(std::uint64_t cycles);

    const Netlist& netlist_;
    const Stimuli& stimuli_;
    PortMap ports_;
    RowReader rows_;
    std::optional<Waveform> waveform_;
    Simulator simulator_;
    DelayEnds delay_ends_;
    InputValues inputs_;
    std::size_t next_change_ = 0;
    bool started_ = false;
    SimulateResult result_;
};

bool goes_on_alike(const SimulatorState& a, const SimulatorState& b) {
    return a.values == b.values && a.due == b.due && a.towards == b.towards;
}

Settling Run::cycle_until_stable() {
    Settling sum = simulator_.settle();
    SimulatorState before = simulator_.save();
    SimulatorState kept = before;
    std::uint64_t cycles = 0;
    std::uint64_t stretch = 1;
    while (sum.settled) {
        const Settling cycle = simulator_.clock_cycle();
        sum.events += cycle.events;
        sum.settled = cycle.settled;
        sum.oscillating = cycle.oscillating;
        if (!cycle.settled) break;
        SimulatorState after = simulator_.save();
        if (goes_on_alike(before, after)) break;
        ++cycles;
        if (goes_on_alike(kept, after)) {
            sum.settled = false;
            sum.oscillating = changing_in(cycles);
            break;
        }
        if (cycles == stretch) {
            kept = after;
            cycles = 0;
            stretch *= 2;
        }
        before = std::move(after);
    }
    return sum;
}

/// The nets whose values between the clock cycles differ during so many cycles.
std::vector<NetId> Run::changing_in(std::uint64_t cycles) {
    const SimulatorState first = simulator_.save();
    std::vector<bool> changes(first.values.size(), false);
    for (; cycles > 1; --cycles) {
        simulator_.clock_cycle();
        const SimulatorState state = simulator_.save();
        for (std::size_t net = 0; net < changes.size(); ++net) {
            if (state.values[net] != first.values[net]) changes[net] = true;
        }
    }
    std::vector<NetId> nets;
    for (std::size_t net = 0; net < changes.size(); ++net) {
        if (changes[net]) nets.push_back(static_cast<NetId>(net));
    }
    return nets;
}

}  // namespace

SimulateResult simulate(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                        const Stimuli& stimuli, const SimulateOptions& options) {
    return Run(grafcet, netlist, delays, stimuli, options).make(options.scan_period);
}

}  // namespace grafwire
