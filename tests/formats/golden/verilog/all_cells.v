// all_cells: 16 cells.
// GATE_NS is how long a gate takes, in ns. Pulses last several gate delays and grow with it.
`timescale 1ns/1ps

// When the netlist is let go after power-up, in ns, and the moment, in ps, from which a delay that
// begins now counts. A test bench may set these before.
`ifndef GRAFWIRE_START
`define GRAFWIRE_START (100 * GATE_NS)
`endif
`ifndef GRAFWIRE_INSTANT
`define GRAFWIRE_INSTANT $time
`endif

module all_cells #(parameter GATE_NS = 1) (
  input a,
  input b,
  input c,
  output zero,
  output one,
  output same,
  output not_a,
  output and3,
  output or3,
  output nand3,
  output nor3,
  output xor3,
  output kept,
  output held,
  output rose,
  output fell,
  output late
);
  wire and2, xor2;

  // gates
  assign zero = 1'b0;
  assign one = 1'b1;
  buf #GATE_NS same$g (same, a);
  not #GATE_NS not_a$g (not_a, a);
  and #GATE_NS and3$g (and3, a, b, c);
  or #GATE_NS or3$g (or3, a, b, c);
  nand #GATE_NS nand3$g (nand3, a, b, c);
  nor #GATE_NS nor3$g (nor3, a, b, c);
  xor #GATE_NS xor3$g (xor3, a, b, c);
  and #GATE_NS and2$g (and2, a, b);
  xor #GATE_NS xor2$g (xor2, a, b);

  // memories
  grafwire_latch #(.GATE_NS(GATE_NS), .INIT(1'b0)) kept$g (.s(rose), .r(fell), .q(kept));
  grafwire_hold #(.GATE_NS(GATE_NS), .INIT(1'b1)) held$g (.d(b), .e(c), .q(held));
  grafwire_rise_pulse #(.GATE_NS(GATE_NS), .WIDTH_NS(3 * GATE_NS)) rose$g (.a(a), .q(rose));
  grafwire_fall_pulse #(.GATE_NS(GATE_NS), .WIDTH_NS(5 * GATE_NS)) fell$g (.a(b), .q(fell));
  grafwire_timer #(.GATE_NS(GATE_NS), .RISE_PS(64'd20000000000), .FALL_PS(64'd1500000000), .INIT(1'b0)) late$g (.a(c), .q(late));  // 20ms, 1.5ms
endmodule

`timescale 1ps/1ps

// Latch: s sets, r resets, both at once set.
module grafwire_latch #(parameter GATE_NS = 1, INIT = 1'bx) (input s, input r, output q);
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
  assign #(1000 * GATE_NS) q = m;
endmodule

// Hold latch: follows d while e is 1.
module grafwire_hold #(parameter GATE_NS = 1, INIT = 1'bx) (input d, input e, output q);
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
  assign #(1000 * GATE_NS) q = m;
endmodule

// Rising-edge pulse: 1 for WIDTH_NS after each rise of a, begun again by a new rise.
`ifdef SYNTHESIS
(* blackbox *)
`endif
module grafwire_rise_pulse #(parameter GATE_NS = 1, WIDTH_NS = 1) (input a, output q);
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
  assign #(1000 * GATE_NS) q = begun != ended;
`endif
endmodule

// Falling-edge pulse: 1 for WIDTH_NS after each fall of a, begun again by a new fall.
`ifdef SYNTHESIS
(* blackbox *)
`endif
module grafwire_fall_pulse #(parameter GATE_NS = 1, WIDTH_NS = 1) (input a, output q);
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
  assign #(1000 * GATE_NS) q = begun != ended;
`endif
endmodule

// Timer: follows a, RISE_PS after a rise and FALL_PS after a fall; a return of a before that starts
// the delay anew.
`ifdef SYNTHESIS
(* blackbox *)
`endif
module grafwire_timer #(parameter GATE_NS = 1, parameter [63:0] RISE_PS = 0, FALL_PS = 0, parameter INIT = 1'b0)
    (input a, output q);
`ifndef SYNTHESIS
  localparam [63:0] GATE_PS = 1000 * GATE_NS;
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
