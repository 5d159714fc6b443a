// manipulator "Manipulateur en L" (manipulator.grafcet): 80 cells.
// Style clocked, CDX by transitions, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist manipulator.grafcet --style clocked --cdx transition --modes on --to verilog --scan 10ms
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $N           a gate of a condition of the owner
//   $clear       of a transition: it is cleared; of a step: Init deactivates it
//   edge$N       edge N of the chart, counted from 0
//   $evolved     the step after the transitions, before any order
//   $force       of the forcing orders to the graph
//   $forced      a forcing order activates the step
//   $free        no forcing order stands against it
//   $high        always 1
//   $hold        keeps the owner as it is
//   $may_evolve  no order freezes the graph
//   $memory      the operand of the edge, a scan ago
//   $next        the owner as it is from the next clock on
//   $not         the owner inverted
//   $running     1 from the second scan on
//   timer$N      time condition N of the chart, counted from 0
//   $unforced    a forcing order deactivates the step
//   \Voyant%20CI = Voyant CI
`timescale 1ns/1ps

module manipulator #(parameter [63:0] SCAN_PS = 64'd10000000000) (
  input v0,
  input v1,
  input h0,
  input h1,
  input dcy,
  input au,
  input Init,
  input AUdur,
  input AUdoux,
  input clk,
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
  wire \$high , edges$running, edge$0$memory, edge$0$memory$not, edge$0;
  wire au$not, T0$1, T0$clear;
  wire T1$clear;
  wire T2$clear;
  wire T3$clear;
  wire T10$clear;
  wire T11$clear;
  wire T12$clear;
  wire T13$clear;
  wire T0$clear$not, X0$hold, X0$evolved, X0$next;
  wire T1$clear$not, X1$hold, X1$evolved, X1$next;
  wire T2$clear$not, X2$hold, X2$evolved, X2$next;
  wire T3$clear$not, X3$hold, X3$evolved, X3$next;
  wire T10$clear$not, X10$hold, X10$evolved, X10$next;
  wire T11$clear$not, X11$hold, X11$evolved, X11$next;
  wire T12$clear$not, X12$hold, X12$evolved, X12$next;
  wire T13$clear$not, X13$hold, X13$evolved, X13$next;
  wire XGauto$force$free, X10$unforced, X10$forced, X11$unforced, X12$unforced, X13$unforced;
  wire X3$next$not, XGauto$may_evolve;
  wire timer$0;
  wire AUdoux$not, \V+$1 ;
  wire \H-$1 ;
  wire \H+$1 ;
  wire \Voyant%20CI$1 , \Voyant%20CI$2 , \Voyant%20CI$3 , \Voyant%20CI$4 , \Voyant%20CI$5 , \Voyant%20CI$6 ;

  // inputs
  not Init$not$g (Init$not, Init);
  not AUdur$not$g (AUdur$not, AUdur);

  // edges
  assign \$high  = 1'b1;
  grafwire_dff #(.INIT(1'b0)) edges$running$g (.d(\$high ), .c(clk), .q(edges$running));
  grafwire_dff #(.INIT(1'b0)) edge$0$memory$g (.d(dcy), .c(clk), .q(edge$0$memory));
  not edge$0$memory$not$g (edge$0$memory$not, edge$0$memory);
  and edge$0$g (edge$0, dcy, edge$0$memory$not, edges$running);

  // T0
  not au$not$g (au$not, au);
  and T0$1$g (T0$1, edge$0, au$not);
  and T0$clear$g (T0$clear, X0, T0$1, Init$not);

  // T1
  and T1$clear$g (T1$clear, X1, Init$not);

  // T2
  and T2$clear$g (T2$clear, X2, au, Init$not);

  // T3
  and T3$clear$g (T3$clear, X3, au$not, Init$not);

  // T10
  and T10$clear$g (T10$clear, X10, h1, XGauto$may_evolve, Init$not);

  // T11
  and T11$clear$g (T11$clear, X11, v1, XGauto$may_evolve, Init$not);

  // T12
  and T12$clear$g (T12$clear, X12, h0, XGauto$may_evolve, Init$not);

  // T13
  and T13$clear$g (T13$clear, X13, timer$0, XGauto$may_evolve, Init$not);

  // X0 = (X3./au + /(X0.↑dcy./au).X0 + Init)./AUdur
  not T0$clear$not$g (T0$clear$not, T0$clear);
  and X0$hold$g (X0$hold, X0, T0$clear$not);
  or X0$evolved$g (X0$evolved, T3$clear, X0$hold, Init);
  and X0$next$g (X0$next, X0$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b1)) X0$g (.d(X0$next), .c(clk), .q(X0));

  // X1 = (X0.↑dcy./au + /X1.X1)./Init./AUdur
  not T1$clear$not$g (T1$clear$not, T1$clear);
  and X1$hold$g (X1$hold, X1, T1$clear$not, Init$not);
  or X1$evolved$g (X1$evolved, T0$clear, X1$hold);
  and X1$next$g (X1$next, X1$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X1$g (.d(X1$next), .c(clk), .q(X1));

  // X2 = (X1 + /(X2.au).X2)./Init./AUdur
  not T2$clear$not$g (T2$clear$not, T2$clear);
  and X2$hold$g (X2$hold, X2, T2$clear$not, Init$not);
  or X2$evolved$g (X2$evolved, T1$clear, X2$hold);
  and X2$next$g (X2$next, X2$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X2$g (.d(X2$next), .c(clk), .q(X2));

  // X3 = (X2.au + /(X3./au).X3)./Init./AUdur
  not T3$clear$not$g (T3$clear$not, T3$clear);
  and X3$hold$g (X3$hold, X3, T3$clear$not, Init$not);
  or X3$evolved$g (X3$evolved, T2$clear, X3$hold);
  and X3$next$g (X3$next, X3$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X3$g (.d(X3$next), .c(clk), .q(X3));

  // X10 = ((X13 . 5s/X13./X3 + /(X10.h1./X3).X10)./Init./(X0 + X1) + X1)./AUdur
  not T10$clear$not$g (T10$clear$not, T10$clear);
  and X10$hold$g (X10$hold, X10, T10$clear$not, Init$not);
  or X10$evolved$g (X10$evolved, T13$clear, X10$hold);
  and X10$next$g (X10$next, X10$forced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X10$g (.d(X10$next), .c(clk), .q(X10));

  // X11 = (X10.h1./X3 + /(X11.v1./X3).X11)./Init./(X0 + X1)./AUdur
  not T11$clear$not$g (T11$clear$not, T11$clear);
  and X11$hold$g (X11$hold, X11, T11$clear$not, Init$not);
  or X11$evolved$g (X11$evolved, T10$clear, X11$hold);
  and X11$next$g (X11$next, X11$unforced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X11$g (.d(X11$next), .c(clk), .q(X11));

  // X12 = (X11.v1./X3 + /(X12.h0./X3).X12)./Init./(X0 + X1)./AUdur
  not T12$clear$not$g (T12$clear$not, T12$clear);
  and X12$hold$g (X12$hold, X12, T12$clear$not, Init$not);
  or X12$evolved$g (X12$evolved, T11$clear, X12$hold);
  and X12$next$g (X12$next, X12$unforced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X12$g (.d(X12$next), .c(clk), .q(X12));

  // X13 = (X12.h0./X3 + /(X13 . 5s/X13./X3).X13)./Init./(X0 + X1)./AUdur
  not T13$clear$not$g (T13$clear$not, T13$clear);
  and X13$hold$g (X13$hold, X13, T13$clear$not, Init$not);
  or X13$evolved$g (X13$evolved, T12$clear, X13$hold);
  and X13$next$g (X13$next, X13$unforced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X13$g (.d(X13$next), .c(clk), .q(X13));

  // XGauto$force
  nor XGauto$force$free$g (XGauto$force$free, X0$evolved, X1$evolved);
  and X10$unforced$g (X10$unforced, X10$evolved, XGauto$force$free);
  or X10$forced$g (X10$forced, X1$evolved, X10$unforced);
  and X11$unforced$g (X11$unforced, X11$evolved, XGauto$force$free);
  and X12$unforced$g (X12$unforced, X12$evolved, XGauto$force$free);
  and X13$unforced$g (X13$unforced, X13$evolved, XGauto$force$free);

  // XGauto$freeze
  not X3$next$not$g (X3$next$not, X3$next);
  grafwire_dff #(.INIT(1'b1)) XGauto$may_evolve$g (.d(X3$next$not), .c(clk), .q(XGauto$may_evolve));

  // timer$0
  grafwire_scan_timer #(.RISE_PS(64'd5000000000000), .FALL_PS(64'd0), .SCAN_PS(SCAN_PS), .INIT(1'b0)) timer$0$g (.a(X13$next), .c(clk), .q(timer$0));  // 5s, 0s

  // V+ = X11./AUdoux
  not AUdoux$not$g (AUdoux$not, AUdoux);
  and \V+$1$g  (\V+$1 , X11, AUdoux$not);
  buf \V+$g  (\V+ , \V+$1 );

  // H- = X12.v0./AUdoux
  and \H-$1$g  (\H-$1 , X12, v0, AUdoux$not);
  buf \H-$g  (\H- , \H-$1 );

  // H+ = X10./AUdoux
  and \H+$1$g  (\H+$1 , X10, AUdoux$not);
  buf \H+$g  (\H+ , \H+$1 );

  // Voyant CI = (X0.v0.h0 + X1.v0.h0 + X2.v0.h0 + X3.v0.h0)./AUdoux
  and \Voyant%20CI$1$g  (\Voyant%20CI$1 , X0, v0, h0);
  and \Voyant%20CI$2$g  (\Voyant%20CI$2 , X1, v0, h0);
  and \Voyant%20CI$3$g  (\Voyant%20CI$3 , X2, v0, h0);
  and \Voyant%20CI$4$g  (\Voyant%20CI$4 , X3, v0, h0);
  or \Voyant%20CI$5$g  (\Voyant%20CI$5 , \Voyant%20CI$1 , \Voyant%20CI$2 , \Voyant%20CI$3 , \Voyant%20CI$4 );
  and \Voyant%20CI$6$g  (\Voyant%20CI$6 , \Voyant%20CI$5 , AUdoux$not);
  buf \Voyant%20CI$g  (\Voyant%20CI , \Voyant%20CI$6 );
endmodule

`timescale 1ps/1ps

// D flip-flop.
module grafwire_dff #(parameter INIT = 1'bx) (input d, input c, output reg q);
  initial q = INIT;
  always @(posedge c) q <= d;
endmodule

// Clocked timer: looks at a at each rise of the clock and follows it after so many cycles as make up
// RISE_PS or FALL_PS.
module grafwire_scan_timer #(parameter [63:0] RISE_PS = 0, FALL_PS = 0, SCAN_PS = 1, parameter INIT = 1'b0)
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
