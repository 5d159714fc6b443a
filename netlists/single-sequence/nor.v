// single_sequence "Séquence unique" (single-sequence.grafcet): 16 cells.
// Style nor, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist single-sequence.grafcet --style nor --cdx successor --modes on --to verilog
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
  wire X0$reset0, X0$reset0$not, X0$set2, X0$init, X0$q;
  wire X2$not, X1$set0, X1$q;
  wire X0$not, X2$set1, X2$q;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);

  // X0 = (X2.b + /X1.X0 + Init)./AUdur
  and #GATE_NS X0$reset0$g (X0$reset0, X1, Init$not);
  not #GATE_NS X0$reset0$not$g (X0$reset0$not, X0$reset0);
  and #GATE_NS X0$set2$g (X0$set2, X2, b, X0$reset0$not, AUdur$not);
  and #GATE_NS X0$init$g (X0$init, Init, X0$reset0$not, AUdur$not);
  nor #GATE_NS X0$g (X0, X0$reset0, AUdur, X0$q);
  nor #GATE_NS X0$q$g (X0$q, X0$set2, X0$init, X0);

  // X1 = (X0.m + /X2.X1)./Init./AUdur
  not #GATE_NS X2$not$g (X2$not, X2);
  and #GATE_NS X1$set0$g (X1$set0, X0, m, X2$not, Init$not, AUdur$not);
  nor #GATE_NS X1$g (X1, X2, Init, AUdur, X1$q);
  nor #GATE_NS X1$q$g (X1$q, X1$set0, X1);

  // X2 = (X1.a + /X0.X2)./Init./AUdur
  not #GATE_NS X0$not$g (X0$not, X0);
  and #GATE_NS X2$set1$g (X2$set1, X1, a, X0$not, Init$not, AUdur$not);
  nor #GATE_NS X2$g (X2, X0, Init, AUdur, X2$q);
  nor #GATE_NS X2$q$g (X2$q, X2$set1, X2);
endmodule
