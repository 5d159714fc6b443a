// The Verilog modules behind cells that no Verilog primitive covers. They tell unknown from known
// like the gates do, and a gate delay stands behind each.
//
// A test bench can set two moments: GRAFWIRE_START, before which the netlist is being initialised
// and memories keep their initial values, and GRAFWIRE_INSTANT, the moment of the last change of
// the inputs, from which delays count. A delay then ends exactly at the moment the reference
// evolution gives for it, not the few nanoseconds later that the gates before the timer have taken.

#include "formats/verilog/verilog_helpers.h"

#include <array>

#include "formats/shared/append.h"

namespace grafwire {

namespace {

struct Helper {
    CellType type;
    /// `%` stands for the prefix of the module names, `^` for the delay of the cell in picoseconds.
    std::string_view text;
};

constexpr std::array<Helper, 8> helpers{{
    {CellType::latch, R"(
// Latch: s sets, r resets, both at once set.
module %latch #(parameter INIT = 1'bx) (input s, input r, output q);
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
  assign #^ q = m;
endmodule
)"},
    {CellType::hold_latch, R"(
// Hold latch: follows d while e is 1.
module %hold #(parameter INIT = 1'bx) (input d, input e, output q);
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
  assign #^ q = m;
endmodule
)"},
    {CellType::rise_pulse, R"(
// Rising-edge pulse: 1 for WIDTH_PS after each rise of a, begun again by a new rise.
`ifdef SYNTHESIS
(* blackbox *)
`endif
module %rise_pulse #(parameter [63:0] WIDTH_PS = ^) (input a, output q);
`ifndef SYNTHESIS
  reg last;
  integer begun = 0, ended = 0;
  always @(a) begin
    if (last === 1'b0 && a === 1'b1) begin
      begun = begun + 1;
      ended <= #(WIDTH_PS) begun;
    end
    last = a;
  end
  assign #^ q = begun != ended;
`endif
endmodule
)"},
    {CellType::fall_pulse, R"(
// Falling-edge pulse: 1 for WIDTH_PS after each fall of a, begun again by a new fall.
`ifdef SYNTHESIS
(* blackbox *)
`endif
module %fall_pulse #(parameter [63:0] WIDTH_PS = ^) (input a, output q);
`ifndef SYNTHESIS
  reg last;
  integer begun = 0, ended = 0;
  always @(a) begin
    if (last === 1'b1 && a === 1'b0) begin
      begun = begun + 1;
      ended <= #(WIDTH_PS) begun;
    end
    last = a;
  end
  assign #^ q = begun != ended;
`endif
endmodule
)"},
    {CellType::timer, R"(
// Timer: follows a, RISE_PS after a rise and FALL_PS after a fall; a return of a before that starts
// the delay anew.
`ifdef SYNTHESIS
(* blackbox *)
`endif
module %timer #(parameter [63:0] RISE_PS = 0, FALL_PS = 0, parameter INIT = 1'b0) (input a, output q);
`ifndef SYNTHESIS
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
      end_time = delay == 0 ? $time + ^ : `GRAFWIRE_INSTANT + delay;
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

}  // namespace

void append_verilog_helpers(std::string& out, const Netlist& netlist, const DelayModel& delays,
                            std::string_view prefix) {
    bool any = false;
    for (const Helper& helper : helpers) {
        if (!has_cell(netlist, helper.type)) continue;
        if (!any) out += "\n`timescale 1ps/1ps\n";
        any = true;
        for (const char c : helper.text) {
            if (c == '%') {
                out += prefix;
            } else if (c == '^') {
                append(out, delays.of(helper.type));
            } else {
                out.push_back(c);
            }
        }
    }
}

bool needs_verilog_start(const Netlist& netlist) {
    return !netlist.initial_values.empty() || has_cell(netlist, CellType::timer) ||
           has_cell(netlist, CellType::latch) || has_cell(netlist, CellType::hold_latch);
}

void append_verilog_start(std::string& out, const DelayModel& delays) {
    // A hundred gate delays, in whole nanoseconds.
    const Time start = (100 * delays.gate + nanosecond - 1) / nanosecond;
    append(out, R"(
// When the netlist is let go after power-up, in ns, and the moment, in ps, from which a delay that
// begins now counts. A test bench may set these before.
`ifndef GRAFWIRE_START
`define GRAFWIRE_START )",
           start, R"(
`endif
`ifndef GRAFWIRE_INSTANT
`define GRAFWIRE_INSTANT $time
`endif
)");
}

}  // namespace grafwire
