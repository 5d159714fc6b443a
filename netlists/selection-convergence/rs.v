// selection_convergence "Choix de séquence, convergence" (selection-convergence.grafcet): 34 cells.
// Style rs, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist selection-convergence.grafcet --style rs --cdx successor --modes on --to verilog
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
  wire f$not, X0$set7, X0$init, X0$reset0, X0$reset1, X0$q;
  wire X30$set0, X30$reset0, X30$q;
  wire X31$set30, X31$reset0, X31$q;
  wire X47$set1, X47$reset0, X47$q;
  wire X48$set47, X48$reset0, X48$q;
  wire X6$set31, X6$set48, X6$reset0, X6$q;
  wire X7$set6, X7$reset0, X7$q;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);

  // X0 = (X7./f + /(X30 + X47).X0 + Init)./AUdur
  not #GATE_NS f$not$g (f$not, f);
  nand #GATE_NS X0$set7$g (X0$set7, X7, f$not, AUdur$not);
  nand #GATE_NS X0$init$g (X0$init, Init, AUdur$not);
  not #GATE_NS X0$reset0$g (X0$reset0, X30);
  not #GATE_NS X0$reset1$g (X0$reset1, X47);
  nand #GATE_NS X0$g (X0, X0$set7, X0$init, X0$q);
  nand #GATE_NS X0$q$g (X0$q, X0$reset0, X0$reset1, AUdur$not, X0);

  // X30 = (X0.x + /X31.X30)./Init./AUdur
  nand #GATE_NS X30$set0$g (X30$set0, X0, x, Init$not, AUdur$not);
  not #GATE_NS X30$reset0$g (X30$reset0, X31);
  nand #GATE_NS X30$g (X30, X30$set0, X30$q);
  nand #GATE_NS X30$q$g (X30$q, X30$reset0, Init$not, AUdur$not, X30);

  // X31 = (X30.b + /X6.X31)./Init./AUdur
  nand #GATE_NS X31$set30$g (X31$set30, X30, b, Init$not, AUdur$not);
  not #GATE_NS X31$reset0$g (X31$reset0, X6);
  nand #GATE_NS X31$g (X31, X31$set30, X31$q);
  nand #GATE_NS X31$q$g (X31$q, X31$reset0, Init$not, AUdur$not, X31);

  // X47 = (X0.z + /X48.X47)./Init./AUdur
  nand #GATE_NS X47$set1$g (X47$set1, X0, z, Init$not, AUdur$not);
  not #GATE_NS X47$reset0$g (X47$reset0, X48);
  nand #GATE_NS X47$g (X47, X47$set1, X47$q);
  nand #GATE_NS X47$q$g (X47$q, X47$reset0, Init$not, AUdur$not, X47);

  // X48 = (X47.c + /X6.X48)./Init./AUdur
  nand #GATE_NS X48$set47$g (X48$set47, X47, c, Init$not, AUdur$not);
  not #GATE_NS X48$reset0$g (X48$reset0, X6);
  nand #GATE_NS X48$g (X48, X48$set47, X48$q);
  nand #GATE_NS X48$q$g (X48$q, X48$reset0, Init$not, AUdur$not, X48);

  // X6 = (X31.d + X48.e + /X7.X6)./Init./AUdur
  nand #GATE_NS X6$set31$g (X6$set31, X31, d, Init$not, AUdur$not);
  nand #GATE_NS X6$set48$g (X6$set48, X48, e, Init$not, AUdur$not);
  not #GATE_NS X6$reset0$g (X6$reset0, X7);
  nand #GATE_NS X6$g (X6, X6$set31, X6$set48, X6$q);
  nand #GATE_NS X6$q$g (X6$q, X6$reset0, Init$not, AUdur$not, X6);

  // X7 = (X6.f + /X0.X7)./Init./AUdur
  nand #GATE_NS X7$set6$g (X7$set6, X6, f, Init$not, AUdur$not);
  not #GATE_NS X7$reset0$g (X7$reset0, X0);
  nand #GATE_NS X7$g (X7, X7$set6, X7$q);
  nand #GATE_NS X7$q$g (X7$q, X7$reset0, Init$not, AUdur$not, X7);
endmodule
