// Nodes are numbered, `c` cells, `i` input ports, `o` output ports, and show names as labels: so no
// name has to be an identifier of Graphviz.

#include "formats/dot/write_dot.h"

#include "formats/shared/append.h"

namespace grafwire {

namespace {

/// Within a label; line breaks would be read as such.
void append_quoted(std::string& out, std::string_view text) {
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        append_comment(out, std::string_view(&c, 1));
    }
}

/// What a cell was made for.
std::string_view kind_word(Origin::Kind kind) {
    switch (kind) {
        case Origin::Kind::step:
            return "step ";
        case Origin::Kind::transition:
            return "transition ";
        case Origin::Kind::output:
            return "output ";
        case Origin::Kind::input:
            return "input ";
        case Origin::Kind::var:
            return "var ";
        case Origin::Kind::counter:
            return "counter ";
        case Origin::Kind::graph:
            return "graph ";
        default:
            return "";
    }
}

std::string_view shape_of(CellType type) {
    return row_of(type).has_memory || row_of(type).has_timing ? "box3d" : "box";
}

/// The graph: input ports, clusters, output ports, then an edge per pin.
class DotWriter {
  public:
    explicit DotWriter(const Netlist& netlist) : netlist_(netlist), drivers_(drivers_of(netlist)) {}

    std::string write();

  private:
    void write_ports(const std::vector<Port>& ports, char prefix, std::string_view shape);
    void write_cluster(const Module& module, std::size_t number);
    void write_edges();
    void write_driver(NetId net);

    const Netlist& netlist_;
    Table<NetId, CellId> drivers_;
    std::vector<std::uint32_t> input_of_;  ///< per net: the number of its input port
    std::string out_;
};

std::string DotWriter::write() {
    out_ += "digraph \"";
    append_quoted(out_, netlist_.name);
    out_ += "\" {\n  rankdir=LR;\n  node [fontname=\"Helvetica\", fontsize=10];\n";
    write_ports(netlist_.inputs, 'i', "cds");
    for (std::size_t i = 0; i < netlist_.modules.size(); ++i) write_cluster(netlist_.modules[i], i);
    write_ports(netlist_.outputs, 'o', "cds");
    write_edges();
    out_ += "}\n";
    return std::move(out_);
}

void DotWriter::write_ports(const std::vector<Port>& ports, char prefix, std::string_view shape) {
    for (std::size_t i = 0; i < ports.size(); ++i) {
        append(out_, "  ", prefix, i, " [shape=", shape, ", label=\"");
        append_quoted(out_, ports[i].name);
        out_ += "\"];\n";
    }
}

/// A module as a box around its cells. A label has the net, the type with its delays, and the
/// origin, a line each.
void DotWriter::write_cluster(const Module& module, std::size_t number) {
    append(out_, "  subgraph cluster", number, " {\n    label=\"");
    append_quoted(out_, module.comment.empty() ? module.name : module.comment);
    out_ += "\";\n";
    for (std::uint32_t i = 0; i < module.cell_count; ++i) {
        const std::uint32_t number_of_cell = module.first_cell + i;
        const Cell& cell = netlist_.cells.items()[number_of_cell];
        append(out_, "    c", number_of_cell, " [shape=", shape_of(cell.type), ", label=\"");
        append_quoted(out_, netlist_.names[cell.output]);
        append(out_, "\\n", row_of(cell.type).description.in(Language::english));
        if (row_of(cell.type).has_timing) {
            const Timing& timing = netlist_.timings[cell.timing];
            out_ += ' ';
            if (is_timer(cell.type)) append(out_, format_duration(timing.rise), ", ");
            out_ += format_duration(timing.fall);
        }
        const Origin& origin = netlist_.origin_of(cell);
        if (!origin.name.empty()) {
            append(out_, "\\n", kind_word(origin.kind));
            append_quoted(out_, origin.name);
        }
        out_ += "\"];\n";
    }
    out_ += "  }\n";
}

/// The node that drives a net: a cell, or else an input port.
void DotWriter::write_driver(NetId net) {
    if (drivers_[net] != no_cell) {
        append(out_, "  c", index_of(drivers_[net]));
    } else {
        append(out_, "  i", input_of_[index_of(net)]);
    }
}

void DotWriter::write_edges() {
    input_of_.resize(netlist_.net_count());
    for (std::uint32_t i = 0; i < netlist_.inputs.size(); ++i) {
        input_of_[index_of(netlist_.inputs[i].net)] = i;
    }
    for (std::size_t i = 0; i < netlist_.cells.size(); ++i) {
        for (const NetId pin : netlist_.pins_of(netlist_.cells.items()[i])) {
            write_driver(pin);
            append(out_, " -> c", i, ";\n");
        }
    }
    for (std::size_t i = 0; i < netlist_.outputs.size(); ++i) {
        write_driver(netlist_.outputs[i].net);
        append(out_, " -> o", i, ";\n");
    }
}

}  // namespace

std::string write_dot(const Netlist& netlist) {
    return DotWriter(netlist).write();
}

}  // namespace grafwire
