// single_sequence "Séquence unique" (single-sequence.grafcet): 19 cells.
// Style gates, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist single-sequence.grafcet --style gates --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $buf    the owner, a gate delay later
//   $clear  of a transition: it is cleared; of a step: Init deactivates it
//   $hold   keeps the owner as it is
//   $not    the owner inverted
//   $or     all that makes the step active, or keeps it so
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
  wire T2$clear, X1$not, X0$hold, AUdur$not$buf, X0$or;
  wire T0$clear, X2$not, X1$hold, Init$not$buf, X1$or;
  wire T1$clear, X0$not, X2$hold, X2$or;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);

  // X0 = (X2.b + /X1.X0 + Init)./AUdur
  and #GATE_NS T2$clear$g (T2$clear, X2, b);
  not #GATE_NS X1$not$g (X1$not, X1);
  and #GATE_NS X0$hold$g (X0$hold, X1$not, X0);
  buf #GATE_NS AUdur$not$buf$g (AUdur$not$buf, AUdur$not);
  or #GATE_NS X0$or$g (X0$or, T2$clear, X0$hold, Init);
  and #GATE_NS X0$g (X0, X0$or, AUdur$not$buf);

  // X1 = (X0.m + /X2.X1)./Init./AUdur
  and #GATE_NS T0$clear$g (T0$clear, X0, m);
  not #GATE_NS X2$not$g (X2$not, X2);
  and #GATE_NS X1$hold$g (X1$hold, X2$not, X1);
  buf #GATE_NS Init$not$buf$g (Init$not$buf, Init$not);
  or #GATE_NS X1$or$g (X1$or, T0$clear, X1$hold);
  and #GATE_NS X1$g (X1, X1$or, Init$not$buf, AUdur$not$buf);

  // X2 = (X1.a + /X0.X2)./Init./AUdur
  and #GATE_NS T1$clear$g (T1$clear, X1, a);
  not #GATE_NS X0$not$g (X0$not, X0);
  and #GATE_NS X2$hold$g (X2$hold, X0$not, X2);
  or #GATE_NS X2$or$g (X2$or, T1$clear, X2$hold);
  and #GATE_NS X2$g (X2, X2$or, Init$not$buf, AUdur$not$buf);
endmodule
