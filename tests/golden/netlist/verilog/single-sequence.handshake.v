// single_sequence "Séquence unique" (single-sequence.grafcet): 11 cells.
// Style handshake, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist single-sequence.grafcet --style handshake --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $give   0 while what follows is being set
//   $not    the owner inverted
//   $q      the other gate of the latch
//   $start  0 while the initial situation is set up
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
  wire AUdur$not, Init$start;
  wire T2$give, X0$q;
  wire T0$give, X1$q;
  wire T1$give, X2$q;

  // inputs
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);
  nand #GATE_NS Init$start$g (Init$start, Init, AUdur$not);

  // X0 = (X2.b + /X1.X0 + Init)./AUdur
  nand #GATE_NS T2$give$g (T2$give, X2, b, T1$give, Init$start, AUdur$not);
  nand #GATE_NS X0$g (X0, T2$give, X0$q, Init$start);
  nand #GATE_NS X0$q$g (X0$q, X0, X1$q, AUdur$not);

  // X1 = (X0.m + /X2.X1)./Init./AUdur
  nand #GATE_NS T0$give$g (T0$give, X0, m, T2$give, Init$start, AUdur$not);
  nand #GATE_NS X1$g (X1, T0$give, X1$q);
  nand #GATE_NS X1$q$g (X1$q, X1, X2$q, Init$start, AUdur$not);

  // X2 = (X1.a + /X0.X2)./Init./AUdur
  nand #GATE_NS T1$give$g (T1$give, X1, a, T0$give, Init$start, AUdur$not);
  nand #GATE_NS X2$g (X2, T1$give, X2$q);
  nand #GATE_NS X2$q$g (X2$q, X2, X0$q, Init$start, AUdur$not);
endmodule
