// Delays are multiples of one parameter, GATE_NS, by default what the delay model says: with gates
// that take longer, pulses last longer too, and are still long enough to set a step. The gates of
// a clocked netlist have no delay: they only have to settle between two rises of the clock.
//
// Where gates start from a known value, their nets are forced to it until GRAFWIRE_START and
// released then: a primitive has no initial value.
//
// The Verilog modules behind cells that no Verilog primitive covers. They tell unknown from known
// like the gates do, and a gate delay stands behind each.
//
// A test bench can set two moments: GRAFWIRE_START, before which the netlist is being initialised
// and memories keep their initial values, and GRAFWIRE_INSTANT, the moment of the last change of
// the inputs, from which delays count. A delay then ends exactly at the moment the reference
// evolution gives for it, not the few nanoseconds later that the gates before the timer have taken.

#include "formats/verilog/verilog_cells.h"

#include <algorithm>
#include <array>

#include "formats/shared/append.h"
#include "formats/shared/gate_delays.h"
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

/// Whether a helper module has a gate delay.
bool has_delay(CellType type) {
    const CellTypeRow& row = row_of(type);
    return (row.has_memory || row.has_timing) && !row.is_clocked;
}

}  // namespace

bool has_verilog_delays(const Netlist& netlist) {
    const auto has = [](const Cell& cell) { return has_delay(cell.type); };
    const auto& cells = netlist.cells.items();
    return !netlist.is_clocked() || std::any_of(cells.begin(), cells.end(), has);
}

VerilogCells::VerilogCells(std::string& out, const Netlist& netlist, const NetSpelling& nets,
                           const DelayModel& delays)
    : out_(out),
      netlist_(netlist),
      nets_(nets),
      suffix_(cell_suffix(netlist)),
      helpers_(helper_prefix(netlist)),
      scan_parameter_(verilog_scan_parameter(netlist)),
      gate_parameter_(verilog_gate_parameter(netlist)),
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
        const std::string delay = in_gate_delays(delays_.of(cell.type), delays_, gate_parameter_);
        const bool is_simple = delay == gate_parameter_;
        append(out_, is_simple ? "#" : "#(", delay, is_simple ? " " : ") ");
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
    if (is_timer(cell.type)) {
        const Timing& timing = netlist_.timings[cell.timing];
        append(out_, "  // ", format_duration(timing.rise), ", ", format_duration(timing.fall));
    }
    out_ += '\n';
}

void VerilogCells::write_parameters(const Cell& cell) {
    const CellTypeRow& row = row_of(cell.type);
    std::string_view separator = " #(";
    if (has_delay(cell.type)) {
        append(out_, separator, '.', gate_parameter_, '(', gate_parameter_, ')');
        separator = ", ";
    }
    if (row.has_timing) {
        const Timing& timing = netlist_.timings[cell.timing];
        if (is_timer(cell.type)) {
            append(out_, separator, ".RISE_PS(64'd", timing.rise, "), .FALL_PS(64'd", timing.fall,
                   ")");
        } else {
            append(out_, separator, ".WIDTH_NS(",
                   in_gate_delays(timing.fall, delays_, gate_parameter_), ")");
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

// Helper modules.

namespace {

/// A helper module, as it stands in the file.
struct Helper {
    CellType type;
    /// `%` stands for the prefix of the module names, `^` for the delay of the cell in picoseconds,
    /// GATE_NS for the parameter, whatever it is called in this file.
    std::string_view text;
};

constexpr std::array<Helper, 8> helpers{{
    {CellType::latch, R"(
// Latch: s sets, r resets, both at once set.
module %latch #(parameter GATE_NS = 1, INIT = 1'bx) (input s, input r, output q);
  reg m;
`ifdef SYNTHESIS
  initial m = INIT;
  always @(s or r) if (s) m = 1'b1; else if (r) m = 1'b0;
`else
  reg started;
  initial begin
    m = INIT; started = 0;
    #(64'd1000 * `GRAFWIRE_START) started = 1;
  end
  always @(s or r or started) if (started) m = s | (~r & m);
`endif
  assign #(^) q = m;
endmodule
)"},
    {CellType::hold_latch, R"(
// Hold latch: follows d while e is 1.
module %hold #(parameter GATE_NS = 1, INIT = 1'bx) (input d, input e, output q);
  reg m;
`ifdef SYNTHESIS
  initial m = INIT;
  always @(d or e) if (e) m = d;
`else
  reg started;
  initial begin
    m = INIT; started = 0;
    #(64'd1000 * `GRAFWIRE_START) started = 1;
  end
  always @(d or e or started) if (started) m = e ? d : m;
`endif
  assign #(^) q = m;
endmodule
)"},
    {CellType::rise_pulse, R"(
// Rising-edge pulse: 1 for WIDTH_NS after each rise of a, begun again by a new rise.
`ifdef SYNTHESIS
(* blackbox *)
`endif
module %rise_pulse #(parameter GATE_NS = 1, WIDTH_NS = 1) (input a, output q);
`ifndef SYNTHESIS
  reg last;
  integer begun = 0, ended = 0;
  always @(a) begin
    if (last === 1'b0 && a === 1'b1) begin
      begun = begun + 1;
      ended <= #(1000 * WIDTH_NS) begun;
    end
    last = a;
  end
  assign #(^) q = begun != ended;
`endif
endmodule
)"},
    {CellType::fall_pulse, R"(
// Falling-edge pulse: 1 for WIDTH_NS after each fall of a, begun again by a new fall.
`ifdef SYNTHESIS
(* blackbox *)
`endif
module %fall_pulse #(parameter GATE_NS = 1, WIDTH_NS = 1) (input a, output q);
`ifndef SYNTHESIS
  reg last;
  integer begun = 0, ended = 0;
  always @(a) begin
    if (last === 1'b1 && a === 1'b0) begin
      begun = begun + 1;
      ended <= #(1000 * WIDTH_NS) begun;
    end
    last = a;
  end
  assign #(^) q = begun != ended;
`endif
endmodule
)"},
    {CellType::timer, R"(
// Timer: follows a, RISE_PS after a rise and FALL_PS after a fall; a return of a before that starts
// the delay anew.
`ifdef SYNTHESIS
(* blackbox *)
`endif
module %timer #(parameter GATE_NS = 1, parameter [63:0] RISE_PS = 0, FALL_PS = 0, parameter INIT = 1'b0)
    (input a, output q);
`ifndef SYNTHESIS
  localparam [63:0] GATE_PS = ^;
  reg m, started, waiting, target;
  integer begun, due;
  reg [63:0] delay, end_time;
  initial begin
    m = INIT; started = 0; waiting = 0; begun = 0; due = -1;
    #(64'd1000 * `GRAFWIRE_START) started = 1;
  end
  always @(a or started) if (started) begin
    // A delay that ends at the very moment at which a changes has ended.
    if (waiting && end_time == $time) m = target;
    waiting = a !== m;
    if (waiting) begin
      begun = begun + 1;
      target = a;
      delay = a ? RISE_PS : FALL_PS;
      end_time = delay == 0 ? $time + GATE_PS : `GRAFWIRE_INSTANT + delay;
      due <= #(end_time > $time ? end_time - $time : 64'd0) begun;
    end
  end
  always @(due) if (waiting && due == begun) begin
    m = target;
    waiting = 0;
  end
  assign q = m;
`endif
endmodule
)"},
    {CellType::flip_flop, R"(
// D flip-flop.
module %dff #(parameter INIT = 1'bx) (input d, input c, output reg q);
  initial q = INIT;
  always @(posedge c) q <= d;
endmodule
)"},
    {CellType::scan_timer, R"(
// Clocked timer: looks at a at each rise of the clock and follows it after so many cycles as make up
// RISE_PS or FALL_PS.
module %scan_timer #(parameter [63:0] RISE_PS = 0, FALL_PS = 0, SCAN_PS = 1, parameter INIT = 1'b0)
    (input a, input c, output reg q);
  localparam [63:0] RISE = (RISE_PS + SCAN_PS - 1) / SCAN_PS;
  localparam [63:0] FALL = (FALL_PS + SCAN_PS - 1) / SCAN_PS;
  localparam [63:0] LONGEST = RISE > FALL ? RISE : FALL;
  localparam WIDTH = $clog2(LONGEST + 1) + 1;
  reg [WIDTH-1:0] elapsed;
  initial begin q = INIT; elapsed = 0; end
  always @(posedge c)
    if (a == q) elapsed <= 0;
    else if (elapsed >= (a ? RISE[WIDTH-1:0] : FALL[WIDTH-1:0])) begin q <= a; elapsed <= 0; end
    else elapsed <= elapsed + 1'b1;
endmodule
)"},
    {CellType::scan_timer_next, R"(
// Look-ahead of a clocked timer of operand a and output h: what it is to show after this cycle.
module %scan_timer_next #(parameter [63:0] RISE_PS = 0, FALL_PS = 0, SCAN_PS = 1)
    (input a, input h, input c, output q);
  localparam [63:0] RISE = (RISE_PS + SCAN_PS - 1) / SCAN_PS;
  localparam [63:0] FALL = (FALL_PS + SCAN_PS - 1) / SCAN_PS;
  localparam [63:0] LONGEST = RISE > FALL ? RISE : FALL;
  localparam WIDTH = $clog2(LONGEST + 1) + 1;
  reg [WIDTH-1:0] elapsed;
  initial elapsed = 0;
  assign q = elapsed >= (a ? RISE[WIDTH-1:0] : FALL[WIDTH-1:0]) ? a : h;
  always @(posedge c)
    if (a == h || q == a) elapsed <= 0;
    else elapsed <= elapsed + 1'b1;
endmodule
)"},
}};

bool has_cell(const Netlist& netlist, CellType type) {
    for (const Cell& cell : netlist.cells) {
        if (cell.type == type) return true;
    }
    return false;
}

void replace_all(std::string& text, std::string_view word, std::string_view by) {
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += by.size()) {
        text.replace(at, word.size(), by);
    }
}

}  // namespace

void append_verilog_helpers(std::string& out, const Netlist& netlist, const DelayModel& delays,
                            std::string_view prefix) {
    const std::string gate_parameter = verilog_gate_parameter(netlist);
    bool any = false;
    for (const Helper& helper : helpers) {
        if (!has_cell(netlist, helper.type)) continue;
        if (!any) out += "\n`timescale 1ps/1ps\n";
        any = true;
        std::string text(helper.text);
        replace_all(text, "%", prefix);
        replace_all(text, "^",
                    "1000 * " + in_gate_delays(delays.of(helper.type), delays, "GATE_NS"));
        replace_all(text, "GATE_NS", gate_parameter);
        out += text;
    }
}

bool needs_verilog_start(const Netlist& netlist) {
    return !netlist.initial_values.empty() || has_cell(netlist, CellType::timer) ||
           has_cell(netlist, CellType::latch) || has_cell(netlist, CellType::hold_latch);
}

void append_verilog_start(std::string& out, std::string_view gate_parameter) {
    append(out, R"(
// When the netlist is let go after power-up, in ns, and the moment, in ps, from which a delay that
// begins now counts. A test bench may set these before.
`ifndef GRAFWIRE_START
`define GRAFWIRE_START (100 * )",
           gate_parameter, R"()
`endif
`ifndef GRAFWIRE_INSTANT
`define GRAFWIRE_INSTANT $time
`endif
)");
}

}  // namespace grafwire
