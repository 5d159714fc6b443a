// single_sequence "Séquence unique" (single-sequence.grafcet): 15 cells.
// Style rs, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist single-sequence.grafcet --style rs --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $init    Init activates the step
//   $not     the owner inverted
//   $q       the other gate of the latch
//   $resetN  resets the owner: term N of CDX, or write N
//   $setT    sets the owner: of a step, by transition T; of others, write T
// GATE_NS is how long a gate takes, in ns. Pulses last several gate delays and grow with it.
`timescale 1ns/1ps

module single_sequence #(parameter GATE_NS = 1) (
  input m,
  input a,
  input b,
  input Init,
  input AUdur,
  input AUdoux,
  output X0,
  output X1,
  output X2
);
  wire Init$not, AUdur$not;
  wire X0$set2, X0$init, X0$reset0, X0$q;
  wire X1$set0, X1$reset0, X1$q;
  wire X2$set1, X2$reset0, X2$q;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);

  // X0 = (X2.b + /X1.X0 + Init)./AUdur
  nand #GATE_NS X0$set2$g (X0$set2, X2, b, AUdur$not);
  nand #GATE_NS X0$init$g (X0$init, Init, AUdur$not);
  not #GATE_NS X0$reset0$g (X0$reset0, X1);
  nand #GATE_NS X0$g (X0, X0$set2, X0$init, X0$q);
  nand #GATE_NS X0$q$g (X0$q, X0$reset0, AUdur$not, X0);

  // X1 = (X0.m + /X2.X1)./Init./AUdur
  nand #GATE_NS X1$set0$g (X1$set0, X0, m, Init$not, AUdur$not);
  not #GATE_NS X1$reset0$g (X1$reset0, X2);
  nand #GATE_NS X1$g (X1, X1$set0, X1$q);
  nand #GATE_NS X1$q$g (X1$q, X1$reset0, Init$not, AUdur$not, X1);

  // X2 = (X1.a + /X0.X2)./Init./AUdur
  nand #GATE_NS X2$set1$g (X2$set1, X1, a, Init$not, AUdur$not);
  not #GATE_NS X2$reset0$g (X2$reset0, X0);
  nand #GATE_NS X2$g (X2, X2$set1, X2$q);
  nand #GATE_NS X2$q$g (X2$q, X2$reset0, Init$not, AUdur$not, X2);
endmodule
