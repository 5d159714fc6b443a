// Inputs are made of delays: a buffer per moment of the stimuli, and an input is the exclusive or
// of the moments at which it changes. A voltage source behind a bridge would change up to some
// microseconds late, since the analogue solver chooses its own steps, and a digital source would
// need a second file.

#include "formats/spice/spice_stimuli.h"

#include <algorithm>

namespace grafwire {

namespace {

/// A digital source that changes from time to time.
struct Wave {
    bool value = false;              ///< during the start
    std::vector<std::size_t> ticks;  ///< the numbers of the moments at which it changes
};

/// The inputs of a netlist and the node that samples over the bench, and the moments at which they
/// change.
class Waves {
  public:
    Waves(const Netlist& netlist, const Bench& bench) : netlist_(netlist), bench_(bench) {
        for (const bool value : starting_inputs(netlist, bench)) inputs_.push_back({value, {}});
        while (clock_ < inputs_.size() && netlist.inputs[clock_].net != netlist.clock) ++clock_;
        for (const BenchEvent& event : bench_events(netlist, bench)) add(event);
    }

    const std::vector<Wave>& inputs() const { return inputs_; }
    const Wave& sample() const { return sample_; }
    const std::vector<Time>& ticks() const { return ticks_; }
    Time end() const { return end_; }

  private:
    void add(const BenchEvent& event);
    std::size_t tick(Time moment);

    const Netlist& netlist_;
    const Bench& bench_;
    std::vector<Wave> inputs_;
    Wave sample_;
    std::vector<Time> ticks_;  ///< the moments, counted from the end of the start
    std::size_t clock_ = 0;    ///< which input is the clock
    Time end_ = bench_.settling;
};

/// The number of a moment; moments come in order.
std::size_t Waves::tick(Time moment) {
    if (ticks_.empty() || ticks_.back() != moment) ticks_.push_back(moment);
    return ticks_.size() - 1;
}

void Waves::add(const BenchEvent& event) {
    for (const Bench::Assignment& item : event.assignments) {
        inputs_[item.input].ticks.push_back(tick(event.at));
    }
    if (event.row == BenchEvent::no_row) return;
    const Time delay = sampling_delay(bench_, event.row);
    if (netlist_.is_clocked()) {
        const Time half_period = delay / (2 * Time{bench_.clock_cycles} + 2);
        for (std::uint32_t i = 1; i <= 2 * bench_.clock_cycles; ++i) {
            inputs_[clock_].ticks.push_back(tick(event.at + half_period * i));
        }
    }
    const bool is_last = event.row + 1 == bench_.instants.size();
    const Time rest = is_last ? bench_.settling : bench_.instants[event.row + 1] - event.at - delay;
    sample_.ticks.push_back(tick(event.at + delay));
    sample_.ticks.push_back(tick(event.at + delay + rest / 2));
    end_ = event.at + delay + rest;
}

/// All waves go through the same number of levels, so that none changes later than the others.
void add_wave(SpiceElements& elements, std::string_view node, const Wave& wave,
              std::size_t levels) {
    if (wave.ticks.empty()) return elements.add(node, wave.value ? " one" : " zero");
    std::vector<std::string_view> nodes;
    for (const std::size_t number : wave.ticks) {
        std::string name = "__tick";
        append(name, number);
        nodes.push_back(elements.keep(std::move(name)));
    }
    for (std::size_t level = 0; level < levels; ++level) nodes = elements.gather(nodes, "xor");
    if (nodes.size() == 1) {
        return elements.add(nodes[0], ' ', node, wave.value ? " fast_not" : " fast_buffer");
    }
    elements.add(spice_list(nodes), ' ', node, wave.value ? " fast_xnor" : " fast_xor");
}

void append_ticks(std::string& out, SpiceElements& elements, const std::vector<Time>& ticks) {
    out += "\n* The moments of the stimuli\n";
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        append(out, ".model tick", i, " d_buffer(rise_delay=", std::max<Time>(1, ticks[i]),
               " fall_delay=1)\n");
        elements.add("__running __tick", i, " tick", i);
    }
}

}  // namespace

Time append_spice_stimuli(std::string& out, SpiceElements& elements, const Netlist& netlist,
                          const NetSpelling& nets, const Bench& bench, Time start) {
    const Waves waves(netlist, bench);
    // The flip-flop is at 0 from the first, whatever the analogue solver tries before it knows
    // better.
    append(out, "\n* The start, and the node that samples\nv1 __v1 0 pwl(0 0 ", start, " 0 ",
           start + nanosecond, " 1)\n");
    elements.add("[ __v1 ] [ __go ] bridge");
    elements.add("__one __go null null __running __start flip_flop_0");
    elements.add("__one one");
    std::size_t levels = 0;
    for (std::size_t reach = SpiceElements::widest; reach < waves.ticks().size();
         reach *= SpiceElements::widest) {
        ++levels;
    }
    add_wave(elements, "sample__", waves.sample(), levels);
    out += "\n* Inputs\n";
    for (std::size_t i = 0; i < waves.inputs().size(); ++i) {
        add_wave(elements, nets[netlist.inputs[i].net], waves.inputs()[i], levels);
    }
    append_ticks(out, elements, waves.ticks());
    return waves.end();
}

}  // namespace grafwire
