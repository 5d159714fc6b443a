// nine_steps "Exercice : GRAFCET à neuf étapes" (nine-steps.grafcet): 43 cells.
// Style rs, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist nine-steps.grafcet --style rs --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $init    Init activates the step
//   $not     the owner inverted
//   $q       the other gate of the latch
//   $resetN  resets the owner: term N of CDX, or write N
//   $setT    sets the owner: of a step, by transition T; of others, write T
// GATE_NS is how long a gate takes, in ns. Pulses last several gate delays and grow with it.
`timescale 1ns/1ps

module nine_steps #(parameter GATE_NS = 1) (
  input m,
  input a,
  input b,
  input c,
  input d1,
  input d2,
  input e,
  input f,
  input Init,
  input AUdur,
  input AUdoux,
  output X1,
  output X2,
  output X3,
  output X4,
  output X5,
  output X6,
  output X7,
  output X8,
  output X9,
  output A
);
  wire Init$not, AUdur$not;
  wire X1$set4, X1$init, X1$reset0, X1$q;
  wire X2$set1, X2$reset0, X2$q;
  wire X3$set2, X3$reset0, X3$q;
  wire X4$set3, X4$reset0, X4$q;
  wire X5$set1, X5$reset0, X5$q;
  wire X6$set5, X6$reset0, X6$reset1, X6$q;
  wire X7$set6, X7$reset0, X7$q;
  wire X8$set7, X8$set9, X8$reset0, X8$q;
  wire X9$set8, X9$reset0, X9$q;
  wire AUdoux$not;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);

  // X1 = (X4.X8 + /(X2.X5).X1 + Init)./AUdur
  nand #GATE_NS X1$set4$g (X1$set4, X4, X8, AUdur$not);
  nand #GATE_NS X1$init$g (X1$init, Init, AUdur$not);
  nand #GATE_NS X1$reset0$g (X1$reset0, X2, X5);
  nand #GATE_NS X1$g (X1, X1$set4, X1$init, X1$q);
  nand #GATE_NS X1$q$g (X1$q, X1$reset0, AUdur$not, X1);

  // X2 = (X1.m + /X3.X2)./Init./AUdur
  nand #GATE_NS X2$set1$g (X2$set1, X1, m, Init$not, AUdur$not);
  not #GATE_NS X2$reset0$g (X2$reset0, X3);
  nand #GATE_NS X2$g (X2, X2$set1, X2$q);
  nand #GATE_NS X2$q$g (X2$q, X2$reset0, Init$not, AUdur$not, X2);

  // X3 = (X2.b + /X4.X3)./Init./AUdur
  nand #GATE_NS X3$set2$g (X3$set2, X2, b, Init$not, AUdur$not);
  not #GATE_NS X3$reset0$g (X3$reset0, X4);
  nand #GATE_NS X3$g (X3, X3$set2, X3$q);
  nand #GATE_NS X3$q$g (X3$q, X3$reset0, Init$not, AUdur$not, X3);

  // X4 = (X3.c + /X1.X4)./Init./AUdur
  nand #GATE_NS X4$set3$g (X4$set3, X3, c, Init$not, AUdur$not);
  not #GATE_NS X4$reset0$g (X4$reset0, X1);
  nand #GATE_NS X4$g (X4, X4$set3, X4$q);
  nand #GATE_NS X4$q$g (X4$q, X4$reset0, Init$not, AUdur$not, X4);

  // X5 = (X1.m + /X6.X5)./Init./AUdur
  nand #GATE_NS X5$set1$g (X5$set1, X1, m, Init$not, AUdur$not);
  not #GATE_NS X5$reset0$g (X5$reset0, X6);
  nand #GATE_NS X5$g (X5, X5$set1, X5$q);
  nand #GATE_NS X5$q$g (X5$q, X5$reset0, Init$not, AUdur$not, X5);

  // X6 = (X5.a + /(X7 + X9).X6)./Init./AUdur
  nand #GATE_NS X6$set5$g (X6$set5, X5, a, Init$not, AUdur$not);
  not #GATE_NS X6$reset0$g (X6$reset0, X7);
  not #GATE_NS X6$reset1$g (X6$reset1, X9);
  nand #GATE_NS X6$g (X6, X6$set5, X6$q);
  nand #GATE_NS X6$q$g (X6$q, X6$reset0, X6$reset1, Init$not, AUdur$not, X6);

  // X7 = (X6.d1 + /X8.X7)./Init./AUdur
  nand #GATE_NS X7$set6$g (X7$set6, X6, d1, Init$not, AUdur$not);
  not #GATE_NS X7$reset0$g (X7$reset0, X8);
  nand #GATE_NS X7$g (X7, X7$set6, X7$q);
  nand #GATE_NS X7$q$g (X7$q, X7$reset0, Init$not, AUdur$not, X7);

  // X8 = (X7.e + X9.f + /X1.X8)./Init./AUdur
  nand #GATE_NS X8$set7$g (X8$set7, X7, e, Init$not, AUdur$not);
  nand #GATE_NS X8$set9$g (X8$set9, X9, f, Init$not, AUdur$not);
  not #GATE_NS X8$reset0$g (X8$reset0, X1);
  nand #GATE_NS X8$g (X8, X8$set7, X8$set9, X8$q);
  nand #GATE_NS X8$q$g (X8$q, X8$reset0, Init$not, AUdur$not, X8);

  // X9 = (X6.d2 + /X8.X9)./Init./AUdur
  nand #GATE_NS X9$set8$g (X9$set8, X6, d2, Init$not, AUdur$not);
  not #GATE_NS X9$reset0$g (X9$reset0, X8);
  nand #GATE_NS X9$g (X9, X9$set8, X9$q);
  nand #GATE_NS X9$q$g (X9$q, X9$reset0, Init$not, AUdur$not, X9);

  // A = X3./AUdoux
  not #GATE_NS AUdoux$not$g (AUdoux$not, AUdoux);
  and #GATE_NS A$g (A, X3, AUdoux$not);
endmodule
