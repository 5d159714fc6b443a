// rule_5 "Règle n° 5" (rule-5.grafcet): 15 cells.
// Style rs, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist rule-5.grafcet --style rs --cdx successor --modes on --to verilog
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
  wire X1$set0, X1$reset0, X1$q;
  wire T2$clear, X2$set1, X2$init, X2$reset0, X2$q;
  wire AUdoux$not;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);

  // X1 = (s + /X2.X1)./Init./AUdur
  nand #GATE_NS X1$set0$g (X1$set0, s, Init$not, AUdur$not);
  not #GATE_NS X1$reset0$g (X1$reset0, X2);
  nand #GATE_NS X1$g (X1, X1$set0, X1$q);
  nand #GATE_NS X1$q$g (X1$q, X1$reset0, Init$not, AUdur$not, X1);

  // X2 = (X1 + /(X2.k).X2 + Init)./AUdur
  and #GATE_NS T2$clear$g (T2$clear, X2, k);
  nand #GATE_NS X2$set1$g (X2$set1, X1, AUdur$not);
  nand #GATE_NS X2$init$g (X2$init, Init, AUdur$not);
  not #GATE_NS X2$reset0$g (X2$reset0, T2$clear);
  nand #GATE_NS X2$g (X2, X2$set1, X2$init, X2$q);
  nand #GATE_NS X2$q$g (X2$q, X2$reset0, AUdur$not, X2);

  // present = X1./AUdoux
  not #GATE_NS AUdoux$not$g (AUdoux$not, AUdoux);
  and #GATE_NS present$g (present, X1, AUdoux$not);

  // loaded = X2./AUdoux
  and #GATE_NS loaded$g (loaded, X2, AUdoux$not);
endmodule
