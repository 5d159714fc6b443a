// Gates are XSPICE digital models with a delay of 1 ns (ngspice manual, "XSPICE: digital models").
// Cells without a model of their own are put together from others; what is inside such a cell takes
// a picosecond, and the rest so much less, so that the whole takes 1 ns on every way through it:
//
//     latch       q = s + /r.q
//     pulse       a flip-flop set by the edge, reset by its own output through a delay
//     timer       a buffer with the two delays
//
// The delays of XSPICE are not inertial: the shortest spike passes. Two changes that reach a gate
// together must therefore do so at exactly the same moment, and sums of decimal fractions of a
// second do not. So the deck counts in picoseconds, as whole numbers: what ngspice takes for a
// second is one.
//
// During the start (node `__start` at 1) Init is 1, latches and nets with initial values are held
// at these, and timers at theirs.
//
// Inputs are made of delays, too: a buffer per moment of the stimuli, and an input is the exclusive
// or of the moments at which it changes. A voltage source behind a bridge would change up to some
// microseconds late, since the analogue solver chooses its own steps, and a digital source would
// need a second file.
//
// Outputs are sampled by flip-flops: thus `eprint` shows them once an instant and not at every
// change of a gate.

#include "export/write_spice.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <span>

#include "export/append.h"
#include "export/spice_models.h"
#include "export/spice_names.h"

namespace grafwire {

namespace {

/// A digital source that changes from time to time.
struct Wave {
    bool value = false;              ///< during the start
    std::vector<std::size_t> ticks;  ///< the numbers of the moments at which it changes
};

constexpr std::size_t widest = 48;  ///< nodes in one list

class DeckWriter {
  public:
    DeckWriter(const Netlist& netlist, const Bench& bench)
        : netlist_(netlist),
          bench_(bench),
          nets_(netlist),
          start_(std::max<Time>(1'000, static_cast<Time>(netlist.cells.size())) * nanosecond),
          initial_(netlist.net_count(), Logic::unknown) {
        for (const Netlist::InitialValue& item : netlist.initial_values) {
            initial_[index_of(item.net)] = item.value ? Logic::one : Logic::zero;
        }
    }

    std::string write();

  private:
    void write_head();
    void write_cell(const Cell& cell);
    std::vector<std::string_view> gather(std::span<const std::string_view> nodes,
                                         std::string_view model);
    void write_gate(std::string_view speed, CellType type, std::vector<std::string_view> pins,
                    std::string_view output);
    void write_latch(const Cell& cell, std::string_view output);
    void write_memory(const Cell& cell, std::string_view model, std::string_view output);
    void write_pulse(const Cell& cell, std::string_view output);
    void write_timer(const Cell& cell, std::string_view output);
    void write_sources();
    std::size_t tick(Time moment);
    void write_ticks();
    void write_wave(std::string_view node, const Wave& wave, std::size_t levels);
    void write_sampling();
    void write_control();

    template <typename... Parts>
    void element(const Parts&... parts) {
        append(out_, 'a', ++element_count_, ' ', parts..., '\n');
    }
    std::string_view pin(const Cell& cell, std::size_t number) const {
        return nets_[netlist_.pins_of(cell)[number]];
    }
    std::string inner_node() {
        std::string name = "__";
        append(name, ++inner_count_);
        return name;
    }

    const Netlist& netlist_;
    const Bench& bench_;
    SpiceNames nets_;
    Time start_;
    std::vector<Logic> initial_;  ///< per net: Netlist::initial_values
    SpiceModels models_;
    std::size_t element_count_ = 0;
    std::size_t inner_count_ = 0;
    std::deque<std::string> own_names_;  ///< of inner nodes, to be referred to
    std::vector<Time> ticks_;            ///< the moments, counted from the end of the start
    Time end_ = 0;
    std::string out_;
};

std::string DeckWriter::write() {
    write_head();
    for (const Module& module : netlist_.modules) {
        out_ += "\n* ";
        append_comment(out_, module.comment.empty() ? module.name : module.comment);
        out_ += '\n';
        for (std::uint32_t i = 0; i < module.cell_count; ++i) {
            write_cell(netlist_.cells.items()[module.first_cell + i]);
        }
    }
    write_sources();
    write_sampling();
    append_spice_models(out_, models_);
    write_control();
    return std::move(out_);
}

void DeckWriter::write_head() {
    // The first line of a deck is its title.
    append_comment(out_, netlist_.name);
    append(out_, ": ", netlist_.cells.size(),
           " cells, for ngspice 39 or later (ngspice -b FILE)\n");
    const auto list = [&](const std::vector<Port>& ports) {
        for (const Port& port : ports) {
            append(out_, "*   ", nets_[port.net], " = ");
            append_comment(out_, port.name);
            out_ += '\n';
        }
    };
    out_ += "* Inputs:\n";
    list(netlist_.inputs);
    out_ += "* Outputs; sampled once an instant as nodes with _ before their names:\n";
    list(netlist_.outputs);
    out_ += "* Inner nodes that are not called alike:\n";
    std::vector<std::uint8_t> is_port(netlist_.net_count());
    for (const Port& port : netlist_.outputs) is_port[index_of(port.net)] = 1;
    for (const Cell& cell : netlist_.cells) {
        if (!nets_.is_changed(cell.output) || is_port[index_of(cell.output)] != 0) continue;
        append(out_, "*   ", nets_[cell.output], " = ");
        append_comment(out_, netlist_.names[cell.output]);
        out_ += '\n';
    }
}

struct GateModel {
    std::string_view name;    ///< of any number of inputs
    std::string_view single;  ///< of one
    std::string_view part;    ///< gathers some of many inputs
};

GateModel model_of(CellType type) {
    switch (type) {
        case CellType::and_gate:
            return {"and", "buffer", "and"};
        case CellType::or_gate:
            return {"or", "buffer", "or"};
        case CellType::nand_gate:
            return {"nand", "not", "and"};
        case CellType::nor_gate:
            return {"nor", "not", "or"};
        case CellType::xor_gate:
            return {"xor", "buffer", "xor"};
        case CellType::inverter:
            return {"not", "not", ""};
        default:
            return {"buffer", "buffer", ""};
    }
}

/// A list of nodes in brackets, over as many lines as it takes.
std::string bracketed(std::span<const std::string_view> nodes) {
    std::string text = "[";
    std::size_t on_line = 0;
    for (const std::string_view node : nodes)
        append(text, ++on_line % 16 == 0 ? "\n+ " : " ", node);
    return text + " ]";
}

/// Quick gates for groups of the nodes, and the nodes they drive: ngspice has no room for very long
/// lists.
std::vector<std::string_view> DeckWriter::gather(std::span<const std::string_view> nodes,
                                                 std::string_view model) {
    std::vector<std::string_view> gathered;
    for (std::size_t first = 0; first < nodes.size(); first += widest) {
        const auto part = nodes.subspan(first, std::min(widest, nodes.size() - first));
        const std::string& node = own_names_.emplace_back(inner_node());
        if (part.size() == 1) {
            element(part[0], ' ', node, " fast_buffer");
        } else {
            element(bracketed(part), ' ', node, " fast_", model);
        }
        gathered.push_back(node);
    }
    return gathered;
}

void DeckWriter::write_gate(std::string_view speed, CellType type,
                            std::vector<std::string_view> pins, std::string_view output) {
    const GateModel model = model_of(type);
    while (pins.size() > widest) pins = gather(pins, model.part);
    if (pins.size() == 1) return element(pins[0], ' ', output, ' ', speed, model.single);
    element(bracketed(pins), ' ', output, ' ', speed, model.name);
}

void DeckWriter::write_latch(const Cell& cell, std::string_view output) {
    // Both inputs pass two quick elements before the last.
    const std::string not_reset = inner_node();
    const std::string kept = inner_node();
    const std::string set = inner_node();
    const std::string late_set = inner_node();
    const bool starts_at_0 = cell.initial == Logic::zero;
    const bool starts_at_1 = cell.initial == Logic::one;
    element(pin(cell, 1), ' ', not_reset, " fast_not");
    element("[ ", not_reset, ' ', output, starts_at_0 ? " __running ] " : " ] ", kept, " fast_and");
    element(pin(cell, 0), ' ', set, " fast_buffer");
    element(set, ' ', late_set, " fast_buffer");
    element("[ ", late_set, ' ', kept, starts_at_1 ? " __start ] " : " ] ", output, " late_or");
}

void DeckWriter::write_memory(const Cell& cell, std::string_view model, std::string_view output) {
    const char initial = cell.initial == Logic::one ? '1' : cell.initial == Logic::zero ? '0' : 'x';
    element(pin(cell, 0), ' ', pin(cell, 1), " null null ", output, " null ", model, '_', initial);
}

void DeckWriter::write_pulse(const Cell& cell, std::string_view output) {
    std::string clock(pin(cell, 0));
    if (cell.type == CellType::fall_pulse) {
        clock = inner_node();
        element(pin(cell, 0), ' ', clock, " fast_not");
    }
    const auto model =
        models_.pulses.try_emplace(netlist_.timings[cell.timing].fall, models_.pulses.size() + 1);
    const std::string over = inner_node();
    const std::string reset = inner_node();
    element("__one ", clock, " null ", reset, ' ', output, " null ",
            cell.type == CellType::fall_pulse ? "one_shot_fall" : "one_shot_rise");
    element(output, ' ', over, " pulse", model.first->second);
    element("[ ", over, " __start ] ", reset, " fast_or");
}

void DeckWriter::write_timer(const Cell& cell, std::string_view output) {
    const Timing& timing = netlist_.timings[cell.timing];
    const auto model =
        models_.timers.try_emplace({timing.rise, timing.fall}, models_.timers.size() + 1);
    const std::string operand = inner_node();
    const bool starts_at_1 = cell.initial == Logic::one;
    element("[ ", pin(cell, 0), starts_at_1 ? " __start ] " : " __running ] ", operand,
            starts_at_1 ? " fast_or" : " fast_and");
    element(operand, ' ', output, " timer", model.first->second);
}

void DeckWriter::write_cell(const Cell& cell) {
    std::string output(nets_[cell.output]);
    // A gate with an initial value drives an inner node, which the net follows after the start.
    const Logic held = initial_[index_of(cell.output)];
    if (held != Logic::unknown) {
        const std::string free = inner_node();
        const bool at_1 = held == Logic::one;
        element("[ ", free, at_1 ? " __start ] " : " __running ] ", output,
                at_1 ? " fast_or" : " fast_and");
        output = free;
    }
    switch (cell.type) {
        case CellType::low:
            return element(output, " zero");
        case CellType::high:
            return element(output, " one");
        case CellType::latch:
            return write_latch(cell, output);
        case CellType::hold_latch:
            return write_memory(cell, "hold", output);
        case CellType::flip_flop:
            return write_memory(cell, "flip_flop", output);
        case CellType::rise_pulse:
        case CellType::fall_pulse:
            return write_pulse(cell, output);
        case CellType::timer:
            return write_timer(cell, output);
        case CellType::scan_timer:
            return;  // refused before
        default:
            break;
    }
    std::vector<std::string_view> pins;
    for (const NetId net : netlist_.pins_of(cell)) pins.push_back(nets_[net]);
    write_gate(held != Logic::unknown ? "held_" : "slow_", cell.type, std::move(pins), output);
}

/// The number of a moment; moments come in order.
std::size_t DeckWriter::tick(Time moment) {
    if (ticks_.empty() || ticks_.back() != moment) ticks_.push_back(moment);
    return ticks_.size() - 1;
}

void DeckWriter::write_ticks() {
    out_ += "\n* The moments of the stimuli\n";
    for (std::size_t i = 0; i < ticks_.size(); ++i) {
        append(out_, ".model tick", i, " d_buffer(rise_delay=", std::max<Time>(1, ticks_[i]),
               " fall_delay=1)\n");
        element("__running __tick", i, " tick", i);
    }
}

/// All inputs go through the same number of levels, lest some change later than others.
void DeckWriter::write_wave(std::string_view node, const Wave& wave, std::size_t levels) {
    if (wave.ticks.empty()) return element(node, wave.value ? " one" : " zero");
    std::vector<std::string_view> nodes;
    for (const std::size_t number : wave.ticks) {
        std::string& name = own_names_.emplace_back("__tick");
        append(name, number);
        nodes.push_back(name);
    }
    for (std::size_t level = 0; level < levels; ++level) nodes = gather(nodes, "xor");
    if (nodes.size() == 1) {
        return element(nodes[0], ' ', node, wave.value ? " fast_not" : " fast_buffer");
    }
    element(bracketed(nodes), ' ', node, wave.value ? " fast_xnor" : " fast_xor");
}

void DeckWriter::write_sources() {
    std::vector<Wave> waves;
    for (const bool value : starting_inputs(netlist_, bench_)) waves.push_back({value, {}});
    std::size_t clock = 0;
    while (clock < waves.size() && netlist_.inputs[clock].net != netlist_.clock) ++clock;
    Wave sample;
    end_ = bench_.settling;
    for (const BenchEvent& event : bench_events(netlist_, bench_)) {
        for (const Bench::Assignment& item : event.assignments) {
            waves[item.input].ticks.push_back(tick(event.at));
        }
        if (event.row == BenchEvent::no_row) continue;
        const Time delay = sampling_delay(bench_, event.row);
        if (netlist_.is_clocked()) {
            const Time half_period = delay / (2 * Time{bench_.clock_cycles} + 2);
            for (std::uint32_t i = 1; i <= 2 * bench_.clock_cycles; ++i) {
                waves[clock].ticks.push_back(tick(event.at + half_period * i));
            }
        }
        const bool is_last = event.row + 1 == bench_.instants.size();
        const Time rest =
            is_last ? bench_.settling : bench_.instants[event.row + 1] - event.at - delay;
        sample.ticks.push_back(tick(event.at + delay));
        sample.ticks.push_back(tick(event.at + delay + rest / 2));
        end_ = event.at + delay + rest;
    }
    // The flip-flop is at 0 from the first, whatever the analogue solver tries before it knows
    // better.
    append(out_, "\n* The start, and the node that samples\nv1 __v1 0 pwl(0 0 ", start_, " 0 ",
           start_ + nanosecond, " 1)\n");
    element("[ __v1 ] [ __go ] bridge");
    element("__one __go null null __running __start flip_flop_0");
    element("__one one");
    std::size_t levels = 0;
    for (std::size_t reach = widest; reach < ticks_.size(); reach *= widest) ++levels;
    write_wave("sample__", sample, levels);
    out_ += "\n* Inputs\n";
    for (std::size_t i = 0; i < waves.size(); ++i) {
        write_wave(nets_[netlist_.inputs[i].net], waves[i], levels);
    }
    write_ticks();
}

void DeckWriter::write_sampling() {
    std::vector<std::uint8_t> done(netlist_.net_count());
    for (const Port& port : netlist_.outputs) {
        if (done[index_of(port.net)]++ != 0) continue;
        element(nets_[port.net], " sample__ null null _", nets_[port.net], " null sampler");
    }
}

void DeckWriter::write_control() {
    const Time end = start_ + start_ + end_;  // the start may end late
    append(out_, "\n.control\ntran ", end / 50 + 1, ' ', end, '\n');
    constexpr std::size_t outputs_per_table = 90;  // eprint takes 93 nodes at most
    std::vector<std::uint8_t> done(netlist_.net_count());
    std::size_t in_table = 0;
    for (const Port& port : netlist_.outputs) {
        if (done[index_of(port.net)]++ != 0) continue;
        if (in_table++ % outputs_per_table == 0) {
            append(out_, in_table == 1 ? "" : "\n", "eprint sample__");
        }
        append(out_, " _", nets_[port.net]);
    }
    out_ += "\nquit\n.endc\n.end\n";
}

}  // namespace

std::string write_spice(const Netlist& netlist, const Bench& bench, Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < netlist.cells.size(); ++i) {
        const CellId cell = netlist.cells.id_at(i);
        if (netlist.cells[cell].type != CellType::scan_timer) continue;
        diagnostics.error(
            Code::unsupported_by_style, netlist.origin_of(netlist.cells[cell]).where,
            fmt::format("{}: ngspice has no clocked timer; use an asynchronous style or "
                        "Verilog",
                        cell_description(netlist, cell)));
        return {};
    }
    return DeckWriter(netlist, bench).write();
}

}  // namespace grafwire
