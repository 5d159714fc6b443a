// A deck of digital elements (spice_cells.cpp) under the stimuli of a bench.
//
// The delays of XSPICE are not inertial: the shortest spike passes. Two changes that reach a gate
// together must therefore do so at exactly the same moment, and sums of decimal fractions of a
// second do not. So the deck counts in picoseconds, as whole numbers: what ngspice takes for a
// second is one.
//
// During the start (node `__start` at 1) Init is 1, latches and nets with initial values are held
// at these, and timers at theirs.
//
// Delays are multiples of the parameter `gate`, by default what the delay model says, and a row is
// sampled when the time `settle` has passed, so many gate delays, but before the next instant.
//
// XSPICE has no cell that counts clock edges: the row of the format asks for counters of flip-flops
// in the place of clocked timers (netlist/passes/counted_timers.h).
//
// Outputs are sampled by flip-flops: thus `eprint` shows them once an instant and not at every
// change of a gate.

//
// Inputs are made of delays: a buffer per moment of the stimuli, and an input is the exclusive or
// of the moments at which it changes. A voltage source behind a bridge would change up to some
// microseconds late, since the analogue solver chooses its own steps, and a digital source would
// need a second file.

#include "formats/spice/write_spice.h"

#include <algorithm>

#include "formats/shared/append.h"
#include "formats/shared/gate_delays.h"
#include "formats/spice/spice_cells.h"

namespace grafwire {

namespace {

/// A moment of the stimuli, counted from the end of the start: at that time, or later by a part of
/// the time that the netlist is given to settle.
struct Moment {
    Time at = 0;
    Time longest = 0;  ///< of the settling time; 0: the moment does not depend on it
    std::uint32_t part = 1;
    std::uint32_t parts = 1;
    bool operator==(const Moment&) const = default;
};

/// In ps, for a delay: at least one.
std::string spelled(const Moment& moment) {
    std::string text;
    if (moment.longest == 0) {
        append(text, std::max<Time>(1, moment.at));
        return text;
    }
    text += '{';
    if (moment.at != 0) append(text, moment.at, " + ");
    const bool is_whole = moment.part == moment.parts;
    if (!is_whole) text += "floor(";
    if (moment.longest == never) {
        text += "settle";
    } else {
        append(text, "min(settle, ", moment.longest, ")");
    }
    if (!is_whole) append(text, " / ", moment.parts, ")");
    if (moment.part != 1) append(text, " * ", moment.part);
    return text += '}';
}

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
    const std::vector<Moment>& ticks() const { return ticks_; }
    Time last_instant() const { return last_instant_; }

  private:
    void add(const BenchEvent& event);
    std::size_t tick(const Moment& moment);

    const Netlist& netlist_;
    const Bench& bench_;
    std::vector<Wave> inputs_;
    Wave sample_;
    std::vector<Moment> ticks_;
    std::size_t clock_ = 0;  ///< which input is the clock
    Time last_instant_ = 0;
};

/// The number of a moment; moments come in order.
std::size_t Waves::tick(const Moment& moment) {
    if (ticks_.empty() || ticks_.back() != moment) ticks_.push_back(moment);
    return ticks_.size() - 1;
}

void Waves::add(const BenchEvent& event) {
    for (const Stimuli::Assignment& item : event.assignments) {
        inputs_[item.input].ticks.push_back(tick({.at = event.at}));
    }
    if (event.row == BenchEvent::no_row) return;
    const Time longest = longest_sampling_delay(bench_, event.row);
    if (netlist_.is_clocked()) {
        const std::uint32_t parts = 2 * bench_.clock_cycles + 2;
        for (std::uint32_t part = 1; part <= 2 * bench_.clock_cycles; ++part) {
            inputs_[clock_].ticks.push_back(tick({event.at, longest, part, parts}));
        }
    }
    sample_.ticks.push_back(tick({event.at, longest}));
    if (longest == never) {
        sample_.ticks.push_back(tick({event.at, longest, 3, 2}));
    } else {
        const Time gap = bench_.instants[event.row + 1] - event.at;
        sample_.ticks.push_back(tick({.at = event.at + gap - gap / 20}));
    }
    last_instant_ = event.at;
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

void append_ticks(std::string& out, SpiceElements& elements, const std::vector<Moment>& ticks) {
    out += "\n* The moments of the stimuli\n";
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        append(out, ".model tick", i, " d_buffer(rise_delay=", spelled(ticks[i]),
               " fall_delay=1)\n");
        elements.add("__running __tick", i, " tick", i);
    }
}

/// Writes the start (nodes `__start` and `__running`, one the complement of the other), the inputs
/// and their clock as the bench has them, and the node `sample__`, which rises when an instant has
/// settled and falls before the next. `start` is the length of the start. Gives the last instant,
/// counted from the end of the start.
Time append_spice_stimuli(std::string& out, SpiceElements& elements, const Netlist& netlist,
                          const NetSpelling& nets, const Bench& bench, std::string_view start) {
    const Waves waves(netlist, bench);
    // The flip-flop is at 0 from the first, whatever the analogue solver tries before it knows
    // better.
    append(out, "\n* The start, and the node that samples\nv1 __v1 0 pwl(0 0 {", start, "} 0 {",
           start, " + ", nanosecond, "} 1)\n");
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
    return waves.last_instant();
}

/// The whole deck, part by part.
class DeckWriter {
  public:
    DeckWriter(const Netlist& netlist, const Bench& bench, const DelayModel& delays)
        : netlist_(netlist),
          bench_(bench),
          delays_(delays),
          nets_(spice_nodes(netlist)),
          elements_(out_),
          start_(in_gate_delays(delays.of_settling(netlist.cells.size()), delays, "gate")) {}

    std::string write();

  private:
    void write_head();
    void list_ports(const std::vector<Port>& ports);
    void list_inner_nodes();
    void write_parameters();
    void write_cells();
    std::vector<NetId> sampled_nets() const;
    void write_sampling();
    void write_control(Time last_instant);

    const Netlist& netlist_;
    const Bench& bench_;
    const DelayModel& delays_;
    NetSpelling nets_;
    std::string out_;
    SpiceElements elements_;
    std::string start_;
    SpiceModels models_;
};

std::string DeckWriter::write() {
    write_head();
    write_parameters();
    write_cells();
    const Time last_instant =
        append_spice_stimuli(out_, elements_, netlist_, nets_, bench_, start_);
    write_sampling();
    append_spice_models(out_, models_, delays_);
    write_control(last_instant);
    return std::move(out_);
}

void DeckWriter::write_head() {
    out_ += "* A deck for ngspice 39 or later: ngspice -b FILE\n* Inputs:\n";
    list_ports(netlist_.inputs);
    out_ += "* Outputs; sampled once an instant as nodes with _ before their names:\n";
    list_ports(netlist_.outputs);
    out_ += "* Inner nodes that are not called alike:\n";
    list_inner_nodes();
}

void DeckWriter::list_ports(const std::vector<Port>& ports) {
    for (const Port& port : ports) {
        append(out_, "*   ", nets_[port.net], " = ");
        append_comment(out_, port.name);
        out_ += '\n';
    }
}

void DeckWriter::list_inner_nodes() {
    std::vector<std::uint8_t> is_port(netlist_.net_count());
    for (const Port& port : netlist_.outputs) is_port[index_of(port.net)] = 1;
    for (const Cell& cell : netlist_.cells) {
        const bool is_renamed_net = is_renamed(nets_[cell.output], netlist_.names[cell.output]);
        if (!is_renamed_net || is_port[index_of(cell.output)] != 0) continue;
        append(out_, "*   ", nets_[cell.output], " = ");
        append_comment(out_, netlist_.names[cell.output]);
        out_ += '\n';
    }
}

/// What a user may change: all other delays follow.
void DeckWriter::write_parameters() {
    append(out_,
           "\n* How long a gate takes and the netlist may take to settle, in ps\n.param gate=",
           delays_.gate.max, "\n.param settle={", in_gate_delays(bench_.settling, delays_, "gate"),
           "}\n");
}

void DeckWriter::write_cells() {
    SpiceCells cells(netlist_, nets_, elements_);
    for (const Module& module : netlist_.modules) {
        out_ += "\n* ";
        append_comment(out_, module.comment.empty() ? module.name : module.comment);
        out_ += '\n';
        for (std::uint32_t i = 0; i < module.cell_count; ++i) {
            cells.write(netlist_.cells.items()[module.first_cell + i]);
        }
    }
    models_ = cells.models();
}

/// The nets of the output ports, each once.
std::vector<NetId> DeckWriter::sampled_nets() const {
    std::vector<NetId> nets;
    std::vector<std::uint8_t> done(netlist_.net_count());
    for (const Port& port : netlist_.outputs) {
        if (done[index_of(port.net)]++ == 0) nets.push_back(port.net);
    }
    return nets;
}

void DeckWriter::write_sampling() {
    for (const NetId net : sampled_nets()) {
        elements_.add(nets_[net], " sample__ null null _", nets_[net], " null sampler");
    }
}

/// Twice the start, since it may end late, and twice what the last row is given.
void DeckWriter::write_control(Time last_instant) {
    append(out_, "\n.param end={2 * ", start_, " + ", last_instant,
           " + 2 * settle}\n.tran {end / 50} {end}\n.control\nrun\n");
    constexpr std::size_t outputs_per_table = 90;  // eprint takes 93 nodes at most
    std::size_t in_table = 0;
    for (const NetId net : sampled_nets()) {
        if (in_table++ % outputs_per_table == 0) {
            append(out_, in_table == 1 ? "" : "\n", "eprint sample__");
        }
        append(out_, " _", nets_[net]);
    }
    out_ += "\nquit\n.endc\n.end\n";
}

}  // namespace

std::string write_spice(const Netlist& netlist, const Bench& bench, const DelayModel& delays) {
    return DeckWriter(netlist, bench, delays).write();
}

}  // namespace grafwire
