// manipulator_modes "Manipulateur en L, marches automatique et manuelle" (manipulator-modes.grafcet): 168 cells.
// Style rs, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist manipulator-modes.grafcet --style rs --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $N         a gate of a condition of the owner
//   $buf       the owner, a gate delay later
//   $clear     of a transition: it is cleared; of a step: Init deactivates it
//   $fallN     falling edge of the owner, edge N of the chart
//   $forced    a forcing order activates the step
//   $init      Init activates the step
//   $not       the owner inverted
//   $q         the other gate of the latch
//   $reset     resets the owner
//   $resetN    resets the owner: term N of CDX, or write N
//   $riseN     rising edge of the owner, edge N of the chart
//   $setT      sets the owner: of a step, by transition T; of others, write T
//   $timerN    time condition N of the chart, counted from 0, of the owner
//   $unforced  a forcing order deactivates the step
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
  wire au$not, X0$set3, X0$init, X0$reset0, X0$q;
  wire dcy$rise2, X1$set0, X1$reset0, X1$q;
  wire X2$set1, X2$reset0, X2$q;
  wire X3$set2, X3$reset0, X3$q;
  wire X10$1, auto$not, X3$not, X12$buf, X10$1$not, X10$set12, manu$not, X14$buf, X10$set15, X10$forced, X10$reset0, X10$reset1, X10$unforced, X10$clear, X10$q;
  wire X10$buf, v0$buf, h0$buf, auto$buf, X11$set10, X11$reset0, X11$q;
  wire X11$buf, X12$set11, X12$reset0, X12$q;
  wire manu$buf, X13$set13, X13$reset0, X13$q;
  wire X13$buf, X14$set14, X14$reset0, X14$q;
  wire X20$1, X23$timer0, X23$buf, X20$1$not, X20$set23, X20$forced, X20$reset0, X20$unforced, X20$clear, X20$q;
  wire X20$buf, X21$set20, X21$reset0, X21$q;
  wire X21$buf, X22$set21, X22$reset0, X22$q;
  wire X22$buf, X23$set22, X23$reset0, X23$q;
  wire X30$1, vh$not, X3$not$buf, X3$not$buf$buf, X3$not$buf$buf$buf, X3$not$buf$buf$buf$buf, X31$buf, X31$buf$buf, X31$buf$buf$buf, X31$buf$buf$buf$buf, X31$buf$buf$buf$buf$buf, X30$1$not, X30$set31, vv$not, X32$buf, X32$buf$buf, X32$buf$buf$buf, X32$buf$buf$buf$buf, X32$buf$buf$buf$buf$buf, X30$set33, X30$forced, X30$reset0, X30$reset1, X30$unforced, X30$clear, X30$q;
  wire X30$buf, X30$buf$buf, X30$buf$buf$buf, X30$buf$buf$buf$buf, X30$buf$buf$buf$buf$buf, X31$set30, X31$reset0, X31$q;
  wire vv$buf, X32$set32, X32$reset0, X32$q;
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
  nand #GATE_NS X0$set3$g (X0$set3, X3, au$not, AUdur$not);
  nand #GATE_NS X0$init$g (X0$init, Init, AUdur$not);
  not #GATE_NS X0$reset0$g (X0$reset0, X1);
  nand #GATE_NS X0$g (X0, X0$set3, X0$init, X0$q);
  nand #GATE_NS X0$q$g (X0$q, X0$reset0, AUdur$not, X0);

  // X1 = (X0.↑dcy./au + /X2.X1)./Init./AUdur
  grafwire_rise_pulse #(.GATE_NS(GATE_NS), .WIDTH_NS(2 * GATE_NS)) dcy$rise2$g (.a(dcy), .q(dcy$rise2));
  nand #GATE_NS X1$set0$g (X1$set0, X0, dcy$rise2, au$not, Init$not, AUdur$not);
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

  // X10 = ((X12./auto./X3 + X14./manu./X3 + /(X11 + X13).X10)./Init./(X0 + X1) + X1)./AUdur
  or #GATE_NS X10$1$g (X10$1, X0, X1);
  not #GATE_NS auto$not$g (auto$not, auto);
  not #GATE_NS X3$not$g (X3$not, X3);
  buf #GATE_NS X12$buf$g (X12$buf, X12);
  not #GATE_NS X10$1$not$g (X10$1$not, X10$1);
  nand #GATE_NS X10$set12$g (X10$set12, X12$buf, auto$not, X3$not, Init$not, X10$1$not, AUdur$not);
  not #GATE_NS manu$not$g (manu$not, manu);
  buf #GATE_NS X14$buf$g (X14$buf, X14);
  nand #GATE_NS X10$set15$g (X10$set15, X14$buf, manu$not, X3$not, Init$not, X10$1$not, AUdur$not);
  nand #GATE_NS X10$forced$g (X10$forced, X1, AUdur$not);
  not #GATE_NS X10$reset0$g (X10$reset0, X11);
  not #GATE_NS X10$reset1$g (X10$reset1, X13);
  nand #GATE_NS X10$unforced$g (X10$unforced, X10$1, X10$forced);
  nand #GATE_NS X10$clear$g (X10$clear, Init, X10$forced);
  nand #GATE_NS X10$g (X10, X10$set12, X10$set15, X10$forced, X10$q);
  nand #GATE_NS X10$q$g (X10$q, X10$reset0, X10$reset1, X10$unforced, X10$clear, AUdur$not, X10);

  // X11 = (X10.v0.h0.auto.↑dcy./X3 + /X12.X11)./Init./(X0 + X1)./AUdur
  buf #GATE_NS X10$buf$g (X10$buf, X10);
  buf #GATE_NS v0$buf$g (v0$buf, v0);
  buf #GATE_NS h0$buf$g (h0$buf, h0);
  buf #GATE_NS auto$buf$g (auto$buf, auto);
  nand #GATE_NS X11$set10$g (X11$set10, X10$buf, v0$buf, h0$buf, auto$buf, dcy$rise2, X3$not, Init$not, X10$1$not, AUdur$not);
  not #GATE_NS X11$reset0$g (X11$reset0, X12);
  nand #GATE_NS X11$g (X11, X11$set10, X11$q);
  nand #GATE_NS X11$q$g (X11$q, X11$reset0, X10$1$not, Init$not, AUdur$not, X11);

  // X12 = (X11./X3 + /X10.X12)./Init./(X0 + X1)./AUdur
  buf #GATE_NS X11$buf$g (X11$buf, X11);
  nand #GATE_NS X12$set11$g (X12$set11, X11$buf, X3$not, Init$not, X10$1$not, AUdur$not);
  not #GATE_NS X12$reset0$g (X12$reset0, X10);
  nand #GATE_NS X12$g (X12, X12$set11, X12$q);
  nand #GATE_NS X12$q$g (X12$q, X12$reset0, X10$1$not, Init$not, AUdur$not, X12);

  // X13 = (X10.manu./auto./X3 + /X14.X13)./Init./(X0 + X1)./AUdur
  buf #GATE_NS manu$buf$g (manu$buf, manu);
  nand #GATE_NS X13$set13$g (X13$set13, X10$buf, manu$buf, auto$not, X3$not, Init$not, X10$1$not, AUdur$not);
  not #GATE_NS X13$reset0$g (X13$reset0, X14);
  nand #GATE_NS X13$g (X13, X13$set13, X13$q);
  nand #GATE_NS X13$q$g (X13$q, X13$reset0, X10$1$not, Init$not, AUdur$not, X13);

  // X14 = (X13./X3 + /X10.X14)./Init./(X0 + X1)./AUdur
  buf #GATE_NS X13$buf$g (X13$buf, X13);
  nand #GATE_NS X14$set14$g (X14$set14, X13$buf, X3$not, Init$not, X10$1$not, AUdur$not);
  not #GATE_NS X14$reset0$g (X14$reset0, X10);
  nand #GATE_NS X14$g (X14, X14$set14, X14$q);
  nand #GATE_NS X14$q$g (X14$q, X14$reset0, X10$1$not, Init$not, AUdur$not, X14);

  // X20 = ((X23 . 3s/X23./X3 + /X21.X20)./Init./(X0 + X10 + X11) + X11)./AUdur
  or #GATE_NS X20$1$g (X20$1, X0, X10, X11);
  grafwire_timer #(.GATE_NS(GATE_NS), .RISE_PS(64'd3000000000000), .FALL_PS(64'd0), .INIT(1'b0)) X23$timer0$g (.a(X23), .q(X23$timer0));  // 3s, 0s
  buf #GATE_NS X23$buf$g (X23$buf, X23);
  not #GATE_NS X20$1$not$g (X20$1$not, X20$1);
  nand #GATE_NS X20$set23$g (X20$set23, X23$buf, X23$timer0, X3$not, Init$not, X20$1$not, AUdur$not);
  nand #GATE_NS X20$forced$g (X20$forced, X11, AUdur$not);
  not #GATE_NS X20$reset0$g (X20$reset0, X21);
  nand #GATE_NS X20$unforced$g (X20$unforced, X20$1, X20$forced);
  nand #GATE_NS X20$clear$g (X20$clear, Init, X20$forced);
  nand #GATE_NS X20$g (X20, X20$set23, X20$forced, X20$q);
  nand #GATE_NS X20$q$g (X20$q, X20$reset0, X20$unforced, X20$clear, AUdur$not, X20);

  // X21 = (X20.h1./X3 + /X22.X21)./Init./(X0 + X10 + X11)./AUdur
  buf #GATE_NS X20$buf$g (X20$buf, X20);
  nand #GATE_NS X21$set20$g (X21$set20, X20$buf, h1, X3$not, Init$not, X20$1$not, AUdur$not);
  not #GATE_NS X21$reset0$g (X21$reset0, X22);
  nand #GATE_NS X21$g (X21, X21$set20, X21$q);
  nand #GATE_NS X21$q$g (X21$q, X21$reset0, X20$1$not, Init$not, AUdur$not, X21);

  // X22 = (X21.v1./X3 + /X23.X22)./Init./(X0 + X10 + X11)./AUdur
  buf #GATE_NS X21$buf$g (X21$buf, X21);
  nand #GATE_NS X22$set21$g (X22$set21, X21$buf, v1, X3$not, Init$not, X20$1$not, AUdur$not);
  not #GATE_NS X22$reset0$g (X22$reset0, X23);
  nand #GATE_NS X22$g (X22, X22$set21, X22$q);
  nand #GATE_NS X22$q$g (X22$q, X22$reset0, X20$1$not, Init$not, AUdur$not, X22);

  // X23 = (X22.h0./X3 + /X20.X23)./Init./(X0 + X10 + X11)./AUdur
  buf #GATE_NS X22$buf$g (X22$buf, X22);
  nand #GATE_NS X23$set22$g (X23$set22, X22$buf, h0, X3$not, Init$not, X20$1$not, AUdur$not);
  not #GATE_NS X23$reset0$g (X23$reset0, X20);
  nand #GATE_NS X23$g (X23, X23$set22, X23$q);
  nand #GATE_NS X23$q$g (X23$q, X23$reset0, X20$1$not, Init$not, AUdur$not, X23);

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
  not #GATE_NS X30$1$not$g (X30$1$not, X30$1);
  nand #GATE_NS X30$set31$g (X30$set31, X31$buf$buf$buf$buf$buf, vh$not, X3$not$buf$buf$buf$buf, Init$not, X30$1$not, AUdur$not);
  not #GATE_NS vv$not$g (vv$not, vv);
  buf #GATE_NS X32$buf$g (X32$buf, X32);
  buf #GATE_NS X32$buf$buf$g (X32$buf$buf, X32$buf);
  buf #GATE_NS X32$buf$buf$buf$g (X32$buf$buf$buf, X32$buf$buf);
  buf #GATE_NS X32$buf$buf$buf$buf$g (X32$buf$buf$buf$buf, X32$buf$buf$buf);
  buf #GATE_NS X32$buf$buf$buf$buf$buf$g (X32$buf$buf$buf$buf$buf, X32$buf$buf$buf$buf);
  nand #GATE_NS X30$set33$g (X30$set33, X32$buf$buf$buf$buf$buf, vv$not, X3$not$buf$buf$buf$buf, Init$not, X30$1$not, AUdur$not);
  nand #GATE_NS X30$forced$g (X30$forced, X13, AUdur$not);
  not #GATE_NS X30$reset0$g (X30$reset0, X31);
  not #GATE_NS X30$reset1$g (X30$reset1, X32);
  nand #GATE_NS X30$unforced$g (X30$unforced, X30$1, X30$forced);
  nand #GATE_NS X30$clear$g (X30$clear, Init, X30$forced);
  nand #GATE_NS X30$g (X30, X30$set31, X30$set33, X30$forced, X30$q);
  nand #GATE_NS X30$q$g (X30$q, X30$reset0, X30$reset1, X30$unforced, X30$clear, AUdur$not, X30);

  // X31 = (X30.vh./X3 + /X30.X31)./Init./(X0 + X10 + X13)./AUdur
  buf #GATE_NS X30$buf$g (X30$buf, X30);
  buf #GATE_NS X30$buf$buf$g (X30$buf$buf, X30$buf);
  buf #GATE_NS X30$buf$buf$buf$g (X30$buf$buf$buf, X30$buf$buf);
  buf #GATE_NS X30$buf$buf$buf$buf$g (X30$buf$buf$buf$buf, X30$buf$buf$buf);
  buf #GATE_NS X30$buf$buf$buf$buf$buf$g (X30$buf$buf$buf$buf$buf, X30$buf$buf$buf$buf);
  nand #GATE_NS X31$set30$g (X31$set30, X30$buf$buf$buf$buf$buf, vh, X3$not$buf$buf$buf$buf, Init$not, X30$1$not, AUdur$not);
  not #GATE_NS X31$reset0$g (X31$reset0, X30);
  nand #GATE_NS X31$g (X31, X31$set30, X31$q);
  nand #GATE_NS X31$q$g (X31$q, X31$reset0, X30$1$not, Init$not, AUdur$not, X31);

  // X32 = (X30.vv./vh./X3 + /X30.X32)./Init./(X0 + X10 + X13)./AUdur
  buf #GATE_NS vv$buf$g (vv$buf, vv);
  nand #GATE_NS X32$set32$g (X32$set32, X30$buf$buf$buf$buf$buf, vv$buf, vh$not, X3$not$buf$buf$buf$buf, Init$not, X30$1$not, AUdur$not);
  not #GATE_NS X32$reset0$g (X32$reset0, X30);
  nand #GATE_NS X32$g (X32, X32$set32, X32$q);
  nand #GATE_NS X32$q$g (X32$q, X32$reset0, X30$1$not, Init$not, AUdur$not, X32);

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
  grafwire_rise_pulse #(.GATE_NS(GATE_NS), .WIDTH_NS(2 * GATE_NS)) manual_up$1$rise0$g (.a(manual_up$1), .q(manual_up$1$rise0));
  grafwire_rise_pulse #(.GATE_NS(GATE_NS), .WIDTH_NS(2 * GATE_NS)) b$rise1$g (.a(b), .q(b$rise1));
  buf #GATE_NS b$rise1$buf$g (b$rise1$buf, b$rise1);
  or #GATE_NS manual_up$2$g (manual_up$2, manual_up$1$rise0, b$rise1$buf);
  and #GATE_NS manual_up$3$g (manual_up$3, X32$buf$buf$buf, manual_up$2);
  and #GATE_NS manual_up$set2$g (manual_up$set2, manual_up$3, a);
  not #GATE_NS a$not$g (a$not, a);
  and #GATE_NS manual_up$reset2$g (manual_up$reset2, manual_up$3, a$not);
  grafwire_rise_pulse #(.GATE_NS(GATE_NS), .WIDTH_NS(2 * GATE_NS)) X32$rise4$g (.a(X32), .q(X32$rise4));
  not #GATE_NS manual_up$3$not$g (manual_up$3$not, manual_up$3);
  and #GATE_NS manual_up$reset1$g (manual_up$reset1, X32$rise4, manual_up$3$not);
  grafwire_fall_pulse #(.GATE_NS(GATE_NS), .WIDTH_NS(2 * GATE_NS)) X32$fall3$g (.a(X32), .q(X32$fall3));
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
