// parallel_convergence "Séquences parallèles, convergence" (parallel-convergence.grafcet): 26 cells.
// Style handshake, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist parallel-convergence.grafcet --style handshake --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $back   the owner inverted
//   $forkN  0 while follower N of the transition, counted from 0, is being set
//   $give   0 while what follows is being set
//   $joinN  0 while step N before the transition, counted from 0, is being reset
//   $not    the owner inverted
//   $q      the other gate of the latch
//   $start  0 while the initial situation is set up
// GATE_NS is how long a gate takes, in ns. Pulses last several gate delays and grow with it.
`timescale 1ns/1ps

module parallel_convergence #(parameter GATE_NS = 1) (
  input x,
  input b,
  input c,
  input d,
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
  wire AUdur$not, Init$start, x$not, x$not$back;
  wire T7$give, X0$q;
  wire T0$give, T0$fork1, X30$q;
  wire T30$give, X31$q;
  wire X47$q;
  wire T47$give, X48$q;
  wire T31$give, T31$join1, X6$q;
  wire T6$give, X7$q;

  // inputs
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);
  nand #GATE_NS Init$start$g (Init$start, Init, AUdur$not);
  not #GATE_NS x$not$g (x$not, x);
  not #GATE_NS x$not$back$g (x$not$back, x$not);

  // X0 = (X7./x + /(X30.X47).X0 + Init)./AUdur
  nand #GATE_NS T7$give$g (T7$give, X7, x$not, T6$give, Init$start, AUdur$not);
  nand #GATE_NS X0$g (X0, T7$give, X0$q, Init$start);
  nand #GATE_NS X0$q$g (X0$q, X0, X47$q, AUdur$not);

  // X30 = (X0.x + /X31.X30)./Init./AUdur
  nand #GATE_NS T0$give$g (T0$give, X0, x, x$not$back, T7$give, X30$q, Init$start, AUdur$not);
  nand #GATE_NS T0$fork1$g (T0$fork1, X0, X30, T0$give, Init$start, AUdur$not);
  nand #GATE_NS X30$g (X30, T0$give, X30$q);
  nand #GATE_NS X30$q$g (X30$q, X30, X31$q, Init$start, AUdur$not);

  // X31 = (X30.b + /X6.X31)./Init./AUdur
  nand #GATE_NS T30$give$g (T30$give, X30, b, T0$fork1, X0$q, Init$start, AUdur$not);
  nand #GATE_NS X31$g (X31, T30$give, X31$q);
  nand #GATE_NS X31$q$g (X31$q, X31, X6$q, Init$start, AUdur$not);

  // X47 = (X0.x + /X48.X47)./Init./AUdur
  nand #GATE_NS X47$g (X47, T0$fork1, X47$q);
  nand #GATE_NS X47$q$g (X47$q, X47, X48$q, Init$start, AUdur$not);

  // X48 = (X47.c + /X6.X48)./Init./AUdur
  nand #GATE_NS T47$give$g (T47$give, X47, c, T0$fork1, Init$start, AUdur$not);
  nand #GATE_NS X48$g (X48, T47$give, X48$q);
  nand #GATE_NS X48$q$g (X48$q, X48, T31$join1, Init$start, AUdur$not);

  // X6 = (X31.X48.d + /X7.X6)./Init./AUdur
  nand #GATE_NS T31$give$g (T31$give, X31, X48, d, T30$give, T47$give, Init$start, AUdur$not);
  nand #GATE_NS T31$join1$g (T31$join1, X6, T31$give, X48);
  nand #GATE_NS X6$g (X6, T31$give, X6$q);
  nand #GATE_NS X6$q$g (X6$q, X6, X7$q, Init$start, AUdur$not);

  // X7 = (X6.f + /X0.X7)./Init./AUdur
  nand #GATE_NS T6$give$g (T6$give, X6, f, T31$give, T31$join1, X48$q, Init$start, AUdur$not);
  nand #GATE_NS X7$g (X7, T6$give, X7$q);
  nand #GATE_NS X7$q$g (X7$q, X7, X0$q, Init$start, AUdur$not);
endmodule
