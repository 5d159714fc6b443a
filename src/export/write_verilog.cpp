// Structural Verilog: Verilog's own gate primitives, one a cell, and helper modules for what has a
// memory or knows of time.
//
// Up to 200 modules of the netlist stand in one Verilog module, to be read. Beyond that they are
// cut into blocks, a Verilog module each, since Icarus Verilog takes time that grows with the
// square of the number of signals in one scope: 20 000 phase modules compile in two seconds instead
// of twenty. (A Verilog module for each phase module within the blocks was tried: twice the text,
// no gain.)

#include "export/write_verilog.h"

#include <span>
#include <vector>

#include "export/append.h"
#include "export/helper_pins.h"
#include "export/net_spelling.h"
#include "export/verilog_blocks.h"
#include "export/verilog_helpers.h"
#include "export/verilog_names.h"

namespace grafwire {

namespace {

constexpr std::size_t modules_per_block = 200;

constexpr std::string_view bit_of(Logic value) {
    switch (value) {
        case Logic::zero:
            return "1'b0";
        case Logic::one:
            return "1'b1";
        case Logic::unknown:
            break;
    }
    return "1'bx";
}

class VerilogWriter {
  public:
    VerilogWriter(const Netlist& netlist, Time scan_period)
        : netlist_(netlist),
          nets_(netlist, spell_verilog),
          suffix_(cell_suffix(netlist)),
          helpers_(verilog_helper_prefix(netlist)),
          scan_parameter_(verilog_scan_parameter(netlist)),
          scan_period_(scan_period),
          delay_(netlist.is_clocked() ? " " : " #1 "),
          initial_(netlist.net_count(), Logic::unknown) {
        spell_verilog(name_, netlist.name);
        for (const Netlist::InitialValue& item : netlist.initial_values) {
            initial_[index_of(item.net)] = item.value ? Logic::one : Logic::zero;
        }
    }

    std::string write();

  private:
    void write_head();
    void write_changed_names();
    void write_port_list();
    void write_aliases();
    void write_flat();
    void write_in_blocks();
    std::vector<std::uint8_t> nets_of_output_ports() const;
    void write_instance(const VerilogBlock& block, std::size_t number);
    void write_block(const VerilogBlock& block, std::size_t number);
    void write_wires(const Module& module, const std::vector<std::uint8_t>& is_declared);
    void write_cells(const Module& module);
    void write_cell(const Cell& cell);
    void write_gate(std::string_view primitive, const Cell& cell);
    void write_helper(const Cell& cell);
    void write_parameters(const Cell& cell);
    void write_initial_values(std::span<const Module> modules);
    void write_block_name(std::size_t number);
    void write_scan_parameter(bool with_value);

    std::span<const Cell> cells_of(const Module& module) const {
        return {netlist_.cells.items().data() + module.first_cell, module.cell_count};
    }

    const Netlist& netlist_;
    NetSpelling nets_;
    std::string name_;
    std::string suffix_;
    std::string helpers_;
    std::string scan_parameter_;
    Time scan_period_;
    std::string_view delay_;
    std::vector<Logic> initial_;  ///< per net: Netlist::initial_values
    bool has_scan_timer_ = false;
    std::vector<std::uint8_t> declared_;  ///< per net: an output port of its block
    std::string out_;
};

std::string VerilogWriter::write() {
    for (const Cell& cell : netlist_.cells) {
        has_scan_timer_ |= counts_scans(cell.type);
    }
    out_.reserve(netlist_.cells.size() * 100);
    write_head();
    if (netlist_.modules.size() <= modules_per_block) {
        write_flat();
    } else {
        write_in_blocks();
    }
    append_verilog_helpers(out_, netlist_, helpers_);
    return std::move(out_);
}

void VerilogWriter::write_head() {
    out_ += "// ";
    append_comment(out_, netlist_.name);
    append(out_, ": ", netlist_.cells.size(), " cells.\n");
    write_changed_names();
    out_ += "`timescale 1ns/1ps\n";
    if (needs_verilog_start(netlist_)) append_verilog_start(out_);
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

void VerilogWriter::write_scan_parameter(bool with_value) {
    append(out_, " #(parameter [63:0] ", scan_parameter_, " = 64'd");
    append(out_, with_value ? scan_period_ : Time{1}, ")");
}

void VerilogWriter::write_port_list() {
    append(out_, "\nmodule ", name_);
    if (has_scan_timer_) write_scan_parameter(true);
    out_ += " (";
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
    out_ += "\n  // ";
    append_comment(out_, module.comment.empty() ? module.name : module.comment);
    out_ += '\n';
    for (const Cell& cell : cells_of(module)) write_cell(cell);
}

void VerilogWriter::write_gate(std::string_view primitive, const Cell& cell) {
    append(out_, "  ", primitive, delay_);
    append_verilog_with_suffix(out_, nets_[cell.output], suffix_);
    append(out_, " (", nets_[cell.output]);
    for (const NetId pin : netlist_.pins_of(cell)) append(out_, ", ", nets_[pin]);
    out_ += ");\n";
}

void VerilogWriter::write_cell(const Cell& cell) {
    // A Verilog gate has two inputs at least.
    const bool single = cell.pin_count == 1;
    switch (cell.type) {
        case CellType::low:
        case CellType::high:
            append(out_, "  assign ", nets_[cell.output],
                   cell.type == CellType::low ? " = 1'b0;\n" : " = 1'b1;\n");
            return;
        case CellType::buffer:
            return write_gate("buf", cell);
        case CellType::inverter:
            return write_gate("not", cell);
        case CellType::and_gate:
            return write_gate(single ? "buf" : "and", cell);
        case CellType::or_gate:
            return write_gate(single ? "buf" : "or", cell);
        case CellType::xor_gate:
            return write_gate(single ? "buf" : "xor", cell);
        case CellType::nand_gate:
            return write_gate(single ? "not" : "nand", cell);
        case CellType::nor_gate:
            return write_gate(single ? "not" : "nor", cell);
        case CellType::latch:
        case CellType::hold_latch:
        case CellType::rise_pulse:
        case CellType::fall_pulse:
        case CellType::timer:
        case CellType::flip_flop:
        case CellType::scan_timer:
        case CellType::scan_timer_next:
            return write_helper(cell);
    }
}

void VerilogWriter::write_parameters(const Cell& cell) {
    const CellTypeRow& row = row_of(cell.type);
    std::string_view separator = " #(";
    if (row.has_timing) {
        const Timing& timing = netlist_.timings[cell.timing];
        if (is_timer(cell.type)) {
            append(out_, separator, ".RISE_PS(64'd", timing.rise, "), .FALL_PS(64'd", timing.fall,
                   ")");
        } else {
            append(out_, separator, ".WIDTH_PS(64'd", timing.fall, ")");
        }
        separator = ", ";
    }
    if (counts_scans(cell.type)) append(out_, separator, ".SCAN_PS(", scan_parameter_, ")");
    if (row.has_memory) append(out_, separator, ".INIT(", bit_of(cell.initial), ")");
    out_ += ") ";
}

void VerilogWriter::write_helper(const Cell& cell) {
    append(out_, "  ", helpers_, row_of(cell.type).name);
    write_parameters(cell);
    append_verilog_with_suffix(out_, nets_[cell.output], suffix_);
    out_ += " (";
    std::uint32_t number = 0;
    for (const NetId pin : netlist_.pins_of(cell))
        append(out_, ".", helper_pin_name(cell.type, number++), "(", nets_[pin], "), ");
    append(out_, ".q(", nets_[cell.output], "));");
    if (row_of(cell.type).has_timing) {
        const Timing& timing = netlist_.timings[cell.timing];
        append(out_, "  // ");
        if (is_timer(cell.type)) append(out_, format_duration(timing.rise), ", ");
        append(out_, format_duration(timing.fall));
    }
    out_ += '\n';
}

void VerilogWriter::write_initial_values(std::span<const Module> modules) {
    std::vector<NetId> nets;
    for_each_cell(netlist_, modules, [&](const Cell& cell) {
        if (initial_[index_of(cell.output)] != Logic::unknown) nets.push_back(cell.output);
    });
    if (nets.empty()) return;
    out_ += "\n`ifndef SYNTHESIS\n  initial begin\n";
    for (const NetId net : nets) {
        append(out_, "    force ", nets_[net], " = ", bit_of(initial_[index_of(net)]), ";\n");
    }
    out_ += "    #(`GRAFWIRE_START);\n";
    for (const NetId net : nets) append(out_, "    release ", nets_[net], ";\n");
    out_ += "  end\n`endif\n";
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
    write_initial_values(netlist_.modules);
    out_ += "endmodule\n";
}

void VerilogWriter::write_block_name(std::size_t number) {
    std::string suffix = "$block";
    append(suffix, number + 1);
    append_verilog_with_suffix(out_, name_, suffix);
}

void VerilogWriter::write_instance(const VerilogBlock& block, std::size_t number) {
    out_ += "  ";
    write_block_name(number);
    if (block.has_scan_timer) append(out_, " #(.", scan_parameter_, "(", scan_parameter_, "))");
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

void VerilogWriter::write_block(const VerilogBlock& block, std::size_t number) {
    out_ += "\nmodule ";
    write_block_name(number);
    if (block.has_scan_timer) write_scan_parameter(false);
    out_ += " (";
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
    write_initial_values(block.modules);
    out_ += "endmodule\n";
}

void VerilogWriter::write_in_blocks() {
    declared_.resize(netlist_.net_count());
    const std::vector<VerilogBlock> blocks = cut_into_blocks(netlist_, modules_per_block);
    write_port_list();
    const std::vector<std::uint8_t> is_port = nets_of_output_ports();
    for (const VerilogBlock& block : blocks) {
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

std::string write_verilog(const Netlist& netlist, Time scan_period) {
    return VerilogWriter(netlist, scan_period).write();
}

}  // namespace grafwire
