// A deck of digital elements (spice_cells.cpp) under the stimuli of a bench (spice_stimuli.cpp).
//
// The delays of XSPICE are not inertial: the shortest spike passes. Two changes that reach a gate
// together must therefore do so at exactly the same moment, and sums of decimal fractions of a
// second do not. So the deck counts in picoseconds, as whole numbers: what ngspice takes for a
// second is one.
//
// During the start (node `__start` at 1) Init is 1, latches and nets with initial values are held
// at these, and timers at theirs.
//
// XSPICE has no cell that counts clock edges: the row of the format asks for counters of flip-flops
// in the place of clocked timers (netlist/passes/counted_timers.h).
//
// Outputs are sampled by flip-flops: thus `eprint` shows them once an instant and not at every
// change of a gate.

#include "formats/spice/write_spice.h"

#include <algorithm>

#include "formats/shared/append.h"
#include "formats/spice/spice_cells.h"
#include "formats/spice/spice_elements.h"
#include "formats/spice/spice_stimuli.h"

namespace grafwire {

namespace {

class DeckWriter {
  public:
    DeckWriter(const Netlist& netlist, const Bench& bench, std::string_view remark,
               const DelayModel& delays)
        : netlist_(netlist),
          bench_(bench),
          remark_(remark),
          delays_(delays),
          nets_(spice_nodes(netlist)),
          elements_(out_),
          start_(delays.of_settling(netlist.cells.size())) {}

    std::string write();

  private:
    void write_head();
    void list_ports(const std::vector<Port>& ports);
    void list_inner_nodes();
    void write_cells();
    std::vector<NetId> sampled_nets() const;
    void write_sampling();
    void write_control(Time end);

    const Netlist& netlist_;
    const Bench& bench_;
    std::string_view remark_;  ///< for the head
    const DelayModel& delays_;
    NetSpelling nets_;
    std::string out_;
    SpiceElements elements_;
    Time start_;
    SpiceModels models_;
};

std::string DeckWriter::write() {
    write_head();
    write_cells();
    const Time end = append_spice_stimuli(out_, elements_, netlist_, nets_, bench_, start_);
    write_sampling();
    append_spice_models(out_, models_, delays_);
    write_control(start_ + start_ + end);  // the start may end late
    return std::move(out_);
}

void DeckWriter::write_head() {
    // The first line of a deck is its title, but ngspice obeys it where it looks like a command;
    // not behind an asterisk and a blank.
    out_ += "* ";
    append_comment(out_, netlist_.name);
    append(out_, ": ", netlist_.cells.size(),
           " cells, for ngspice 39 or later (ngspice -b FILE)\n");
    if (!remark_.empty()) append(out_, "* ", remark_, '\n');
    out_ += "* Inputs:\n";
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

void DeckWriter::write_control(Time end) {
    append(out_, "\n.control\ntran ", end / 50 + 1, ' ', end, '\n');
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

std::string write_spice(const Netlist& netlist, const Bench& bench, std::string_view remark,
                        const DelayModel& delays) {
    return DeckWriter(netlist, bench, remark, delays).write();
}

}  // namespace grafwire
