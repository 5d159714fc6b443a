// Structural Verilog: Verilog's own gate primitives, one a cell, and helper modules for what has a
// memory or knows of time.
//
// Up to 200 modules of the netlist stand in one Verilog module, to be read. Beyond that they are
// cut into blocks, a Verilog module each, since Icarus Verilog takes time that grows with the
// square of the number of signals in one scope: 20 000 phase modules compile in two seconds instead
// of twenty. (A Verilog module for each phase module within the blocks was tried: twice the text,
// no gain.)

#include "formats/verilog/write_verilog.h"

#include <algorithm>
#include <span>
#include <vector>

#include "formats/shared/append.h"
#include "formats/shared/helper_cells.h"
#include "formats/shared/net_spelling.h"
#include "formats/verilog/verilog_cells.h"
#include "formats/verilog/verilog_names.h"

namespace grafwire {

namespace {

constexpr std::size_t usual_modules_per_block = 200;

/// Some consecutive modules of a netlist, and the nets between them and the rest: for tools that
/// are slow on one long module.
struct NetlistBlock {
    std::span<const Module> modules;
    std::vector<NetId> inputs;   ///< read here, driven elsewhere, in the order of first use
    std::vector<NetId> outputs;  ///< driven here, read elsewhere or an output of the netlist
    bool has_scan_timer = false;
};

/// The netlist in blocks of at most so many modules each.
/// In three passes over the cells: which block drives a net, which others read it, and what of each
/// block is therefore seen outside. The cost is linear in the number of pins.
std::vector<NetlistBlock> cut_into_blocks(const Netlist& netlist, std::size_t modules_per_block) {
    constexpr std::uint32_t no_block = 0xffffffffU;
    std::vector<NetlistBlock> blocks;
    std::vector<std::uint32_t> driver(netlist.net_count(), no_block);
    const std::span<const Module> all = netlist.modules;
    for (std::size_t first = 0; first < all.size(); first += modules_per_block) {
        const std::size_t count = std::min(modules_per_block, all.size() - first);
        const auto number = static_cast<std::uint32_t>(blocks.size());
        NetlistBlock block{all.subspan(first, count), {}, {}, false};
        for_each_cell(netlist, block.modules, [&](const Cell& cell) {
            driver[index_of(cell.output)] = number;
            block.has_scan_timer |= counts_scans(cell.type);
        });
        blocks.push_back(std::move(block));
    }
    // Block after block, so the last block that was found to read a net is all there is to
    // remember.
    std::vector<std::uint32_t> reader(netlist.net_count(), no_block);
    std::vector<std::uint8_t> leaves(netlist.net_count());
    for (std::uint32_t number = 0; number < blocks.size(); ++number) {
        for_each_cell(netlist, blocks[number].modules, [&](const Cell& cell) {
            for (const NetId pin : netlist.pins_of(cell)) {
                const std::size_t net = index_of(pin);
                if (driver[net] == number || reader[net] == number) continue;
                reader[net] = number;
                leaves[net] = 1;
                blocks[number].inputs.push_back(pin);
            }
        });
    }
    for (const Port& port : netlist.outputs) leaves[index_of(port.net)] = 1;
    for (NetlistBlock& block : blocks) {
        for_each_cell(netlist, block.modules, [&](const Cell& cell) {
            if (leaves[index_of(cell.output)] != 0) block.outputs.push_back(cell.output);
        });
    }
    return blocks;
}

/// The file: head, top module, blocks if there are many modules, helper modules.
class VerilogWriter {
  public:
    VerilogWriter(const Netlist& netlist, Time scan_period, const DelayModel& delays)
        : netlist_(netlist),
          nets_(netlist, spell_verilog),
          suffix_(cell_suffix(netlist)),
          helpers_(helper_prefix(netlist)),
          scan_parameter_(verilog_scan_parameter(netlist)),
          gate_parameter_(verilog_gate_parameter(netlist)),
          scan_period_(scan_period),
          delays_(delays),
          cells_(out_, netlist, nets_, delays) {
        spell_verilog(name_, netlist.name);
    }

    std::string write();

  private:
    void reserve();
    void write_head();
    void write_changed_names();
    void write_port_list();
    void write_aliases();
    void write_flat();
    void write_in_blocks();
    std::vector<std::uint8_t> nets_of_output_ports() const;
    void write_forwarded_parameters(bool has_scan_timer);
    void write_instance(const NetlistBlock& block, std::size_t number);
    void write_block(const NetlistBlock& block, std::size_t number);
    void write_wires(const Module& module, const std::vector<std::uint8_t>& is_declared);
    void write_cells(const Module& module);
    void write_block_name(std::size_t number);
    void write_parameters(bool has_scan_timer, bool with_values);

    std::span<const Cell> cells_of(const Module& module) const {
        return {netlist_.cells.items().data() + module.first_cell, module.cell_count};
    }

    const Netlist& netlist_;
    NetSpelling nets_;
    std::string name_;
    std::string suffix_;
    std::string helpers_;
    std::string scan_parameter_;
    std::string gate_parameter_;
    Time scan_period_;
    const DelayModel& delays_;
    bool has_scan_timer_ = false;
    bool has_delays_ = false;
    std::vector<std::uint8_t> declared_;  ///< per net: an output port of its block
    std::string out_;
    VerilogCells cells_;
};

std::string VerilogWriter::write() {
    for (const Cell& cell : netlist_.cells) {
        has_scan_timer_ |= counts_scans(cell.type);
    }
    has_delays_ = has_verilog_delays(netlist_);
    reserve();
    write_head();
    if (netlist_.modules.size() <= usual_modules_per_block) {
        write_flat();
    } else {
        write_in_blocks();
    }
    append_verilog_helpers(out_, netlist_, delays_, helpers_);
    return std::move(out_);
}

/// Makes room for about the whole text, so that it need not be moved as it grows. Room that stays
/// empty is never touched and costs no memory.
void VerilogWriter::reserve() {
    constexpr std::size_t words_of_cell = 40;
    constexpr std::size_t words_of_port = 30;
    const std::size_t nets = std::max<std::size_t>(netlist_.net_count(), 1);
    const std::size_t name = nets_.length() / nets + 2;
    // A cell is declared, named and driven, and reads its pins; ports go by way of a block.
    const std::size_t cells = netlist_.cells.size() * (3 * name + words_of_cell);
    const std::size_t pins = netlist_.pins.size() * name;
    const std::size_t ports = netlist_.outputs.size() * (6 * name + words_of_port);
    std::size_t comments = 0;
    for (const Module& module : netlist_.modules) comments += module.comment.size() + name;
    out_.reserve(cells + pins + ports + comments);
}

void VerilogWriter::write_head() {
    write_changed_names();
    if (has_delays_) {
        append(out_, "// ", gate_parameter_,
               " is how long a gate takes, in ns. Pulses last several gate delays and grow with "
               "it.\n");
    }
    out_ += "`timescale 1ns/1ps\n";
    if (needs_verilog_start(netlist_)) append_verilog_start(out_, gate_parameter_);
}

/// Lists the ports that even an escaped identifier cannot spell as they are.
void VerilogWriter::write_changed_names() {
    std::string spelled;
    const auto list = [&](const std::vector<Port>& ports) {
        for (const Port& port : ports) {
            spelled.clear();
            spell_verilog(spelled, port.name);
            if (spelled.find('%') == std::string::npos) continue;
            append(out_, "//   ", spelled, "= ");
            append_comment(out_, port.name);
            out_ += '\n';
        }
    };
    list(netlist_.inputs);
    list(netlist_.outputs);
}

/// The parameters of the top module or, without their values, of a block.
void VerilogWriter::write_parameters(bool has_scan_timer, bool with_values) {
    std::string_view separator = " #(parameter ";
    if (has_delays_) {
        append(out_, separator, gate_parameter_, " = ",
               with_values ? format_nanoseconds(delays_.gate.max) : "1");
        separator = ", parameter ";
    }
    if (has_scan_timer) {
        append(out_, separator, "[63:0] ", scan_parameter_, " = 64'd",
               with_values ? scan_period_ : Time{1});
        separator = ", ";
    }
    out_ += has_delays_ || has_scan_timer ? ") (" : " (";
}

void VerilogWriter::write_port_list() {
    append(out_, "\nmodule ", name_);
    write_parameters(has_scan_timer_, true);
    std::string_view separator = "\n";
    for (const Port& port : netlist_.inputs) {
        append(out_, separator, "  input ");
        spell_verilog(out_, port.name);
        separator = ",\n";
    }
    for (const Port& port : netlist_.outputs) {
        append(out_, separator, "  output ");
        spell_verilog(out_, port.name);
        separator = ",\n";
    }
    out_ += "\n);\n";
}

/// An output port that shares its net with another port, or whose net has a name of its own.
void VerilogWriter::write_aliases() {
    std::string port_name;
    for (const Port& port : netlist_.outputs) {
        port_name.clear();
        spell_verilog(port_name, port.name);
        if (port_name != nets_[port.net]) {
            append(out_, "  assign ", port_name, " = ", nets_[port.net], ";\n");
        }
    }
}

/// Nets that no list of ports declares, a line for each module.
void VerilogWriter::write_wires(const Module& module,
                                const std::vector<std::uint8_t>& is_declared) {
    std::string_view separator = "  wire ";
    for (const Cell& cell : cells_of(module)) {
        if (is_declared[index_of(cell.output)] != 0) continue;
        append(out_, separator, nets_[cell.output]);
        separator = ", ";
    }
    if (separator == ", ") out_ += ";\n";
}

void VerilogWriter::write_cells(const Module& module) {
    out_ += "\n  ";
    append_verilog_comment(out_, module.comment.empty() ? module.name : module.comment);
    for (const Cell& cell : cells_of(module)) cells_.write(cell);
}

/// The nets that the list of ports declares.
std::vector<std::uint8_t> VerilogWriter::nets_of_output_ports() const {
    std::vector<std::uint8_t> is_port(netlist_.net_count());
    std::string port_name;
    for (const Port& port : netlist_.outputs) {
        port_name.clear();
        spell_verilog(port_name, port.name);
        if (port_name == nets_[port.net]) is_port[index_of(port.net)] = 1;
    }
    return is_port;
}

void VerilogWriter::write_flat() {
    write_port_list();
    const std::vector<std::uint8_t> is_port = nets_of_output_ports();
    for (const Module& module : netlist_.modules) write_wires(module, is_port);
    write_aliases();
    for (const Module& module : netlist_.modules) write_cells(module);
    cells_.write_initial_values(netlist_.modules);
    out_ += "endmodule\n";
}

void VerilogWriter::write_block_name(std::size_t number) {
    std::string suffix = "$block";
    append(suffix, number + 1);
    append_verilog_with_suffix(out_, name_, suffix);
}

/// A block has the parameters of the top module.
void VerilogWriter::write_forwarded_parameters(bool has_scan_timer) {
    std::string_view separator = " #(.";
    const auto forward = [&](const std::string& parameter) {
        append(out_, separator, parameter, '(', parameter, ')');
        separator = ", .";
    };
    if (has_delays_) forward(gate_parameter_);
    if (has_scan_timer) forward(scan_parameter_);
    if (has_delays_ || has_scan_timer) out_ += ')';
}

void VerilogWriter::write_instance(const NetlistBlock& block, std::size_t number) {
    out_ += "  ";
    write_block_name(number);
    write_forwarded_parameters(block.has_scan_timer);
    append(out_, " block", number + 1, suffix_, " (");
    std::string_view separator = "\n    ";
    const auto connect = [&](NetId net) {
        append(out_, separator, ".", nets_[net], "(", nets_[net], ")");
        separator = ",\n    ";
    };
    for (const NetId net : block.inputs) connect(net);
    for (const NetId net : block.outputs) connect(net);
    out_ += ");\n";
}

/// A Verilog module for some modules of the netlist; what crosses its border is a port.
void VerilogWriter::write_block(const NetlistBlock& block, std::size_t number) {
    out_ += "\nmodule ";
    write_block_name(number);
    write_parameters(block.has_scan_timer, false);
    std::string_view separator = "\n";
    for (const NetId net : block.inputs) {
        append(out_, separator, "  input ", nets_[net]);
        separator = ",\n";
    }
    for (const NetId net : block.outputs) {
        append(out_, separator, "  output ", nets_[net]);
        separator = ",\n";
        declared_[index_of(net)] = 1;
    }
    out_ += "\n);\n";
    for (const Module& module : block.modules) write_wires(module, declared_);
    for (const Module& module : block.modules) write_cells(module);
    cells_.write_initial_values(block.modules);
    out_ += "endmodule\n";
}

/// The top module instantiates the blocks and has no cells of its own.
void VerilogWriter::write_in_blocks() {
    declared_.resize(netlist_.net_count());
    const std::vector<NetlistBlock> blocks = cut_into_blocks(netlist_, usual_modules_per_block);
    write_port_list();
    const std::vector<std::uint8_t> is_port = nets_of_output_ports();
    for (const NetlistBlock& block : blocks) {
        for (const NetId net : block.outputs) {
            if (is_port[index_of(net)] == 0) append(out_, "  wire ", nets_[net], ";\n");
        }
    }
    write_aliases();
    for (std::size_t i = 0; i < blocks.size(); ++i) write_instance(blocks[i], i);
    out_ += "endmodule\n";
    for (std::size_t i = 0; i < blocks.size(); ++i) write_block(blocks[i], i);
}

}  // namespace

std::string write_verilog(const Netlist& netlist, Time scan_period, const DelayModel& delays) {
    return VerilogWriter(netlist, scan_period, delays).write();
}

}  // namespace grafwire
