// A gate primitive has the delay of the model, none in a clocked netlist, whose gates only have to
// settle between two rises of the clock. Where gates start from a known value, their nets are
// forced to it until GRAFWIRE_START (verilog_helpers.cpp) and released then: a primitive has no
// initial value.

#include "formats/verilog/verilog_cells.h"

#include "formats/shared/append.h"
#include "formats/shared/blocks.h"
#include "formats/shared/helper_cells.h"
#include "formats/verilog/verilog_names.h"

namespace grafwire {

namespace {

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

}  // namespace

VerilogCells::VerilogCells(std::string& out, const Netlist& netlist, const NetSpelling& nets,
                           const DelayModel& delays)
    : out_(out),
      netlist_(netlist),
      nets_(nets),
      suffix_(cell_suffix(netlist)),
      helpers_(helper_prefix(netlist)),
      scan_parameter_(verilog_scan_parameter(netlist)),
      delays_(delays),
      initial_(netlist.net_count(), Logic::unknown) {
    for (const Netlist::InitialValue& item : netlist.initial_values) {
        initial_[index_of(item.net)] = logic_of(item.value);
    }
}

void VerilogCells::write(const Cell& cell) {
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

void VerilogCells::write_gate(std::string_view primitive, const Cell& cell) {
    append(out_, "  ", primitive, " ");
    if (!netlist_.is_clocked()) {
        append(out_, '#', format_nanoseconds(delays_.of(cell.type)), ' ');
    }
    append_verilog_with_suffix(out_, nets_[cell.output], suffix_);
    append(out_, " (", nets_[cell.output]);
    for (const NetId pin : netlist_.pins_of(cell)) append(out_, ", ", nets_[pin]);
    out_ += ");\n";
}

void VerilogCells::write_helper(const Cell& cell) {
    append(out_, "  ", helpers_, row_of(cell.type).name);
    write_parameters(cell);
    append_verilog_with_suffix(out_, nets_[cell.output], suffix_);
    out_ += " (";
    const auto pins = netlist_.pins_of(cell);
    const auto names = helper_pins(cell.type);
    for (std::size_t i = 0; i < pins.size(); ++i) {
        append(out_, ".", names[i], "(", nets_[pins[i]], "), ");
    }
    append(out_, ".q(", nets_[cell.output], "));");
    if (row_of(cell.type).has_timing) {
        const Timing& timing = netlist_.timings[cell.timing];
        append(out_, "  // ");
        if (is_timer(cell.type)) append(out_, format_duration(timing.rise), ", ");
        append(out_, format_duration(timing.fall));
    }
    out_ += '\n';
}

void VerilogCells::write_parameters(const Cell& cell) {
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

void VerilogCells::write_initial_values(std::span<const Module> modules) {
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

}  // namespace grafwire
