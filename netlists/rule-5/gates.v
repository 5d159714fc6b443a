// rule_5 "Règle n° 5" (rule-5.grafcet): 16 cells.
// Style gates, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist rule-5.grafcet --style gates --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $buf    the owner, a gate delay later
//   $clear  of a transition: it is cleared; of a step: Init deactivates it
//   $hold   keeps the owner as it is
//   $not    the owner inverted
//   $or     all that makes the step active, or keeps it so
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
  wire X2$not, X1$hold, Init$not$buf, AUdur$not$buf, X1$or;
  wire T2$clear, T2$clear$not, X2$hold, X2$or;
  wire AUdoux$not;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);

  // X1 = (s + /X2.X1)./Init./AUdur
  not #GATE_NS X2$not$g (X2$not, X2);
  and #GATE_NS X1$hold$g (X1$hold, X2$not, X1);
  buf #GATE_NS Init$not$buf$g (Init$not$buf, Init$not);
  buf #GATE_NS AUdur$not$buf$g (AUdur$not$buf, AUdur$not);
  or #GATE_NS X1$or$g (X1$or, s, X1$hold);
  and #GATE_NS X1$g (X1, X1$or, Init$not$buf, AUdur$not$buf);

  // X2 = (X1 + /(X2.k).X2 + Init)./AUdur
  and #GATE_NS T2$clear$g (T2$clear, X2, k);
  not #GATE_NS T2$clear$not$g (T2$clear$not, T2$clear);
  and #GATE_NS X2$hold$g (X2$hold, T2$clear$not, X2);
  or #GATE_NS X2$or$g (X2$or, X1, X2$hold, Init);
  and #GATE_NS X2$g (X2, X2$or, AUdur$not$buf);

  // present = X1./AUdoux
  not #GATE_NS AUdoux$not$g (AUdoux$not, AUdoux);
  and #GATE_NS present$g (present, X1, AUdoux$not);

  // loaded = X2./AUdoux
  and #GATE_NS loaded$g (loaded, X2, AUdoux$not);
endmodule
