// manipulator_modes "Manipulateur en L, marches automatique et manuelle" (manipulator-modes.grafcet): 187 cells.
// Style clocked, CDX by transitions, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist manipulator-modes.grafcet --style clocked --cdx transition --modes on --to verilog --scan 10ms
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $N           a gate of a condition of the owner
//   $aN          a gate of the arithmetic that works out a value
//   $clear       of a transition: it is cleared; of a step: Init deactivates it
//   edge$N       edge N of the chart, counted from 0
//   $evolved     the step after the transitions, before any order
//   $force       of the forcing orders to the graph
//   $forced      a forcing order activates the step
//   $free        no forcing order stands against it
//   $high        always 1
//   $hold        keeps the owner as it is
//   $low         always 0
//   $may_evolve  no order freezes the graph
//   $memory      the operand of the edge, a scan ago
//   $next        the owner as it is from the next clock on
//   $not         the owner inverted
//   $running     1 from the second scan on
//   timer$N      time condition N of the chart, counted from 0
//   $unforced    a forcing order deactivates the step
//   $whenN       something is written to the owner
//   \Voyant%20CI = Voyant CI
//   \Voyant%20Auto = Voyant Auto
//   \Voyant%20Manu = Voyant Manu
`timescale 1ns/1ps

module manipulator_modes #(parameter [63:0] SCAN_PS = 64'd10000000000) (
  input v0,
  input v1,
  input h0,
  input h1,
  input dcy,
  input manu,
  input auto,
  input au,
  input vh,
  input vv,
  input a,
  input b,
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
  output X14,
  output X20,
  output X21,
  output X22,
  output X23,
  output X30,
  output X31,
  output X32,
  output \V+ ,
  output \H- ,
  output \H+ ,
  output \Voyant%20CI ,
  output \Voyant%20Auto ,
  output \Voyant%20Manu 
);
  wire Init$not, AUdur$not;
  wire \$high , edges$running, edge$0$1, edge$0$memory, edge$0$memory$not, edge$0, edge$1$memory, edge$1$memory$not, edge$1, edge$2$memory, edge$2$memory$not, edge$2;
  wire au$not, T0$1, T0$clear;
  wire T1$clear;
  wire T2$clear;
  wire T3$clear;
  wire T10$1, T10$clear;
  wire T11$clear;
  wire auto$not, T12$clear;
  wire T13$1, T13$clear;
  wire T14$clear;
  wire manu$not, T15$clear;
  wire T20$clear;
  wire T21$clear;
  wire T22$clear;
  wire T23$clear;
  wire T30$clear;
  wire vh$not, T31$clear;
  wire T32$1, T32$clear;
  wire vv$not, T33$clear;
  wire T0$clear$not, X0$hold, X0$evolved, X0$next;
  wire T1$clear$not, X1$hold, X1$evolved, X1$next;
  wire T2$clear$not, X2$hold, X2$evolved, X2$next;
  wire T3$clear$not, X3$hold, X3$evolved, X3$next;
  wire T10$clear$not, T13$clear$not, X10$hold, X10$evolved, X10$next;
  wire T11$clear$not, X11$hold, X11$evolved, X11$next;
  wire T12$clear$not, X12$hold, X12$evolved, X12$next;
  wire T14$clear$not, X13$hold, X13$evolved, X13$next;
  wire T15$clear$not, X14$hold, X14$evolved, X14$next;
  wire T20$clear$not, X20$hold, X20$evolved, X20$next;
  wire T21$clear$not, X21$hold, X21$evolved, X21$next;
  wire T22$clear$not, X22$hold, X22$evolved, X22$next;
  wire T23$clear$not, X23$hold, X23$evolved, X23$next;
  wire T30$clear$not, T32$clear$not, X30$hold, X30$evolved, X30$next;
  wire T31$clear$not, X31$hold, X31$evolved, X31$next;
  wire T33$clear$not, X32$hold, X32$evolved, X32$next;
  wire XGC$force$free, X10$unforced, X10$forced, X11$unforced, X12$unforced, X13$unforced, X14$unforced;
  wire XGauto$force$free, X20$unforced, X20$forced, X21$unforced, X22$unforced, X23$unforced;
  wire XGmanu$force$free, X30$unforced, X30$forced, X31$unforced, X32$unforced;
  wire X3$next$not, XGC$may_evolve;
  wire XGauto$may_evolve;
  wire XGmanu$may_evolve;
  wire \$low , X32$next$not, manual_up$when1, manual_up$when1$not, manual_up$next$a1, X32$not, manual_up$when2, manual_up$when2$not, manual_up$next$a2, manual_up$4, manual_up$when3, manual_up$next$a3, manual_up$when3$not, manual_up$next$a4, manual_up$next$a5, manual_up;
  wire timer$0;
  wire \V+$1 , \V+$2 , AUdoux$not, \V+$3 ;
  wire \H-$1 , \H-$2 , \H-$3 , \H-$4 ;
  wire \H+$1 , \H+$2 , \H+$3 ;
  wire \Voyant%20CI$1 , \Voyant%20CI$2 , \Voyant%20CI$3 , \Voyant%20CI$4 , \Voyant%20CI$5 , \Voyant%20CI$6 ;
  wire \Voyant%20Auto$1 ;
  wire \Voyant%20Manu$1 ;

  // inputs
  not Init$not$g (Init$not, Init);
  not AUdur$not$g (AUdur$not, AUdur);

  // edges
  assign \$high  = 1'b1;
  grafwire_dff #(.INIT(1'b0)) edges$running$g (.d(\$high ), .c(clk), .q(edges$running));
  and edge$0$1$g (edge$0$1, a, X32);
  grafwire_dff #(.INIT(1'b0)) edge$0$memory$g (.d(edge$0$1), .c(clk), .q(edge$0$memory));
  not edge$0$memory$not$g (edge$0$memory$not, edge$0$memory);
  and edge$0$g (edge$0, edge$0$1, edge$0$memory$not, edges$running);
  grafwire_dff #(.INIT(1'b0)) edge$1$memory$g (.d(b), .c(clk), .q(edge$1$memory));
  not edge$1$memory$not$g (edge$1$memory$not, edge$1$memory);
  and edge$1$g (edge$1, b, edge$1$memory$not, edges$running);
  grafwire_dff #(.INIT(1'b0)) edge$2$memory$g (.d(dcy), .c(clk), .q(edge$2$memory));
  not edge$2$memory$not$g (edge$2$memory$not, edge$2$memory);
  and edge$2$g (edge$2, dcy, edge$2$memory$not, edges$running);

  // T0
  not au$not$g (au$not, au);
  and T0$1$g (T0$1, edge$2, au$not);
  and T0$clear$g (T0$clear, X0, T0$1, Init$not);

  // T1
  and T1$clear$g (T1$clear, X1, Init$not);

  // T2
  and T2$clear$g (T2$clear, X2, au, Init$not);

  // T3
  and T3$clear$g (T3$clear, X3, au$not, Init$not);

  // T10
  and T10$1$g (T10$1, v0, h0, auto, edge$2);
  and T10$clear$g (T10$clear, X10, T10$1, XGC$may_evolve, Init$not);

  // T11
  and T11$clear$g (T11$clear, X11, XGC$may_evolve, Init$not);

  // T12
  not auto$not$g (auto$not, auto);
  and T12$clear$g (T12$clear, X12, auto$not, XGC$may_evolve, Init$not);

  // T13
  and T13$1$g (T13$1, manu, auto$not);
  and T13$clear$g (T13$clear, X10, T13$1, XGC$may_evolve, Init$not);

  // T14
  and T14$clear$g (T14$clear, X13, XGC$may_evolve, Init$not);

  // T15
  not manu$not$g (manu$not, manu);
  and T15$clear$g (T15$clear, X14, manu$not, XGC$may_evolve, Init$not);

  // T20
  and T20$clear$g (T20$clear, X20, h1, XGauto$may_evolve, Init$not);

  // T21
  and T21$clear$g (T21$clear, X21, v1, XGauto$may_evolve, Init$not);

  // T22
  and T22$clear$g (T22$clear, X22, h0, XGauto$may_evolve, Init$not);

  // T23
  and T23$clear$g (T23$clear, X23, timer$0, XGauto$may_evolve, Init$not);

  // T30
  and T30$clear$g (T30$clear, X30, vh, XGmanu$may_evolve, Init$not);

  // T31
  not vh$not$g (vh$not, vh);
  and T31$clear$g (T31$clear, X31, vh$not, XGmanu$may_evolve, Init$not);

  // T32
  and T32$1$g (T32$1, vv, vh$not);
  and T32$clear$g (T32$clear, X30, T32$1, XGmanu$may_evolve, Init$not);

  // T33
  not vv$not$g (vv$not, vv);
  and T33$clear$g (T33$clear, X32, vv$not, XGmanu$may_evolve, Init$not);

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

  // X10 = ((X12./auto./X3 + X14./manu./X3 + /(X10.v0.h0.auto.↑dcy./X3 + X10.manu./auto./X3).X10)./Init./(X0 + X1) + X1)./AUdur
  not T10$clear$not$g (T10$clear$not, T10$clear);
  not T13$clear$not$g (T13$clear$not, T13$clear);
  and X10$hold$g (X10$hold, X10, T10$clear$not, T13$clear$not, Init$not);
  or X10$evolved$g (X10$evolved, T12$clear, T15$clear, X10$hold);
  and X10$next$g (X10$next, X10$forced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X10$g (.d(X10$next), .c(clk), .q(X10));

  // X11 = (X10.v0.h0.auto.↑dcy./X3 + /(X11./X3).X11)./Init./(X0 + X1)./AUdur
  not T11$clear$not$g (T11$clear$not, T11$clear);
  and X11$hold$g (X11$hold, X11, T11$clear$not, Init$not);
  or X11$evolved$g (X11$evolved, T10$clear, X11$hold);
  and X11$next$g (X11$next, X11$unforced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X11$g (.d(X11$next), .c(clk), .q(X11));

  // X12 = (X11./X3 + /(X12./auto./X3).X12)./Init./(X0 + X1)./AUdur
  not T12$clear$not$g (T12$clear$not, T12$clear);
  and X12$hold$g (X12$hold, X12, T12$clear$not, Init$not);
  or X12$evolved$g (X12$evolved, T11$clear, X12$hold);
  and X12$next$g (X12$next, X12$unforced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X12$g (.d(X12$next), .c(clk), .q(X12));

  // X13 = (X10.manu./auto./X3 + /(X13./X3).X13)./Init./(X0 + X1)./AUdur
  not T14$clear$not$g (T14$clear$not, T14$clear);
  and X13$hold$g (X13$hold, X13, T14$clear$not, Init$not);
  or X13$evolved$g (X13$evolved, T13$clear, X13$hold);
  and X13$next$g (X13$next, X13$unforced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X13$g (.d(X13$next), .c(clk), .q(X13));

  // X14 = (X13./X3 + /(X14./manu./X3).X14)./Init./(X0 + X1)./AUdur
  not T15$clear$not$g (T15$clear$not, T15$clear);
  and X14$hold$g (X14$hold, X14, T15$clear$not, Init$not);
  or X14$evolved$g (X14$evolved, T14$clear, X14$hold);
  and X14$next$g (X14$next, X14$unforced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X14$g (.d(X14$next), .c(clk), .q(X14));

  // X20 = ((X23 . 3s/X23./X3 + /(X20.h1./X3).X20)./Init./(X0 + X10 + X11) + X11)./AUdur
  not T20$clear$not$g (T20$clear$not, T20$clear);
  and X20$hold$g (X20$hold, X20, T20$clear$not, Init$not);
  or X20$evolved$g (X20$evolved, T23$clear, X20$hold);
  and X20$next$g (X20$next, X20$forced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X20$g (.d(X20$next), .c(clk), .q(X20));

  // X21 = (X20.h1./X3 + /(X21.v1./X3).X21)./Init./(X0 + X10 + X11)./AUdur
  not T21$clear$not$g (T21$clear$not, T21$clear);
  and X21$hold$g (X21$hold, X21, T21$clear$not, Init$not);
  or X21$evolved$g (X21$evolved, T20$clear, X21$hold);
  and X21$next$g (X21$next, X21$unforced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X21$g (.d(X21$next), .c(clk), .q(X21));

  // X22 = (X21.v1./X3 + /(X22.h0./X3).X22)./Init./(X0 + X10 + X11)./AUdur
  not T22$clear$not$g (T22$clear$not, T22$clear);
  and X22$hold$g (X22$hold, X22, T22$clear$not, Init$not);
  or X22$evolved$g (X22$evolved, T21$clear, X22$hold);
  and X22$next$g (X22$next, X22$unforced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X22$g (.d(X22$next), .c(clk), .q(X22));

  // X23 = (X22.h0./X3 + /(X23 . 3s/X23./X3).X23)./Init./(X0 + X10 + X11)./AUdur
  not T23$clear$not$g (T23$clear$not, T23$clear);
  and X23$hold$g (X23$hold, X23, T23$clear$not, Init$not);
  or X23$evolved$g (X23$evolved, T22$clear, X23$hold);
  and X23$next$g (X23$next, X23$unforced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X23$g (.d(X23$next), .c(clk), .q(X23));

  // X30 = ((X31./vh./X3 + X32./vv./X3 + /(X30.vh./X3 + X30.vv./vh./X3).X30)./Init./(X0 + X10 + X13) + X13)./AUdur
  not T30$clear$not$g (T30$clear$not, T30$clear);
  not T32$clear$not$g (T32$clear$not, T32$clear);
  and X30$hold$g (X30$hold, X30, T30$clear$not, T32$clear$not, Init$not);
  or X30$evolved$g (X30$evolved, T31$clear, T33$clear, X30$hold);
  and X30$next$g (X30$next, X30$forced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X30$g (.d(X30$next), .c(clk), .q(X30));

  // X31 = (X30.vh./X3 + /(X31./vh./X3).X31)./Init./(X0 + X10 + X13)./AUdur
  not T31$clear$not$g (T31$clear$not, T31$clear);
  and X31$hold$g (X31$hold, X31, T31$clear$not, Init$not);
  or X31$evolved$g (X31$evolved, T30$clear, X31$hold);
  and X31$next$g (X31$next, X31$unforced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X31$g (.d(X31$next), .c(clk), .q(X31));

  // X32 = (X30.vv./vh./X3 + /(X32./vv./X3).X32)./Init./(X0 + X10 + X13)./AUdur
  not T33$clear$not$g (T33$clear$not, T33$clear);
  and X32$hold$g (X32$hold, X32, T33$clear$not, Init$not);
  or X32$evolved$g (X32$evolved, T32$clear, X32$hold);
  and X32$next$g (X32$next, X32$unforced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X32$g (.d(X32$next), .c(clk), .q(X32));

  // XGC$force
  nor XGC$force$free$g (XGC$force$free, X0$evolved, X1$evolved);
  and X10$unforced$g (X10$unforced, X10$evolved, XGC$force$free);
  or X10$forced$g (X10$forced, X1$evolved, X10$unforced);
  and X11$unforced$g (X11$unforced, X11$evolved, XGC$force$free);
  and X12$unforced$g (X12$unforced, X12$evolved, XGC$force$free);
  and X13$unforced$g (X13$unforced, X13$evolved, XGC$force$free);
  and X14$unforced$g (X14$unforced, X14$evolved, XGC$force$free);

  // XGauto$force
  nor XGauto$force$free$g (XGauto$force$free, X0$evolved, X10$evolved, X11$evolved);
  and X20$unforced$g (X20$unforced, X20$evolved, XGauto$force$free);
  or X20$forced$g (X20$forced, X11$evolved, X20$unforced);
  and X21$unforced$g (X21$unforced, X21$evolved, XGauto$force$free);
  and X22$unforced$g (X22$unforced, X22$evolved, XGauto$force$free);
  and X23$unforced$g (X23$unforced, X23$evolved, XGauto$force$free);

  // XGmanu$force
  nor XGmanu$force$free$g (XGmanu$force$free, X0$evolved, X10$evolved, X13$evolved);
  and X30$unforced$g (X30$unforced, X30$evolved, XGmanu$force$free);
  or X30$forced$g (X30$forced, X13$evolved, X30$unforced);
  and X31$unforced$g (X31$unforced, X31$evolved, XGmanu$force$free);
  and X32$unforced$g (X32$unforced, X32$evolved, XGmanu$force$free);

  // XGC$freeze
  not X3$next$not$g (X3$next$not, X3$next);
  grafwire_dff #(.INIT(1'b1)) XGC$may_evolve$g (.d(X3$next$not), .c(clk), .q(XGC$may_evolve));

  // XGauto$freeze
  grafwire_dff #(.INIT(1'b1)) XGauto$may_evolve$g (.d(X3$next$not), .c(clk), .q(XGauto$may_evolve));

  // XGmanu$freeze
  grafwire_dff #(.INIT(1'b1)) XGmanu$may_evolve$g (.d(X3$next$not), .c(clk), .q(XGmanu$may_evolve));

  // manual_up
  assign \$low  = 1'b0;
  not X32$next$not$g (X32$next$not, X32$next);
  and manual_up$when1$g (manual_up$when1, X32, X32$next$not);
  not manual_up$when1$not$g (manual_up$when1$not, manual_up$when1);
  and manual_up$next$a1$g (manual_up$next$a1, manual_up$when1$not, manual_up);
  not X32$not$g (X32$not, X32);
  and manual_up$when2$g (manual_up$when2, X32$not, X32$next);
  not manual_up$when2$not$g (manual_up$when2$not, manual_up$when2);
  and manual_up$next$a2$g (manual_up$next$a2, manual_up$when2$not, manual_up$next$a1);
  or manual_up$4$g (manual_up$4, edge$0, edge$1);
  and manual_up$when3$g (manual_up$when3, X32$next, manual_up$4);
  and manual_up$next$a3$g (manual_up$next$a3, manual_up$when3, a);
  not manual_up$when3$not$g (manual_up$when3$not, manual_up$when3);
  and manual_up$next$a4$g (manual_up$next$a4, manual_up$when3$not, manual_up$next$a2);
  or manual_up$next$a5$g (manual_up$next$a5, manual_up$next$a3, manual_up$next$a4);
  grafwire_dff #(.INIT(1'b0)) manual_up$g (.d(manual_up$next$a5), .c(clk), .q(manual_up));

  // timer$0
  grafwire_scan_timer #(.RISE_PS(64'd3000000000000), .FALL_PS(64'd0), .SCAN_PS(SCAN_PS), .INIT(1'b0)) timer$0$g (.a(X23$next), .c(clk), .q(timer$0));  // 3s, 0s

  // V+ = (X21 + X32.manual_up)./AUdoux
  and \V+$1$g  (\V+$1 , X32, manual_up);
  or \V+$2$g  (\V+$2 , X21, \V+$1 );
  not AUdoux$not$g (AUdoux$not, AUdoux);
  and \V+$3$g  (\V+$3 , \V+$2 , AUdoux$not);
  buf \V+$g  (\V+ , \V+$3 );

  // H- = (X22.v0 + X31.b)./AUdoux
  and \H-$1$g  (\H-$1 , X22, v0);
  and \H-$2$g  (\H-$2 , X31, b);
  or \H-$3$g  (\H-$3 , \H-$1 , \H-$2 );
  and \H-$4$g  (\H-$4 , \H-$3 , AUdoux$not);
  buf \H-$g  (\H- , \H-$4 );

  // H+ = (X20 + X31.a)./AUdoux
  and \H+$1$g  (\H+$1 , X31, a);
  or \H+$2$g  (\H+$2 , X20, \H+$1 );
  and \H+$3$g  (\H+$3 , \H+$2 , AUdoux$not);
  buf \H+$g  (\H+ , \H+$3 );

  // Voyant CI = (X0.v0.h0 + X1.v0.h0 + X2.v0.h0 + X3.v0.h0)./AUdoux
  and \Voyant%20CI$1$g  (\Voyant%20CI$1 , X0, v0, h0);
  and \Voyant%20CI$2$g  (\Voyant%20CI$2 , X1, v0, h0);
  and \Voyant%20CI$3$g  (\Voyant%20CI$3 , X2, v0, h0);
  and \Voyant%20CI$4$g  (\Voyant%20CI$4 , X3, v0, h0);
  or \Voyant%20CI$5$g  (\Voyant%20CI$5 , \Voyant%20CI$1 , \Voyant%20CI$2 , \Voyant%20CI$3 , \Voyant%20CI$4 );
  and \Voyant%20CI$6$g  (\Voyant%20CI$6 , \Voyant%20CI$5 , AUdoux$not);
  buf \Voyant%20CI$g  (\Voyant%20CI , \Voyant%20CI$6 );

  // Voyant Auto = X12./AUdoux
  and \Voyant%20Auto$1$g  (\Voyant%20Auto$1 , X12, AUdoux$not);
  buf \Voyant%20Auto$g  (\Voyant%20Auto , \Voyant%20Auto$1 );

  // Voyant Manu = X14./AUdoux
  and \Voyant%20Manu$1$g  (\Voyant%20Manu$1 , X14, AUdoux$not);
  buf \Voyant%20Manu$g  (\Voyant%20Manu , \Voyant%20Manu$1 );
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
