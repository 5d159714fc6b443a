// selection_convergence "Choix de séquence, convergence" (selection-convergence.grafcet): 35 cells.
// Style nor, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist selection-convergence.grafcet --style nor --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $init    Init activates the step
//   $not     the owner inverted
//   $q       the other gate of the latch
//   $resetN  resets the owner: term N of CDX, or write N
//   $setT    sets the owner: of a step, by transition T; of others, write T
// GATE_NS is how long a gate takes, in ns. Pulses last several gate delays and grow with it.
`timescale 1ns/1ps

module selection_convergence #(parameter GATE_NS = 1) (
  input x,
  input z,
  input b,
  input c,
  input d,
  input e,
  input f,
  input Init,
  input AUdur,
  input AUdoux,
  output X0,
  output X30,
  output X31,
  output X47,
  output X48,
  output X6,
  output X7
);
  wire Init$not, AUdur$not;
  wire X0$reset0, X0$reset1, f$not, X0$reset0$not, X0$reset1$not, X0$set7, X0$init, X0$q;
  wire X31$not, X30$set0, X30$q;
  wire X6$not, X31$set30, X31$q;
  wire X48$not, X47$set1, X47$q;
  wire X48$set47, X48$q;
  wire X7$not, X6$set31, X6$set48, X6$q;
  wire X0$not, X7$set6, X7$q;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);

  // X0 = (X7./f + /(X30 + X47).X0 + Init)./AUdur
  and #GATE_NS X0$reset0$g (X0$reset0, X30, Init$not);
  and #GATE_NS X0$reset1$g (X0$reset1, X47, Init$not);
  not #GATE_NS f$not$g (f$not, f);
  not #GATE_NS X0$reset0$not$g (X0$reset0$not, X0$reset0);
  not #GATE_NS X0$reset1$not$g (X0$reset1$not, X0$reset1);
  and #GATE_NS X0$set7$g (X0$set7, X7, f$not, X0$reset0$not, X0$reset1$not, AUdur$not);
  and #GATE_NS X0$init$g (X0$init, Init, X0$reset0$not, X0$reset1$not, AUdur$not);
  nor #GATE_NS X0$g (X0, X0$reset0, X0$reset1, AUdur, X0$q);
  nor #GATE_NS X0$q$g (X0$q, X0$set7, X0$init, X0);

  // X30 = (X0.x + /X31.X30)./Init./AUdur
  not #GATE_NS X31$not$g (X31$not, X31);
  and #GATE_NS X30$set0$g (X30$set0, X0, x, X31$not, Init$not, AUdur$not);
  nor #GATE_NS X30$g (X30, X31, Init, AUdur, X30$q);
  nor #GATE_NS X30$q$g (X30$q, X30$set0, X30);

  // X31 = (X30.b + /X6.X31)./Init./AUdur
  not #GATE_NS X6$not$g (X6$not, X6);
  and #GATE_NS X31$set30$g (X31$set30, X30, b, X6$not, Init$not, AUdur$not);
  nor #GATE_NS X31$g (X31, X6, Init, AUdur, X31$q);
  nor #GATE_NS X31$q$g (X31$q, X31$set30, X31);

  // X47 = (X0.z + /X48.X47)./Init./AUdur
  not #GATE_NS X48$not$g (X48$not, X48);
  and #GATE_NS X47$set1$g (X47$set1, X0, z, X48$not, Init$not, AUdur$not);
  nor #GATE_NS X47$g (X47, X48, Init, AUdur, X47$q);
  nor #GATE_NS X47$q$g (X47$q, X47$set1, X47);

  // X48 = (X47.c + /X6.X48)./Init./AUdur
  and #GATE_NS X48$set47$g (X48$set47, X47, c, X6$not, Init$not, AUdur$not);
  nor #GATE_NS X48$g (X48, X6, Init, AUdur, X48$q);
  nor #GATE_NS X48$q$g (X48$q, X48$set47, X48);

  // X6 = (X31.d + X48.e + /X7.X6)./Init./AUdur
  not #GATE_NS X7$not$g (X7$not, X7);
  and #GATE_NS X6$set31$g (X6$set31, X31, d, X7$not, Init$not, AUdur$not);
  and #GATE_NS X6$set48$g (X6$set48, X48, e, X7$not, Init$not, AUdur$not);
  nor #GATE_NS X6$g (X6, X7, Init, AUdur, X6$q);
  nor #GATE_NS X6$q$g (X6$q, X6$set31, X6$set48, X6);

  // X7 = (X6.f + /X0.X7)./Init./AUdur
  not #GATE_NS X0$not$g (X0$not, X0);
  and #GATE_NS X7$set6$g (X7$set6, X6, f, X0$not, Init$not, AUdur$not);
  nor #GATE_NS X7$g (X7, X0, Init, AUdur, X7$q);
  nor #GATE_NS X7$q$g (X7$q, X7$set6, X7);
endmodule
