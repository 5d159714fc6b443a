// all_cells: 16 cells.
`timescale 1ns/1ps

// When the netlist is let go after power-up, in ns, and the moment, in ps, from which a delay that
// begins now counts. A test bench may set these before.
`ifndef GRAFWIRE_START
`define GRAFWIRE_START 100
`endif
`ifndef GRAFWIRE_INSTANT
`define GRAFWIRE_INSTANT $time
`endif

module all_cells (
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
  buf #1 same$g (same, a);
  not #1 not_a$g (not_a, a);
  and #1 and3$g (and3, a, b, c);
  or #1 or3$g (or3, a, b, c);
  nand #1 nand3$g (nand3, a, b, c);
  nor #1 nor3$g (nor3, a, b, c);
  xor #1 xor3$g (xor3, a, b, c);
  and #1 and2$g (and2, a, b);
  xor #1 xor2$g (xor2, a, b);

  // memories
  grafwire_latch #(.INIT(1'b0)) kept$g (.s(rose), .r(fell), .q(kept));
  grafwire_hold #(.INIT(1'b1)) held$g (.d(b), .e(c), .q(held));
  grafwire_rise_pulse #(.WIDTH_PS(64'd3000)) rose$g (.a(a), .q(rose));  // 0.003us
  grafwire_fall_pulse #(.WIDTH_PS(64'd5000)) fell$g (.a(b), .q(fell));  // 0.005us
  grafwire_timer #(.RISE_PS(64'd20000000000), .FALL_PS(64'd1500000000), .INIT(1'b0)) late$g (.a(c), .q(late));  // 20ms, 1.5ms
endmodule

`timescale 1ps/1ps

// Latch: s sets, r resets, both at once set.
module grafwire_latch #(parameter INIT = 1'bx) (input s, input r, output q);
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
  assign #1000 q = m;
endmodule

// Hold latch: follows d while e is 1.
module grafwire_hold #(parameter INIT = 1'bx) (input d, input e, output q);
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
  assign #1000 q = m;
endmodule

// Rising-edge pulse: 1 for WIDTH_PS after each rise of a, begun again by a new rise.
`ifdef SYNTHESIS
(* blackbox *)
`endif
module grafwire_rise_pulse #(parameter [63:0] WIDTH_PS = 1000) (input a, output q);
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
  assign #1000 q = begun != ended;
`endif
endmodule

// Falling-edge pulse: 1 for WIDTH_PS after each fall of a, begun again by a new fall.
`ifdef SYNTHESIS
(* blackbox *)
`endif
module grafwire_fall_pulse #(parameter [63:0] WIDTH_PS = 1000) (input a, output q);
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
  assign #1000 q = begun != ended;
`endif
endmodule

// Timer: follows a, RISE_PS after a rise and FALL_PS after a fall; a return of a before that starts
// the delay anew.
`ifdef SYNTHESIS
(* blackbox *)
`endif
module grafwire_timer #(parameter [63:0] RISE_PS = 0, FALL_PS = 0, parameter INIT = 1'b0) (input a, output q);
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
      end_time = delay == 0 ? $time + 1000 : `GRAFWIRE_INSTANT + delay;
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
