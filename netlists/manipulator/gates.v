// manipulator "Manipulateur en L" (manipulator.grafcet): 70 cells.
// Style gates, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist manipulator.grafcet --style gates --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $N             a gate of a condition of the owner
//   $buf           the owner, a gate delay later
//   $clear         of a transition: it is cleared; of a step: Init deactivates it
//   $free          no forcing order stands against it
//   $free_of_init  Init does not stand against it
//   $hold          keeps the owner as it is
//   $not           the owner inverted
//   $or            all that makes the step active, or keeps it so
//   $riseN         rising edge of the owner, edge N of the chart
//   $timerN        time condition N of the chart, counted from 0, of the owner
//   \Voyant%20CI = Voyant CI
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

module manipulator #(parameter GATE_NS = 1) (
  input v0,
  input v1,
  input h0,
  input h1,
  input dcy,
  input au,
  input Init,
  input AUdur,
  input AUdoux,
  output X0,
  output X1,
  output X2,
  output X3,
  output X10,
  output X11,
  output X12,
  output X13,
  output \V+ ,
  output \H- ,
  output \H+ ,
  output \Voyant%20CI 
);
  wire Init$not, AUdur$not;
  wire au$not, T3$clear, X1$not, X0$hold, AUdur$not$buf, AUdur$not$buf$buf, X0$or;
  wire dcy$rise0, T0$clear, X2$not, X1$hold, Init$not$buf, Init$not$buf$buf, X1$or;
  wire X3$not, X2$hold, X2$or;
  wire T2$clear, X0$not, X3$hold, X3$or;
  wire X10$1, X13$timer0, X13$buf, T13$clear, X11$not, X10$hold, X10$1$not, X1$buf, X1$buf$buf, X10$free, X10$free_of_init, X10$or;
  wire X10$buf, T10$clear, X12$not, X11$hold, X11$or;
  wire X11$buf, T11$clear, X13$not, X12$hold, X12$or;
  wire X12$buf, T12$clear, X10$not, X13$hold, X13$or;
  wire AUdoux$not;
  wire v0$buf;
  wire \Voyant%20CI$1 , \Voyant%20CI$2 , \Voyant%20CI$3 , \Voyant%20CI$4 , \Voyant%20CI$5 , AUdoux$not$buf;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);

  // X0 = (X3./au + /X1.X0 + Init)./AUdur
  not #GATE_NS au$not$g (au$not, au);
  and #GATE_NS T3$clear$g (T3$clear, X3, au$not);
  not #GATE_NS X1$not$g (X1$not, X1);
  and #GATE_NS X0$hold$g (X0$hold, X1$not, X0);
  buf #GATE_NS AUdur$not$buf$g (AUdur$not$buf, AUdur$not);
  buf #GATE_NS AUdur$not$buf$buf$g (AUdur$not$buf$buf, AUdur$not$buf);
  or #GATE_NS X0$or$g (X0$or, T3$clear, X0$hold, Init);
  and #GATE_NS X0$g (X0, X0$or, AUdur$not$buf$buf);

  // X1 = (X0.↑dcy./au + /X2.X1)./Init./AUdur
  grafwire_rise_pulse #(.GATE_NS(GATE_NS), .WIDTH_NS(3 * GATE_NS)) dcy$rise0$g (.a(dcy), .q(dcy$rise0));
  and #GATE_NS T0$clear$g (T0$clear, X0, dcy$rise0, au$not);
  not #GATE_NS X2$not$g (X2$not, X2);
  and #GATE_NS X1$hold$g (X1$hold, X2$not, X1);
  buf #GATE_NS Init$not$buf$g (Init$not$buf, Init$not);
  buf #GATE_NS Init$not$buf$buf$g (Init$not$buf$buf, Init$not$buf);
  or #GATE_NS X1$or$g (X1$or, T0$clear, X1$hold);
  and #GATE_NS X1$g (X1, X1$or, Init$not$buf$buf, AUdur$not$buf$buf);

  // X2 = (X1 + /X3.X2)./Init./AUdur
  not #GATE_NS X3$not$g (X3$not, X3);
  and #GATE_NS X2$hold$g (X2$hold, X3$not, X2);
  or #GATE_NS X2$or$g (X2$or, X1, X2$hold);
  and #GATE_NS X2$g (X2, X2$or, Init$not$buf, AUdur$not$buf);

  // X3 = (X2.au + /X0.X3)./Init./AUdur
  and #GATE_NS T2$clear$g (T2$clear, X2, au);
  not #GATE_NS X0$not$g (X0$not, X0);
  and #GATE_NS X3$hold$g (X3$hold, X0$not, X3);
  or #GATE_NS X3$or$g (X3$or, T2$clear, X3$hold);
  and #GATE_NS X3$g (X3, X3$or, Init$not$buf, AUdur$not$buf);

  // X10 = ((X13 . 5s/X13./X3 + /X11.X10)./Init./(X0 + X1) + X1)./AUdur
  or #GATE_NS X10$1$g (X10$1, X0, X1);
  grafwire_timer #(.GATE_NS(GATE_NS), .RISE_PS(64'd5000000000000), .FALL_PS(64'd0), .INIT(1'b0)) X13$timer0$g (.a(X13), .q(X13$timer0));  // 5s, 0s
  buf #GATE_NS X13$buf$g (X13$buf, X13);
  and #GATE_NS T13$clear$g (T13$clear, X13$buf, X13$timer0, X3$not);
  not #GATE_NS X11$not$g (X11$not, X11);
  and #GATE_NS X10$hold$g (X10$hold, X11$not, X10);
  not #GATE_NS X10$1$not$g (X10$1$not, X10$1);
  buf #GATE_NS X1$buf$g (X1$buf, X1);
  buf #GATE_NS X1$buf$buf$g (X1$buf$buf, X1$buf);
  or #GATE_NS X10$free$g (X10$free, X10$1$not, X1$buf$buf);
  or #GATE_NS X10$free_of_init$g (X10$free_of_init, Init$not$buf, X1$buf$buf);
  or #GATE_NS X10$or$g (X10$or, T13$clear, X10$hold, X1$buf$buf);
  and #GATE_NS X10$g (X10, X10$or, X10$free_of_init, X10$free, AUdur$not$buf);

  // X11 = (X10.h1./X3 + /X12.X11)./Init./(X0 + X1)./AUdur
  buf #GATE_NS X10$buf$g (X10$buf, X10);
  and #GATE_NS T10$clear$g (T10$clear, X10$buf, h1, X3$not);
  not #GATE_NS X12$not$g (X12$not, X12);
  and #GATE_NS X11$hold$g (X11$hold, X12$not, X11);
  or #GATE_NS X11$or$g (X11$or, T10$clear, X11$hold);
  and #GATE_NS X11$g (X11, X11$or, Init$not$buf, X10$1$not, AUdur$not$buf);

  // X12 = (X11.v1./X3 + /X13.X12)./Init./(X0 + X1)./AUdur
  buf #GATE_NS X11$buf$g (X11$buf, X11);
  and #GATE_NS T11$clear$g (T11$clear, X11$buf, v1, X3$not);
  not #GATE_NS X13$not$g (X13$not, X13);
  and #GATE_NS X12$hold$g (X12$hold, X13$not, X12);
  or #GATE_NS X12$or$g (X12$or, T11$clear, X12$hold);
  and #GATE_NS X12$g (X12, X12$or, Init$not$buf, X10$1$not, AUdur$not$buf);

  // X13 = (X12.h0./X3 + /X10.X13)./Init./(X0 + X1)./AUdur
  buf #GATE_NS X12$buf$g (X12$buf, X12);
  and #GATE_NS T12$clear$g (T12$clear, X12$buf, h0, X3$not);
  not #GATE_NS X10$not$g (X10$not, X10);
  and #GATE_NS X13$hold$g (X13$hold, X10$not, X13);
  or #GATE_NS X13$or$g (X13$or, T12$clear, X13$hold);
  and #GATE_NS X13$g (X13, X13$or, Init$not$buf, X10$1$not, AUdur$not$buf);

  // V+ = X11./AUdoux
  not #GATE_NS AUdoux$not$g (AUdoux$not, AUdoux);
  and #GATE_NS \V+$g  (\V+ , X11, AUdoux$not);

  // H- = X12.v0./AUdoux
  buf #GATE_NS v0$buf$g (v0$buf, v0);
  and #GATE_NS \H-$g  (\H- , X12, v0$buf, AUdoux$not);

  // H+ = X10./AUdoux
  and #GATE_NS \H+$g  (\H+ , X10, AUdoux$not);

  // Voyant CI = (X0.v0.h0 + X1.v0.h0 + X2.v0.h0 + X3.v0.h0)./AUdoux
  and #GATE_NS \Voyant%20CI$1$g  (\Voyant%20CI$1 , X0, v0, h0);
  and #GATE_NS \Voyant%20CI$2$g  (\Voyant%20CI$2 , X1, v0, h0);
  and #GATE_NS \Voyant%20CI$3$g  (\Voyant%20CI$3 , X2, v0, h0);
  and #GATE_NS \Voyant%20CI$4$g  (\Voyant%20CI$4 , X3, v0, h0);
  or #GATE_NS \Voyant%20CI$5$g  (\Voyant%20CI$5 , \Voyant%20CI$1 , \Voyant%20CI$2 , \Voyant%20CI$3 , \Voyant%20CI$4 );
  buf #GATE_NS AUdoux$not$buf$g (AUdoux$not$buf, AUdoux$not);
  and #GATE_NS \Voyant%20CI$g  (\Voyant%20CI , \Voyant%20CI$5 , AUdoux$not$buf);
endmodule

`timescale 1ps/1ps

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
