// manipulator "Manipulateur en L" (manipulator.grafcet): 60 cells.
// Style rs, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist manipulator.grafcet --style rs --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $N         a gate of a condition of the owner
//   $buf       the owner, a gate delay later
//   $clear     of a transition: it is cleared; of a step: Init deactivates it
//   $forced    a forcing order activates the step
//   $init      Init activates the step
//   $not       the owner inverted
//   $q         the other gate of the latch
//   $resetN    resets the owner: term N of CDX, or write N
//   $riseN     rising edge of the owner, edge N of the chart
//   $setT      sets the owner: of a step, by transition T; of others, write T
//   $timerN    time condition N of the chart, counted from 0, of the owner
//   $unforced  a forcing order deactivates the step
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
  wire au$not, X0$set3, X0$init, X0$reset0, X0$q;
  wire dcy$rise0, X1$set0, X1$reset0, X1$q;
  wire X2$set1, X2$reset0, X2$q;
  wire X3$set2, X3$reset0, X3$q;
  wire X10$1, X13$timer0, X3$not, X13$buf, X10$1$not, X10$set13, X10$forced, X10$reset0, X10$unforced, X10$clear, X10$q;
  wire X10$buf, X11$set10, X11$reset0, X11$q;
  wire X11$buf, X12$set11, X12$reset0, X12$q;
  wire X12$buf, X13$set12, X13$reset0, X13$q;
  wire AUdoux$not;
  wire v0$buf;
  wire \Voyant%20CI$1 , \Voyant%20CI$2 , \Voyant%20CI$3 , \Voyant%20CI$4 , \Voyant%20CI$5 , AUdoux$not$buf;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);

  // X0 = (X3./au + /X1.X0 + Init)./AUdur
  not #GATE_NS au$not$g (au$not, au);
  nand #GATE_NS X0$set3$g (X0$set3, X3, au$not, AUdur$not);
  nand #GATE_NS X0$init$g (X0$init, Init, AUdur$not);
  not #GATE_NS X0$reset0$g (X0$reset0, X1);
  nand #GATE_NS X0$g (X0, X0$set3, X0$init, X0$q);
  nand #GATE_NS X0$q$g (X0$q, X0$reset0, AUdur$not, X0);

  // X1 = (X0.↑dcy./au + /X2.X1)./Init./AUdur
  grafwire_rise_pulse #(.GATE_NS(GATE_NS), .WIDTH_NS(2 * GATE_NS)) dcy$rise0$g (.a(dcy), .q(dcy$rise0));
  nand #GATE_NS X1$set0$g (X1$set0, X0, dcy$rise0, au$not, Init$not, AUdur$not);
  not #GATE_NS X1$reset0$g (X1$reset0, X2);
  nand #GATE_NS X1$g (X1, X1$set0, X1$q);
  nand #GATE_NS X1$q$g (X1$q, X1$reset0, Init$not, AUdur$not, X1);

  // X2 = (X1 + /X3.X2)./Init./AUdur
  nand #GATE_NS X2$set1$g (X2$set1, X1, Init$not, AUdur$not);
  not #GATE_NS X2$reset0$g (X2$reset0, X3);
  nand #GATE_NS X2$g (X2, X2$set1, X2$q);
  nand #GATE_NS X2$q$g (X2$q, X2$reset0, Init$not, AUdur$not, X2);

  // X3 = (X2.au + /X0.X3)./Init./AUdur
  nand #GATE_NS X3$set2$g (X3$set2, X2, au, Init$not, AUdur$not);
  not #GATE_NS X3$reset0$g (X3$reset0, X0);
  nand #GATE_NS X3$g (X3, X3$set2, X3$q);
  nand #GATE_NS X3$q$g (X3$q, X3$reset0, Init$not, AUdur$not, X3);

  // X10 = ((X13 . 5s/X13./X3 + /X11.X10)./Init./(X0 + X1) + X1)./AUdur
  or #GATE_NS X10$1$g (X10$1, X0, X1);
  grafwire_timer #(.GATE_NS(GATE_NS), .RISE_PS(64'd5000000000000), .FALL_PS(64'd0), .INIT(1'b0)) X13$timer0$g (.a(X13), .q(X13$timer0));  // 5s, 0s
  not #GATE_NS X3$not$g (X3$not, X3);
  buf #GATE_NS X13$buf$g (X13$buf, X13);
  not #GATE_NS X10$1$not$g (X10$1$not, X10$1);
  nand #GATE_NS X10$set13$g (X10$set13, X13$buf, X13$timer0, X3$not, Init$not, X10$1$not, AUdur$not);
  nand #GATE_NS X10$forced$g (X10$forced, X1, AUdur$not);
  not #GATE_NS X10$reset0$g (X10$reset0, X11);
  nand #GATE_NS X10$unforced$g (X10$unforced, X10$1, X10$forced);
  nand #GATE_NS X10$clear$g (X10$clear, Init, X10$forced);
  nand #GATE_NS X10$g (X10, X10$set13, X10$forced, X10$q);
  nand #GATE_NS X10$q$g (X10$q, X10$reset0, X10$unforced, X10$clear, AUdur$not, X10);

  // X11 = (X10.h1./X3 + /X12.X11)./Init./(X0 + X1)./AUdur
  buf #GATE_NS X10$buf$g (X10$buf, X10);
  nand #GATE_NS X11$set10$g (X11$set10, X10$buf, h1, X3$not, Init$not, X10$1$not, AUdur$not);
  not #GATE_NS X11$reset0$g (X11$reset0, X12);
  nand #GATE_NS X11$g (X11, X11$set10, X11$q);
  nand #GATE_NS X11$q$g (X11$q, X11$reset0, X10$1$not, Init$not, AUdur$not, X11);

  // X12 = (X11.v1./X3 + /X13.X12)./Init./(X0 + X1)./AUdur
  buf #GATE_NS X11$buf$g (X11$buf, X11);
  nand #GATE_NS X12$set11$g (X12$set11, X11$buf, v1, X3$not, Init$not, X10$1$not, AUdur$not);
  not #GATE_NS X12$reset0$g (X12$reset0, X13);
  nand #GATE_NS X12$g (X12, X12$set11, X12$q);
  nand #GATE_NS X12$q$g (X12$q, X12$reset0, X10$1$not, Init$not, AUdur$not, X12);

  // X13 = (X12.h0./X3 + /X10.X13)./Init./(X0 + X1)./AUdur
  buf #GATE_NS X12$buf$g (X12$buf, X12);
  nand #GATE_NS X13$set12$g (X13$set12, X12$buf, h0, X3$not, Init$not, X10$1$not, AUdur$not);
  not #GATE_NS X13$reset0$g (X13$reset0, X10);
  nand #GATE_NS X13$g (X13, X13$set12, X13$q);
  nand #GATE_NS X13$q$g (X13$q, X13$reset0, X10$1$not, Init$not, AUdur$not, X13);

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
