// manipulator "Manipulateur en L" (manipulator.grafcet): 68 cells.
// Style handshake, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist manipulator.grafcet --style handshake --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $N        a gate of a condition of the owner
//   $arm      takes a part of a step to the other: the level before the edge was seen
//   $armed    the step, or the source, once the level before the edge was seen
//   $back     the owner inverted
//   $disarm   takes a part of a step back: the edge came and cleared nothing
//   $give     0 while what follows is being set
//   $not      the owner inverted
//   $offN     0 while an order of the step switches a step off
//   $onN      0 while an order of the step switches a step on
//   $q        the other gate of the latch
//   $start    0 while the initial situation is set up
//   $timerN   time condition N of the chart, counted from 0, of the owner
//   $unarmed  the step, as long as the level before the edge was not seen
//   $via      a hidden step between the two halves of the transition
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
  wire AUdur$not, Init$start, dcy$not, dcy$not$back, au$not, au$not$back;
  wire T3$give, T0$arm$give, T0$disarm$give, T0$arm$via$give, X0$unarmed$off0, X0$unarmed$off1, X0$unarmed$off2, X0$unarmed$off3, X0$armed$off4, X0$armed$off5, X0$armed$off6, X0$armed$off7, X0$unarmed, X0$unarmed$q, X0$armed, X0$armed$q, T0$arm$via, T0$arm$via$q, X0$unarmed$not, T0$arm$via$not, X0$armed$not;
  wire T0$give, X1$off8, X1$off9, X1$off10, X1$on11, X1$q;
  wire T1$give, X2$q;
  wire T2$give, X3$q;
  wire X13$timer0, T13$give, X10$q;
  wire T10$give, X11$q;
  wire T11$give, X12$q;
  wire T12$give, X13$q;
  wire AUdoux$not, \V+$1 ;
  wire \H-$1 ;
  wire \H+$1 ;
  wire \Voyant%20CI$1 , \Voyant%20CI$2 , \Voyant%20CI$3 , \Voyant%20CI$4 , \Voyant%20CI$5 , \Voyant%20CI$6 ;

  // inputs
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);
  nand #GATE_NS Init$start$g (Init$start, Init, AUdur$not);
  not #GATE_NS dcy$not$g (dcy$not, dcy);
  not #GATE_NS dcy$not$back$g (dcy$not$back, dcy$not);
  not #GATE_NS au$not$g (au$not, au);
  not #GATE_NS au$not$back$g (au$not$back, au$not);

  // X0 = (X3./au + /X1.X0 + Init)./AUdur
  nand #GATE_NS T3$give$g (T3$give, X3, au$not, T2$give, Init$start, AUdur$not);
  nand #GATE_NS T0$arm$give$g (T0$arm$give, X0$unarmed, dcy$not, T3$give, T0$disarm$give, X10$q, X0$unarmed$off0, X11$q, X0$unarmed$off1, X12$q, X0$unarmed$off2, X13$q, X0$unarmed$off3, T10$give, T11$give, T12$give, T13$give, Init$start, AUdur$not);
  nand #GATE_NS T0$disarm$give$g (T0$disarm$give, X0$armed, dcy, dcy$not$back, au, au$not$back, T0$arm$via$give, X10$q, X0$armed$off4, X11$q, X0$armed$off5, X12$q, X0$armed$off6, X13$q, X0$armed$off7, T10$give, T11$give, T12$give, T13$give, Init$start, AUdur$not);
  nand #GATE_NS T0$arm$via$give$g (T0$arm$via$give, T0$arm$via, T0$arm$give, Init$start, AUdur$not);
  nand #GATE_NS X0$unarmed$off0$g (X0$unarmed$off0, X0$unarmed, T3$give, T0$disarm$give, X10);
  nand #GATE_NS X0$unarmed$off1$g (X0$unarmed$off1, X0$unarmed, T3$give, T0$disarm$give, X11);
  nand #GATE_NS X0$unarmed$off2$g (X0$unarmed$off2, X0$unarmed, T3$give, T0$disarm$give, X12);
  nand #GATE_NS X0$unarmed$off3$g (X0$unarmed$off3, X0$unarmed, T3$give, T0$disarm$give, X13);
  nand #GATE_NS X0$armed$off4$g (X0$armed$off4, X0$armed, T0$arm$via$give, X10);
  nand #GATE_NS X0$armed$off5$g (X0$armed$off5, X0$armed, T0$arm$via$give, X11);
  nand #GATE_NS X0$armed$off6$g (X0$armed$off6, X0$armed, T0$arm$via$give, X12);
  nand #GATE_NS X0$armed$off7$g (X0$armed$off7, X0$armed, T0$arm$via$give, X13);
  nand #GATE_NS X0$unarmed$g (X0$unarmed, T3$give, T0$disarm$give, X0$unarmed$q, Init$start);
  nand #GATE_NS X0$unarmed$q$g (X0$unarmed$q, X0$unarmed, T0$arm$via$q, AUdur$not);
  nand #GATE_NS X0$armed$g (X0$armed, T0$arm$via$give, X0$armed$q);
  nand #GATE_NS X0$armed$q$g (X0$armed$q, X0$armed, X1$q, X0$unarmed$q, Init$start, AUdur$not);
  nand #GATE_NS T0$arm$via$g (T0$arm$via, T0$arm$give, T0$arm$via$q);
  nand #GATE_NS T0$arm$via$q$g (T0$arm$via$q, T0$arm$via, X0$armed$q, Init$start, AUdur$not);
  not #GATE_NS X0$unarmed$not$g (X0$unarmed$not, X0$unarmed);
  not #GATE_NS T0$arm$via$not$g (T0$arm$via$not, T0$arm$via);
  not #GATE_NS X0$armed$not$g (X0$armed$not, X0$armed);
  nand #GATE_NS X0$g (X0, X0$unarmed$not, T0$arm$via$not, X0$armed$not);

  // X1 = (X0.↑dcy./au + /X2.X1)./Init./AUdur
  nand #GATE_NS T0$give$g (T0$give, X0$armed, dcy, dcy$not$back, au$not, T0$arm$via$give, X10$q, X0$armed$off4, X11$q, X0$armed$off5, X12$q, X0$armed$off6, X13$q, X0$armed$off7, T10$give, T11$give, T12$give, T13$give, Init$start, AUdur$not);
  nand #GATE_NS X1$off8$g (X1$off8, X1, T0$give, X11);
  nand #GATE_NS X1$off9$g (X1$off9, X1, T0$give, X12);
  nand #GATE_NS X1$off10$g (X1$off10, X1, T0$give, X13);
  nand #GATE_NS X1$on11$g (X1$on11, X1, T0$give, X10$q, X11$q, X1$off8, X12$q, X1$off9, X13$q, X1$off10);
  nand #GATE_NS X1$g (X1, T0$give, X1$q);
  nand #GATE_NS X1$q$g (X1$q, X1, X2$q, Init$start, AUdur$not);

  // X2 = (X1 + /X3.X2)./Init./AUdur
  nand #GATE_NS T1$give$g (T1$give, X1, T0$give, X11$q, X1$off8, X12$q, X1$off9, X13$q, X1$off10, X10, X1$on11, T10$give, T11$give, T12$give, T13$give, Init$start, AUdur$not);
  nand #GATE_NS X2$g (X2, T1$give, X2$q);
  nand #GATE_NS X2$q$g (X2$q, X2, X3$q, Init$start, AUdur$not);

  // X3 = (X2.au + /X0.X3)./Init./AUdur
  nand #GATE_NS T2$give$g (T2$give, X2, au, au$not$back, T1$give, Init$start, AUdur$not);
  nand #GATE_NS X3$g (X3, T2$give, X3$q);
  nand #GATE_NS X3$q$g (X3$q, X3, X0$unarmed$q, Init$start, AUdur$not);

  // X10 = ((X13 . 5s/X13./X3 + /X11.X10)./Init./(X0 + X1) + X1)./AUdur
  grafwire_timer #(.GATE_NS(GATE_NS), .RISE_PS(64'd5000000000000), .FALL_PS(64'd0), .INIT(1'b0)) X13$timer0$g (.a(X13), .q(X13$timer0));  // 5s, 0s
  nand #GATE_NS T13$give$g (T13$give, X13$timer0, T12$give, X3$q, T3$give, Init$start, AUdur$not, X0$unarmed$q, T0$arm$give, T0$arm$via$q, T0$arm$via$give, X0$armed$q, T0$give, T0$disarm$give, X1$q, T1$give);
  nand #GATE_NS X10$g (X10, T13$give, X1$on11, X10$q);
  nand #GATE_NS X10$q$g (X10$q, X10, X11$q, X0$unarmed$off0, X0$armed$off4, Init$start, AUdur$not);

  // X11 = (X10.h1./X3 + /X12.X11)./Init./(X0 + X1)./AUdur
  nand #GATE_NS T10$give$g (T10$give, X10, h1, T13$give, X3$q, T3$give, Init$start, AUdur$not, X0$unarmed$q, T0$arm$give, T0$arm$via$q, T0$arm$via$give, X0$armed$q, T0$give, T0$disarm$give, X1$q, T1$give);
  nand #GATE_NS X11$g (X11, T10$give, X11$q);
  nand #GATE_NS X11$q$g (X11$q, X11, X12$q, X0$unarmed$off1, X0$armed$off5, X1$off8, Init$start, AUdur$not);

  // X12 = (X11.v1./X3 + /X13.X12)./Init./(X0 + X1)./AUdur
  nand #GATE_NS T11$give$g (T11$give, X11, v1, T10$give, X3$q, T3$give, Init$start, AUdur$not, X0$unarmed$q, T0$arm$give, T0$arm$via$q, T0$arm$via$give, X0$armed$q, T0$give, T0$disarm$give, X1$q, T1$give);
  nand #GATE_NS X12$g (X12, T11$give, X12$q);
  nand #GATE_NS X12$q$g (X12$q, X12, X13$q, X0$unarmed$off2, X0$armed$off6, X1$off9, Init$start, AUdur$not);

  // X13 = (X12.h0./X3 + /X10.X13)./Init./(X0 + X1)./AUdur
  nand #GATE_NS T12$give$g (T12$give, X12, h0, T11$give, X3$q, T3$give, Init$start, AUdur$not, X0$unarmed$q, T0$arm$give, T0$arm$via$q, T0$arm$via$give, X0$armed$q, T0$give, T0$disarm$give, X1$q, T1$give);
  nand #GATE_NS X13$g (X13, T12$give, X13$q);
  nand #GATE_NS X13$q$g (X13$q, X13, X10$q, X0$unarmed$off3, X0$armed$off7, X1$off10, Init$start, AUdur$not);

  // V+ = X11./AUdoux
  not #GATE_NS AUdoux$not$g (AUdoux$not, AUdoux);
  nand #GATE_NS \V+$1$g  (\V+$1 , X11, AUdoux$not);
  not #GATE_NS \V+$g  (\V+ , \V+$1 );

  // H- = X12.v0./AUdoux
  nand #GATE_NS \H-$1$g  (\H-$1 , X12, v0, AUdoux$not);
  not #GATE_NS \H-$g  (\H- , \H-$1 );

  // H+ = X10./AUdoux
  nand #GATE_NS \H+$1$g  (\H+$1 , X10, AUdoux$not);
  not #GATE_NS \H+$g  (\H+ , \H+$1 );

  // Voyant CI = (X0.v0.h0 + X1.v0.h0 + X2.v0.h0 + X3.v0.h0)./AUdoux
  nand #GATE_NS \Voyant%20CI$1$g  (\Voyant%20CI$1 , X0, v0, h0);
  nand #GATE_NS \Voyant%20CI$2$g  (\Voyant%20CI$2 , X1, v0, h0);
  nand #GATE_NS \Voyant%20CI$3$g  (\Voyant%20CI$3 , X2, v0, h0);
  nand #GATE_NS \Voyant%20CI$4$g  (\Voyant%20CI$4 , X3, v0, h0);
  nand #GATE_NS \Voyant%20CI$5$g  (\Voyant%20CI$5 , \Voyant%20CI$1 , \Voyant%20CI$2 , \Voyant%20CI$3 , \Voyant%20CI$4 );
  nand #GATE_NS \Voyant%20CI$6$g  (\Voyant%20CI$6 , \Voyant%20CI$5 , AUdoux$not);
  not #GATE_NS \Voyant%20CI$g  (\Voyant%20CI , \Voyant%20CI$6 );
endmodule

`timescale 1ps/1ps

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
