// Gates are XSPICE digital models with an inertial delay of 1 ns (ngspice manual, "XSPICE: digital
// models"). Cells without a model of their own are put together from others; what such a cell has
// inside takes a picosecond, so that the whole still takes 1 ns.
//
//     latch       q = s + /r.q
//     pulse       a flip-flop set by the edge, reset by itself through a delay
//     timer       a buffer with the two delays
//
// During the start (node `start` at 1) Init is 1, latches and nets with initial values are held at
// these, and timers at theirs. Inputs are voltage sources behind analog-to-digital bridges, since a
// digital source would need a second file. Outputs are sampled by flip-flops: thus `eprint` shows
// them once an instant and not at every change of a gate.

#include "export/write_spice.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "export/append.h"
#include "export/spice_names.h"

namespace grafwire {

namespace {

/// A time in seconds, exact to the picosecond.
std::string seconds(Time time) {
    return fmt::format("{}.{:012}", time / second, time % second);
}

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
    /// A source that changes from time to time.
    struct Wave {
        bool value = false;
        std::string points;
        void set(Time at, bool to) {
            append(points, "\n+ ", seconds(at), ' ', value ? '1' : '0', ' ',
                   seconds(at + nanosecond / 10), ' ', to ? '1' : '0');
            value = to;
        }
    };

    void write_head();
    void write_cell(const Cell& cell);
    void write_gate(std::string_view model, const Cell& cell, std::string_view output);
    void write_latch(const Cell& cell, std::string_view output);
    void write_memory(const Cell& cell, std::string_view model, std::string_view output);
    void write_pulse(const Cell& cell, std::string_view output);
    void write_timer(const Cell& cell, std::string_view output);
    std::string timer_model(const Timing& timing);
    std::string pulse_model(Time width);
    void write_sources();
    void write_wave(std::string_view node, const Wave& wave);
    void write_sampling();
    void write_models();
    void write_control(Time end);
    template <typename... Parts>
    void element(const Parts&... parts) {
        append(out_, 'a', ++element_count_, ' ', parts..., '\n');
    }
    std::string_view pin(const Cell& cell, std::size_t number) const {
        return nets_[netlist_.pins_of(cell)[number]];
    }
    std::string inner() { return "_" + std::to_string(++inner_count_); }

    const Netlist& netlist_;
    const Bench& bench_;
    SpiceNames nets_;
    Time start_;
    std::vector<Logic> initial_;
    std::map<std::pair<Time, Time>, std::string> timer_models_;
    std::map<Time, std::string> pulse_models_;
    std::size_t element_count_ = 0;
    std::size_t inner_count_ = 0;
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
    write_models();
    write_control(end_);
    return std::move(out_);
}

void DeckWriter::write_head() {
    // The first line of a deck is its title.
    append_comment(out_, netlist_.name);
    append(out_, ": ", netlist_.cells.size(), " cells, for ngspice 39 or later: ngspice -b FILE\n");
    out_ += "*\n* Nodes and what they are called in the GRAFCET:\n";
    const auto list = [&](const std::vector<Port>& ports) {
        for (const Port& port : ports) {
            append(out_, "*   ", nets_[port.net], " = ");
            append_comment(out_, port.name);
            out_ += '\n';
        }
    };
    list(netlist_.inputs);
    list(netlist_.outputs);
    out_ += "* Inner nodes that are not called alike:\n";
    for (const Cell& cell : netlist_.cells) {
        const std::string_view name = netlist_.names[cell.output];
        if (!nets_.is_changed(cell.output)) continue;
        append(out_, "*   ", nets_[cell.output], " = ");
        append_comment(out_, name);
        out_ += '\n';
    }
}

void DeckWriter::write_gate(std::string_view model, const Cell& cell, std::string_view output) {
    if (cell.pin_count == 1) return element(pin(cell, 0), ' ', output, ' ', model);
    std::string pins;
    std::size_t on_line = 0;
    for (const NetId net : netlist_.pins_of(cell)) {
        append(pins, ++on_line % 16 == 0 ? "\n+ " : on_line == 1 ? "" : " ", nets_[net]);
    }
    element('[', pins, "] ", output, ' ', model);
}

void DeckWriter::write_latch(const Cell& cell, std::string_view output) {
    const std::string not_reset = inner();
    const std::string kept = inner();
    element(pin(cell, 1), ' ', not_reset, " fast_not");
    if (cell.initial == Logic::one) {
        element('[', not_reset, ' ', output, "] ", kept, " fast_and");
        element('[', pin(cell, 0), ' ', kept, " start] ", output, " slow_or");
        return;
    }
    element('[', not_reset, ' ', output, cell.initial == Logic::zero ? " running] " : "] ", kept,
            " fast_and");
    element('[', pin(cell, 0), ' ', kept, "] ", output, " slow_or");
}

void DeckWriter::write_memory(const Cell& cell, std::string_view model, std::string_view output) {
    const std::string_view initial = cell.initial == Logic::one    ? "_1"
                                     : cell.initial == Logic::zero ? "_0"
                                                                   : "_x";
    element(pin(cell, 0), ' ', pin(cell, 1), " null null ", output, " null ", model, initial);
}

std::string DeckWriter::pulse_model(Time width) {
    const auto [found, is_new] = pulse_models_.try_emplace(width);
    if (is_new) found->second = "pulse" + std::to_string(pulse_models_.size());
    return found->second;
}

/// The flip-flop takes 1 ns to set and a picosecond to reset; the reset begins when the pulse has
/// lasted its width but for that picosecond.
void DeckWriter::write_pulse(const Cell& cell, std::string_view output) {
    std::string clock(pin(cell, 0));
    if (cell.type == CellType::fall_pulse) {
        const std::string inverted = inner();
        element(clock, ' ', inverted, " fast_not");
        clock = inverted;
    }
    const std::string reset = inner();
    const std::string gated = inner();
    element("[running ", clock, "] ", gated, " fast_and");
    element("one ", gated, " null ", reset, ' ', output, " null one_shot");
    element(output, ' ', reset, ' ', pulse_model(netlist_.timings[cell.timing].fall));
}

std::string DeckWriter::timer_model(const Timing& timing) {
    const auto [found, is_new] = timer_models_.try_emplace({timing.rise, timing.fall});
    if (is_new) found->second = "timer" + std::to_string(timer_models_.size());
    return found->second;
}

void DeckWriter::write_timer(const Cell& cell, std::string_view output) {
    const std::string operand = inner();
    if (cell.initial == Logic::one) {
        element('[', pin(cell, 0), " start] ", operand, " fast_or");
    } else {
        element('[', pin(cell, 0), " running] ", operand, " fast_and");
    }
    element(operand, ' ', output, ' ', timer_model(netlist_.timings[cell.timing]));
}

void DeckWriter::write_cell(const Cell& cell) {
    std::string output(nets_[cell.output]);
    // A gate with an initial value drives an inner node, and the net follows that after the start.
    const Logic held = initial_[index_of(cell.output)];
    if (held != Logic::unknown) {
        const std::string free = inner();
        element('[', free, held == Logic::one ? " start] " : " running] ", output,
                held == Logic::one ? " fast_or" : " fast_and");
        output = free;
    }
    const bool single = cell.pin_count == 1;
    switch (cell.type) {
        case CellType::low: return element(output, " zero_source");
        case CellType::high: return element(output, " one_source");
        case CellType::buffer: return write_gate("slow_buffer", cell, output);
        case CellType::inverter: return write_gate("slow_not", cell, output);
        case CellType::and_gate: return write_gate(single ? "slow_buffer" : "slow_and", cell, output);
        case CellType::or_gate: return write_gate(single ? "slow_buffer" : "slow_or", cell, output);
        case CellType::xor_gate: return write_gate(single ? "slow_buffer" : "slow_xor", cell, output);
        case CellType::nand_gate: return write_gate(single ? "slow_not" : "slow_nand", cell, output);
        case CellType::nor_gate: return write_gate(single ? "slow_not" : "slow_nor", cell, output);
        case CellType::latch: return write_latch(cell, output);
        case CellType::hold_latch: return write_memory(cell, "hold", output);
        case CellType::flip_flop: return write_memory(cell, "flip_flop", output);
        case CellType::rise_pulse:
        case CellType::fall_pulse: return write_pulse(cell, output);
        case CellType::timer: return write_timer(cell, output);
        case CellType::scan_timer: return;  // refused before
    }
}

void DeckWriter::write_wave(std::string_view node, const Wave& wave) {
    append(out_, 'v', node, " v_", node, " 0 pwl(0 ", wave.points.empty() ? wave.value : !wave.value, "");
}

}  // namespace

}  // namespace grafwire
