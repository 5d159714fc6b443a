// nine_steps "Exercice : GRAFCET à neuf étapes" (nine-steps.grafcet): 34 cells.
// Style handshake, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist nine-steps.grafcet --style handshake --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $N      a gate of a condition of the owner
//   $forkN  0 while follower N of the transition, counted from 0, is being set
//   $give   0 while what follows is being set
//   $joinN  0 while step N before the transition, counted from 0, is being reset
//   $not    the owner inverted
//   $q      the other gate of the latch
//   $start  0 while the initial situation is set up
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
  wire AUdur$not, Init$start;
  wire T4$give, T4$join1, X1$q;
  wire T1$give, T1$fork1, X2$q;
  wire T2$give, X3$q;
  wire T3$give, X4$q;
  wire X5$q;
  wire T5$give, X6$q;
  wire T6$give, X7$q;
  wire T7$give, T9$give, X8$q;
  wire T8$give, X9$q;
  wire AUdoux$not, A$1;

  // inputs
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);
  nand #GATE_NS Init$start$g (Init$start, Init, AUdur$not);

  // X1 = (X4.X8 + /(X2.X5).X1 + Init)./AUdur
  nand #GATE_NS T4$give$g (T4$give, X4, X8, T3$give, T7$give, T9$give, Init$start, AUdur$not);
  nand #GATE_NS T4$join1$g (T4$join1, X1, T4$give, X8);
  nand #GATE_NS X1$g (X1, T4$give, X1$q, Init$start);
  nand #GATE_NS X1$q$g (X1$q, X1, X5$q, AUdur$not);

  // X2 = (X1.m + /X3.X2)./Init./AUdur
  nand #GATE_NS T1$give$g (T1$give, X1, m, T4$give, T4$join1, X8$q, X2$q, Init$start, AUdur$not);
  nand #GATE_NS T1$fork1$g (T1$fork1, X1, X2, T1$give, Init$start, AUdur$not);
  nand #GATE_NS X2$g (X2, T1$give, X2$q);
  nand #GATE_NS X2$q$g (X2$q, X2, X3$q, Init$start, AUdur$not);

  // X3 = (X2.b + /X4.X3)./Init./AUdur
  nand #GATE_NS T2$give$g (T2$give, X2, b, T1$fork1, X1$q, Init$start, AUdur$not);
  nand #GATE_NS X3$g (X3, T2$give, X3$q);
  nand #GATE_NS X3$q$g (X3$q, X3, X4$q, Init$start, AUdur$not);

  // X4 = (X3.c + /X1.X4)./Init./AUdur
  nand #GATE_NS T3$give$g (T3$give, X3, c, T2$give, Init$start, AUdur$not);
  nand #GATE_NS X4$g (X4, T3$give, X4$q);
  nand #GATE_NS X4$q$g (X4$q, X4, X1$q, Init$start, AUdur$not);

  // X5 = (X1.m + /X6.X5)./Init./AUdur
  nand #GATE_NS X5$g (X5, T1$fork1, X5$q);
  nand #GATE_NS X5$q$g (X5$q, X5, X6$q, Init$start, AUdur$not);

  // X6 = (X5.a + /(X7 + X9).X6)./Init./AUdur
  nand #GATE_NS T5$give$g (T5$give, X5, a, T1$fork1, Init$start, AUdur$not);
  nand #GATE_NS X6$g (X6, T5$give, X6$q);
  nand #GATE_NS X6$q$g (X6$q, X6, X7$q, X9$q, Init$start, AUdur$not);

  // X7 = (X6.d1 + /X8.X7)./Init./AUdur
  nand #GATE_NS T6$give$g (T6$give, X6, d1, T5$give, Init$start, AUdur$not);
  nand #GATE_NS X7$g (X7, T6$give, X7$q);
  nand #GATE_NS X7$q$g (X7$q, X7, X8$q, Init$start, AUdur$not);

  // X8 = (X7.e + X9.f + /X1.X8)./Init./AUdur
  nand #GATE_NS T7$give$g (T7$give, X7, e, T6$give, Init$start, AUdur$not);
  nand #GATE_NS T9$give$g (T9$give, X9, f, T8$give, Init$start, AUdur$not);
  nand #GATE_NS X8$g (X8, T7$give, T9$give, X8$q);
  nand #GATE_NS X8$q$g (X8$q, X8, T4$join1, Init$start, AUdur$not);

  // X9 = (X6.d2 + /X8.X9)./Init./AUdur
  nand #GATE_NS T8$give$g (T8$give, X6, d2, T5$give, Init$start, AUdur$not);
  nand #GATE_NS X9$g (X9, T8$give, X9$q);
  nand #GATE_NS X9$q$g (X9$q, X9, X8$q, Init$start, AUdur$not);

  // A = X3./AUdoux
  not #GATE_NS AUdoux$not$g (AUdoux$not, AUdoux);
  nand #GATE_NS A$1$g (A$1, X3, AUdoux$not);
  not #GATE_NS A$g (A, A$1);
endmodule
