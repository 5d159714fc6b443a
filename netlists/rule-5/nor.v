// rule_5 "Règle n° 5" (rule-5.grafcet): 16 cells.
// Style nor, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist rule-5.grafcet --style nor --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $clear   of a transition: it is cleared; of a step: Init deactivates it
//   $init    Init activates the step
//   $not     the owner inverted
//   $q       the other gate of the latch
//   $resetN  resets the owner: term N of CDX, or write N
//   $setT    sets the owner: of a step, by transition T; of others, write T
// GATE_NS is how long a gate takes, in ns. Pulses last several gate delays and grow with it.
`timescale 1ns/1ps

module rule_5 #(parameter GATE_NS = 1) (
  input s,
  input k,
  input Init,
  input AUdur,
  input AUdoux,
  output X1,
  output X2,
  output present,
  output loaded
);
  wire Init$not, AUdur$not;
  wire X2$not, X1$set0, X1$q;
  wire T2$clear, X2$reset0, X2$reset0$not, X2$set1, X2$init, X2$q;
  wire AUdoux$not;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);

  // X1 = (s + /X2.X1)./Init./AUdur
  not #GATE_NS X2$not$g (X2$not, X2);
  and #GATE_NS X1$set0$g (X1$set0, s, X2$not, Init$not, AUdur$not);
  nor #GATE_NS X1$g (X1, X2, Init, AUdur, X1$q);
  nor #GATE_NS X1$q$g (X1$q, X1$set0, X1);

  // X2 = (X1 + /(X2.k).X2 + Init)./AUdur
  and #GATE_NS T2$clear$g (T2$clear, X2, k);
  and #GATE_NS X2$reset0$g (X2$reset0, T2$clear, Init$not);
  not #GATE_NS X2$reset0$not$g (X2$reset0$not, X2$reset0);
  and #GATE_NS X2$set1$g (X2$set1, X1, X2$reset0$not, AUdur$not);
  and #GATE_NS X2$init$g (X2$init, Init, X2$reset0$not, AUdur$not);
  nor #GATE_NS X2$g (X2, X2$reset0, AUdur, X2$q);
  nor #GATE_NS X2$q$g (X2$q, X2$set1, X2$init, X2);

  // present = X1./AUdoux
  not #GATE_NS AUdoux$not$g (AUdoux$not, AUdoux);
  and #GATE_NS present$g (present, X1, AUdoux$not);

  // loaded = X2./AUdoux
  and #GATE_NS loaded$g (loaded, X2, AUdoux$not);
endmodule
