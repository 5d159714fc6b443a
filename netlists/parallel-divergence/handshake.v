// parallel_divergence "Séquences parallèles, divergence" (parallel-divergence.grafcet): 23 cells.
// Style handshake, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist parallel-divergence.grafcet --style handshake --cdx successor --modes on --to verilog
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

module parallel_divergence #(parameter GATE_NS = 1) (
  input a,
  input x,
  input y,
  input t,
  input Init,
  input AUdur,
  input AUdoux,
  output X6,
  output X7,
  output X10,
  output X11,
  output X20,
  output X21
);
  wire AUdur$not, Init$start, a$not, a$not$back;
  wire T11$give, T11$join1, X6$q;
  wire T6$give, X7$q;
  wire T7$give, T7$fork1, X10$q;
  wire T10$give, X11$q;
  wire X20$q;
  wire T20$give, X21$q;

  // inputs
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);
  nand #GATE_NS Init$start$g (Init$start, Init, AUdur$not);
  not #GATE_NS a$not$g (a$not, a);
  not #GATE_NS a$not$back$g (a$not$back, a$not);

  // X6 = (X11.X21./a + /X7.X6 + Init)./AUdur
  nand #GATE_NS T11$give$g (T11$give, X11, X21, a$not, T10$give, T20$give, Init$start, AUdur$not);
  nand #GATE_NS T11$join1$g (T11$join1, X6, T11$give, X21);
  nand #GATE_NS X6$g (X6, T11$give, X6$q, Init$start);
  nand #GATE_NS X6$q$g (X6$q, X6, X7$q, AUdur$not);

  // X7 = (X6.a + /(X10.X20).X7)./Init./AUdur
  nand #GATE_NS T6$give$g (T6$give, X6, a, a$not$back, T11$give, T11$join1, X21$q, Init$start, AUdur$not);
  nand #GATE_NS X7$g (X7, T6$give, X7$q);
  nand #GATE_NS X7$q$g (X7$q, X7, X20$q, Init$start, AUdur$not);

  // X10 = (X7.x + /X11.X10)./Init./AUdur
  nand #GATE_NS T7$give$g (T7$give, X7, x, T6$give, X10$q, Init$start, AUdur$not);
  nand #GATE_NS T7$fork1$g (T7$fork1, X7, X10, T7$give, Init$start, AUdur$not);
  nand #GATE_NS X10$g (X10, T7$give, X10$q);
  nand #GATE_NS X10$q$g (X10$q, X10, X11$q, Init$start, AUdur$not);

  // X11 = (X10.y + /X6.X11)./Init./AUdur
  nand #GATE_NS T10$give$g (T10$give, X10, y, T7$fork1, X7$q, Init$start, AUdur$not);
  nand #GATE_NS X11$g (X11, T10$give, X11$q);
  nand #GATE_NS X11$q$g (X11$q, X11, X6$q, Init$start, AUdur$not);

  // X20 = (X7.x + /X21.X20)./Init./AUdur
  nand #GATE_NS X20$g (X20, T7$fork1, X20$q);
  nand #GATE_NS X20$q$g (X20$q, X20, X21$q, Init$start, AUdur$not);

  // X21 = (X20.t + /X6.X21)./Init./AUdur
  nand #GATE_NS T20$give$g (T20$give, X20, t, T7$fork1, Init$start, AUdur$not);
  nand #GATE_NS X21$g (X21, T20$give, X21$q);
  nand #GATE_NS X21$q$g (X21$q, X21, T11$join1, Init$start, AUdur$not);
endmodule
