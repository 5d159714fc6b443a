// manipulator_modes "Manipulateur en L, marches automatique et manuelle" (manipulator-modes.grafcet): 184 cells.
// Style gates, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist manipulator-modes.grafcet --style gates --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $N             a gate of a condition of the owner
//   $buf           the owner, a gate delay later
//   $cdx           CDX of the step
//   $clear         of a transition: it is cleared; of a step: Init deactivates it
//   $fallN         falling edge of the owner, edge N of the chart
//   $free          no forcing order stands against it
//   $free_of_init  Init does not stand against it
//   $hold          keeps the owner as it is
//   $not           the owner inverted
//   $or            all that makes the step active, or keeps it so
//   $reset         resets the owner
//   $resetN        resets the owner: term N of CDX, or write N
//   $riseN         rising edge of the owner, edge N of the chart
//   $setT          sets the owner: of a step, by transition T; of others, write T
//   $timerN        time condition N of the chart, counted from 0, of the owner
//   \Voyant%20CI = Voyant CI
//   \Voyant%20Auto = Voyant Auto
//   \Voyant%20Manu = Voyant Manu
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

module manipulator_modes #(parameter GATE_NS = 1) (
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
  wire au$not, T3$clear, X1$not, X0$hold, AUdur$not$buf, AUdur$not$buf$buf, X0$or;
  wire dcy$rise2, T0$clear, X2$not, X1$hold, Init$not$buf, Init$not$buf$buf, X1$or;
  wire X3$not, X2$hold, X2$or;
  wire T2$clear, X0$not, X3$hold, X3$or;
  wire X10$1, auto$not, X12$buf, T12$clear, manu$not, X14$buf, T15$clear, X10$cdx, X10$cdx$not, X10$hold, X10$1$not, X1$buf, X1$buf$buf, X10$free, X10$free_of_init, X10$or;
  wire X10$buf, v0$buf, h0$buf, auto$buf, T10$clear, X12$not, X11$hold, X11$or;
  wire X11$buf, T11$clear, X10$not, X12$hold, X12$or;
  wire manu$buf, T13$clear, X14$not, X13$hold, X13$or;
  wire X13$buf, T14$clear, X14$hold, X14$or;
  wire X20$1, X23$timer0, X23$buf, T23$clear, X21$not, X20$hold, X20$1$not, X11$buf$buf, X20$free, X20$free_of_init, X20$or;
  wire X20$buf, T20$clear, X22$not, X21$hold, X21$or;
  wire X21$buf, T21$clear, X23$not, X22$hold, X22$or;
  wire X22$buf, T22$clear, X20$not, X23$hold, X23$or;
  wire X30$1, vh$not, X3$not$buf, X3$not$buf$buf, X3$not$buf$buf$buf, X3$not$buf$buf$buf$buf, X31$buf, X31$buf$buf, X31$buf$buf$buf, X31$buf$buf$buf$buf, X31$buf$buf$buf$buf$buf, T31$clear, vv$not, X32$buf, X32$buf$buf, X32$buf$buf$buf, X32$buf$buf$buf$buf, X32$buf$buf$buf$buf$buf, T33$clear, X30$cdx, X30$cdx$not, X30$hold, X30$1$not, X13$buf$buf, X30$free, X30$free_of_init, X30$or;
  wire X30$buf, X30$buf$buf, X30$buf$buf$buf, X30$buf$buf$buf$buf, X30$buf$buf$buf$buf$buf, T30$clear, X30$not, X31$hold, X31$or;
  wire vv$buf, T32$clear, X32$hold, X32$or;
  wire \V+$1 , X21$buf$buf, X21$buf$buf$buf, X21$buf$buf$buf$buf, X21$buf$buf$buf$buf$buf, \V+$2 , AUdoux$not;
  wire \H-$1 , \H-$2 , \H-$3 , AUdoux$not$buf;
  wire \H+$1 , \H+$2 ;
  wire \Voyant%20CI$1 , \Voyant%20CI$2 , \Voyant%20CI$3 , \Voyant%20CI$4 , \Voyant%20CI$5 ;
  wire manual_up$1, manual_up$1$rise0, b$rise1, b$rise1$buf, manual_up$2, manual_up$3, manual_up$set2, a$not, manual_up$reset2, X32$rise4, manual_up$3$not, manual_up$reset1, X32$fall3, X32$rise4$not, manual_up$reset0, manual_up$reset, manual_up;

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
  grafwire_rise_pulse #(.GATE_NS(GATE_NS), .WIDTH_NS(3 * GATE_NS)) dcy$rise2$g (.a(dcy), .q(dcy$rise2));
  and #GATE_NS T0$clear$g (T0$clear, X0, dcy$rise2, au$not);
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

  // X10 = ((X12./auto./X3 + X14./manu./X3 + /(X11 + X13).X10)./Init./(X0 + X1) + X1)./AUdur
  or #GATE_NS X10$1$g (X10$1, X0, X1);
  not #GATE_NS auto$not$g (auto$not, auto);
  buf #GATE_NS X12$buf$g (X12$buf, X12);
  and #GATE_NS T12$clear$g (T12$clear, X12$buf, auto$not, X3$not);
  not #GATE_NS manu$not$g (manu$not, manu);
  buf #GATE_NS X14$buf$g (X14$buf, X14);
  and #GATE_NS T15$clear$g (T15$clear, X14$buf, manu$not, X3$not);
  or #GATE_NS X10$cdx$g (X10$cdx, X11, X13);
  not #GATE_NS X10$cdx$not$g (X10$cdx$not, X10$cdx);
  and #GATE_NS X10$hold$g (X10$hold, X10$cdx$not, X10);
  not #GATE_NS X10$1$not$g (X10$1$not, X10$1);
  buf #GATE_NS X1$buf$g (X1$buf, X1);
  buf #GATE_NS X1$buf$buf$g (X1$buf$buf, X1$buf);
  or #GATE_NS X10$free$g (X10$free, X10$1$not, X1$buf$buf);
  or #GATE_NS X10$free_of_init$g (X10$free_of_init, Init$not$buf$buf, X1$buf$buf);
  or #GATE_NS X10$or$g (X10$or, T12$clear, T15$clear, X10$hold, X1$buf$buf);
  and #GATE_NS X10$g (X10, X10$or, X10$free_of_init, X10$free, AUdur$not$buf$buf);

  // X11 = (X10.v0.h0.auto.↑dcy./X3 + /X12.X11)./Init./(X0 + X1)./AUdur
  buf #GATE_NS X10$buf$g (X10$buf, X10);
  buf #GATE_NS v0$buf$g (v0$buf, v0);
  buf #GATE_NS h0$buf$g (h0$buf, h0);
  buf #GATE_NS auto$buf$g (auto$buf, auto);
  and #GATE_NS T10$clear$g (T10$clear, X10$buf, v0$buf, h0$buf, auto$buf, dcy$rise2, X3$not);
  not #GATE_NS X12$not$g (X12$not, X12);
  and #GATE_NS X11$hold$g (X11$hold, X12$not, X11);
  or #GATE_NS X11$or$g (X11$or, T10$clear, X11$hold);
  and #GATE_NS X11$g (X11, X11$or, Init$not$buf$buf, X10$1$not, AUdur$not$buf$buf);

  // X12 = (X11./X3 + /X10.X12)./Init./(X0 + X1)./AUdur
  buf #GATE_NS X11$buf$g (X11$buf, X11);
  and #GATE_NS T11$clear$g (T11$clear, X11$buf, X3$not);
  not #GATE_NS X10$not$g (X10$not, X10);
  and #GATE_NS X12$hold$g (X12$hold, X10$not, X12);
  or #GATE_NS X12$or$g (X12$or, T11$clear, X12$hold);
  and #GATE_NS X12$g (X12, X12$or, Init$not$buf, X10$1$not, AUdur$not$buf);

  // X13 = (X10.manu./auto./X3 + /X14.X13)./Init./(X0 + X1)./AUdur
  buf #GATE_NS manu$buf$g (manu$buf, manu);
  and #GATE_NS T13$clear$g (T13$clear, X10$buf, manu$buf, auto$not, X3$not);
  not #GATE_NS X14$not$g (X14$not, X14);
  and #GATE_NS X13$hold$g (X13$hold, X14$not, X13);
  or #GATE_NS X13$or$g (X13$or, T13$clear, X13$hold);
  and #GATE_NS X13$g (X13, X13$or, Init$not$buf$buf, X10$1$not, AUdur$not$buf$buf);

  // X14 = (X13./X3 + /X10.X14)./Init./(X0 + X1)./AUdur
  buf #GATE_NS X13$buf$g (X13$buf, X13);
  and #GATE_NS T14$clear$g (T14$clear, X13$buf, X3$not);
  and #GATE_NS X14$hold$g (X14$hold, X10$not, X14);
  or #GATE_NS X14$or$g (X14$or, T14$clear, X14$hold);
  and #GATE_NS X14$g (X14, X14$or, Init$not$buf, X10$1$not, AUdur$not$buf);

  // X20 = ((X23 . 3s/X23./X3 + /X21.X20)./Init./(X0 + X10 + X11) + X11)./AUdur
  or #GATE_NS X20$1$g (X20$1, X0, X10, X11);
  grafwire_timer #(.GATE_NS(GATE_NS), .RISE_PS(64'd3000000000000), .FALL_PS(64'd0), .INIT(1'b0)) X23$timer0$g (.a(X23), .q(X23$timer0));  // 3s, 0s
  buf #GATE_NS X23$buf$g (X23$buf, X23);
  and #GATE_NS T23$clear$g (T23$clear, X23$buf, X23$timer0, X3$not);
  not #GATE_NS X21$not$g (X21$not, X21);
  and #GATE_NS X20$hold$g (X20$hold, X21$not, X20);
  not #GATE_NS X20$1$not$g (X20$1$not, X20$1);
  buf #GATE_NS X11$buf$buf$g (X11$buf$buf, X11$buf);
  or #GATE_NS X20$free$g (X20$free, X20$1$not, X11$buf$buf);
  or #GATE_NS X20$free_of_init$g (X20$free_of_init, Init$not$buf, X11$buf$buf);
  or #GATE_NS X20$or$g (X20$or, T23$clear, X20$hold, X11$buf$buf);
  and #GATE_NS X20$g (X20, X20$or, X20$free_of_init, X20$free, AUdur$not$buf);

  // X21 = (X20.h1./X3 + /X22.X21)./Init./(X0 + X10 + X11)./AUdur
  buf #GATE_NS X20$buf$g (X20$buf, X20);
  and #GATE_NS T20$clear$g (T20$clear, X20$buf, h1, X3$not);
  not #GATE_NS X22$not$g (X22$not, X22);
  and #GATE_NS X21$hold$g (X21$hold, X22$not, X21);
  or #GATE_NS X21$or$g (X21$or, T20$clear, X21$hold);
  and #GATE_NS X21$g (X21, X21$or, Init$not$buf, X20$1$not, AUdur$not$buf);

  // X22 = (X21.v1./X3 + /X23.X22)./Init./(X0 + X10 + X11)./AUdur
  buf #GATE_NS X21$buf$g (X21$buf, X21);
  and #GATE_NS T21$clear$g (T21$clear, X21$buf, v1, X3$not);
  not #GATE_NS X23$not$g (X23$not, X23);
  and #GATE_NS X22$hold$g (X22$hold, X23$not, X22);
  or #GATE_NS X22$or$g (X22$or, T21$clear, X22$hold);
  and #GATE_NS X22$g (X22, X22$or, Init$not$buf, X20$1$not, AUdur$not$buf);

  // X23 = (X22.h0./X3 + /X20.X23)./Init./(X0 + X10 + X11)./AUdur
  buf #GATE_NS X22$buf$g (X22$buf, X22);
  and #GATE_NS T22$clear$g (T22$clear, X22$buf, h0, X3$not);
  not #GATE_NS X20$not$g (X20$not, X20);
  and #GATE_NS X23$hold$g (X23$hold, X20$not, X23);
  or #GATE_NS X23$or$g (X23$or, T22$clear, X23$hold);
  and #GATE_NS X23$g (X23, X23$or, Init$not$buf, X20$1$not, AUdur$not$buf);

  // X30 = ((X31./vh./X3 + X32./vv./X3 + /(X31 + X32).X30)./Init./(X0 + X10 + X13) + X13)./AUdur
  or #GATE_NS X30$1$g (X30$1, X0, X10, X13);
  not #GATE_NS vh$not$g (vh$not, vh);
  buf #GATE_NS X3$not$buf$g (X3$not$buf, X3$not);
  buf #GATE_NS X3$not$buf$buf$g (X3$not$buf$buf, X3$not$buf);
  buf #GATE_NS X3$not$buf$buf$buf$g (X3$not$buf$buf$buf, X3$not$buf$buf);
  buf #GATE_NS X3$not$buf$buf$buf$buf$g (X3$not$buf$buf$buf$buf, X3$not$buf$buf$buf);
  buf #GATE_NS X31$buf$g (X31$buf, X31);
  buf #GATE_NS X31$buf$buf$g (X31$buf$buf, X31$buf);
  buf #GATE_NS X31$buf$buf$buf$g (X31$buf$buf$buf, X31$buf$buf);
  buf #GATE_NS X31$buf$buf$buf$buf$g (X31$buf$buf$buf$buf, X31$buf$buf$buf);
  buf #GATE_NS X31$buf$buf$buf$buf$buf$g (X31$buf$buf$buf$buf$buf, X31$buf$buf$buf$buf);
  and #GATE_NS T31$clear$g (T31$clear, X31$buf$buf$buf$buf$buf, vh$not, X3$not$buf$buf$buf$buf);
  not #GATE_NS vv$not$g (vv$not, vv);
  buf #GATE_NS X32$buf$g (X32$buf, X32);
  buf #GATE_NS X32$buf$buf$g (X32$buf$buf, X32$buf);
  buf #GATE_NS X32$buf$buf$buf$g (X32$buf$buf$buf, X32$buf$buf);
  buf #GATE_NS X32$buf$buf$buf$buf$g (X32$buf$buf$buf$buf, X32$buf$buf$buf);
  buf #GATE_NS X32$buf$buf$buf$buf$buf$g (X32$buf$buf$buf$buf$buf, X32$buf$buf$buf$buf);
  and #GATE_NS T33$clear$g (T33$clear, X32$buf$buf$buf$buf$buf, vv$not, X3$not$buf$buf$buf$buf);
  or #GATE_NS X30$cdx$g (X30$cdx, X31, X32);
  not #GATE_NS X30$cdx$not$g (X30$cdx$not, X30$cdx);
  and #GATE_NS X30$hold$g (X30$hold, X30$cdx$not, X30);
  not #GATE_NS X30$1$not$g (X30$1$not, X30$1);
  buf #GATE_NS X13$buf$buf$g (X13$buf$buf, X13$buf);
  or #GATE_NS X30$free$g (X30$free, X30$1$not, X13$buf$buf);
  or #GATE_NS X30$free_of_init$g (X30$free_of_init, Init$not$buf$buf, X13$buf$buf);
  or #GATE_NS X30$or$g (X30$or, T31$clear, T33$clear, X30$hold, X13$buf$buf);
  and #GATE_NS X30$g (X30, X30$or, X30$free_of_init, X30$free, AUdur$not$buf$buf);

  // X31 = (X30.vh./X3 + /X30.X31)./Init./(X0 + X10 + X13)./AUdur
  buf #GATE_NS X30$buf$g (X30$buf, X30);
  buf #GATE_NS X30$buf$buf$g (X30$buf$buf, X30$buf);
  buf #GATE_NS X30$buf$buf$buf$g (X30$buf$buf$buf, X30$buf$buf);
  buf #GATE_NS X30$buf$buf$buf$buf$g (X30$buf$buf$buf$buf, X30$buf$buf$buf);
  buf #GATE_NS X30$buf$buf$buf$buf$buf$g (X30$buf$buf$buf$buf$buf, X30$buf$buf$buf$buf);
  and #GATE_NS T30$clear$g (T30$clear, X30$buf$buf$buf$buf$buf, vh, X3$not$buf$buf$buf$buf);
  not #GATE_NS X30$not$g (X30$not, X30);
  and #GATE_NS X31$hold$g (X31$hold, X30$not, X31);
  or #GATE_NS X31$or$g (X31$or, T30$clear, X31$hold);
  and #GATE_NS X31$g (X31, X31$or, Init$not$buf, X30$1$not, AUdur$not$buf);

  // X32 = (X30.vv./vh./X3 + /X30.X32)./Init./(X0 + X10 + X13)./AUdur
  buf #GATE_NS vv$buf$g (vv$buf, vv);
  and #GATE_NS T32$clear$g (T32$clear, X30$buf$buf$buf$buf$buf, vv$buf, vh$not, X3$not$buf$buf$buf$buf);
  and #GATE_NS X32$hold$g (X32$hold, X30$not, X32);
  or #GATE_NS X32$or$g (X32$or, T32$clear, X32$hold);
  and #GATE_NS X32$g (X32, X32$or, Init$not$buf$buf, X30$1$not, AUdur$not$buf$buf);

  // V+ = (X21 + X32.manual_up)./AUdoux
  and #GATE_NS \V+$1$g  (\V+$1 , X32$buf$buf$buf$buf, manual_up);
  buf #GATE_NS X21$buf$buf$g (X21$buf$buf, X21$buf);
  buf #GATE_NS X21$buf$buf$buf$g (X21$buf$buf$buf, X21$buf$buf);
  buf #GATE_NS X21$buf$buf$buf$buf$g (X21$buf$buf$buf$buf, X21$buf$buf$buf);
  buf #GATE_NS X21$buf$buf$buf$buf$buf$g (X21$buf$buf$buf$buf$buf, X21$buf$buf$buf$buf);
  or #GATE_NS \V+$2$g  (\V+$2 , X21$buf$buf$buf$buf$buf, \V+$1 );
  not #GATE_NS AUdoux$not$g (AUdoux$not, AUdoux);
  and #GATE_NS \V+$g  (\V+ , \V+$2 , AUdoux$not);

  // H- = (X22.v0 + X31.b)./AUdoux
  and #GATE_NS \H-$1$g  (\H-$1 , X22, v0);
  and #GATE_NS \H-$2$g  (\H-$2 , X31, b);
  or #GATE_NS \H-$3$g  (\H-$3 , \H-$1 , \H-$2 );
  buf #GATE_NS AUdoux$not$buf$g (AUdoux$not$buf, AUdoux$not);
  and #GATE_NS \H-$g  (\H- , \H-$3 , AUdoux$not$buf);

  // H+ = (X20 + X31.a)./AUdoux
  and #GATE_NS \H+$1$g  (\H+$1 , X31, a);
  or #GATE_NS \H+$2$g  (\H+$2 , X20$buf, \H+$1 );
  and #GATE_NS \H+$g  (\H+ , \H+$2 , AUdoux$not$buf);

  // Voyant CI = (X0.v0.h0 + X1.v0.h0 + X2.v0.h0 + X3.v0.h0)./AUdoux
  and #GATE_NS \Voyant%20CI$1$g  (\Voyant%20CI$1 , X0, v0, h0);
  and #GATE_NS \Voyant%20CI$2$g  (\Voyant%20CI$2 , X1, v0, h0);
  and #GATE_NS \Voyant%20CI$3$g  (\Voyant%20CI$3 , X2, v0, h0);
  and #GATE_NS \Voyant%20CI$4$g  (\Voyant%20CI$4 , X3, v0, h0);
  or #GATE_NS \Voyant%20CI$5$g  (\Voyant%20CI$5 , \Voyant%20CI$1 , \Voyant%20CI$2 , \Voyant%20CI$3 , \Voyant%20CI$4 );
  and #GATE_NS \Voyant%20CI$g  (\Voyant%20CI , \Voyant%20CI$5 , AUdoux$not$buf);

  // Voyant Auto = X12./AUdoux
  and #GATE_NS \Voyant%20Auto$g  (\Voyant%20Auto , X12, AUdoux$not);

  // Voyant Manu = X14./AUdoux
  and #GATE_NS \Voyant%20Manu$g  (\Voyant%20Manu , X14, AUdoux$not);

  // manual_up: set X32.(↑(a.X32) + ↑b).a reset ↓X32./(X32.(↑(a.X32) + ↑b)) + ↑X32./(X32.(↑(a.X32) + ↑b)) + X32.(↑(a.X32) + ↑b)./a
  and #GATE_NS manual_up$1$g (manual_up$1, a, X32);
  grafwire_rise_pulse #(.GATE_NS(GATE_NS), .WIDTH_NS(3 * GATE_NS)) manual_up$1$rise0$g (.a(manual_up$1), .q(manual_up$1$rise0));
  grafwire_rise_pulse #(.GATE_NS(GATE_NS), .WIDTH_NS(3 * GATE_NS)) b$rise1$g (.a(b), .q(b$rise1));
  buf #GATE_NS b$rise1$buf$g (b$rise1$buf, b$rise1);
  or #GATE_NS manual_up$2$g (manual_up$2, manual_up$1$rise0, b$rise1$buf);
  and #GATE_NS manual_up$3$g (manual_up$3, X32$buf$buf$buf, manual_up$2);
  and #GATE_NS manual_up$set2$g (manual_up$set2, manual_up$3, a);
  not #GATE_NS a$not$g (a$not, a);
  and #GATE_NS manual_up$reset2$g (manual_up$reset2, manual_up$3, a$not);
  grafwire_rise_pulse #(.GATE_NS(GATE_NS), .WIDTH_NS(3 * GATE_NS)) X32$rise4$g (.a(X32), .q(X32$rise4));
  not #GATE_NS manual_up$3$not$g (manual_up$3$not, manual_up$3);
  and #GATE_NS manual_up$reset1$g (manual_up$reset1, X32$rise4, manual_up$3$not);
  grafwire_fall_pulse #(.GATE_NS(GATE_NS), .WIDTH_NS(3 * GATE_NS)) X32$fall3$g (.a(X32), .q(X32$fall3));
  not #GATE_NS X32$rise4$not$g (X32$rise4$not, X32$rise4);
  and #GATE_NS manual_up$reset0$g (manual_up$reset0, X32$fall3, manual_up$3$not, X32$rise4$not);
  or #GATE_NS manual_up$reset$g (manual_up$reset, manual_up$reset0, manual_up$reset1, manual_up$reset2);
  grafwire_latch #(.GATE_NS(GATE_NS), .INIT(1'b0)) manual_up$g (.s(manual_up$set2), .r(manual_up$reset), .q(manual_up));
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
