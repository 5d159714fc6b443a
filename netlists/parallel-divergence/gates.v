// parallel_divergence "Séquences parallèles, divergence" (parallel-divergence.grafcet): 35 cells.
// Style gates, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist parallel-divergence.grafcet --style gates --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $buf    the owner, a gate delay later
//   $cdxN   term N of CDX
//   $clear  of a transition: it is cleared; of a step: Init deactivates it
//   $hold   keeps the owner as it is
//   $not    the owner inverted
//   $or     all that makes the step active, or keeps it so
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
  wire Init$not, AUdur$not;
  wire a$not, T11$clear, X7$not, X6$hold, AUdur$not$buf, AUdur$not$buf$buf, X6$or;
  wire T6$clear, X7$cdx0, X7$cdx0$not, X7$hold, Init$not$buf, X7$or;
  wire T7$clear, X11$not, X10$hold, X10$or;
  wire T10$clear, X6$not, X11$hold, X11$or;
  wire X21$not, X20$hold, X20$or;
  wire T20$clear, X21$hold, X21$or;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);

  // X6 = (X11.X21./a + /X7.X6 + Init)./AUdur
  not #GATE_NS a$not$g (a$not, a);
  and #GATE_NS T11$clear$g (T11$clear, X11, X21, a$not);
  not #GATE_NS X7$not$g (X7$not, X7);
  and #GATE_NS X6$hold$g (X6$hold, X7$not, X6);
  buf #GATE_NS AUdur$not$buf$g (AUdur$not$buf, AUdur$not);
  buf #GATE_NS AUdur$not$buf$buf$g (AUdur$not$buf$buf, AUdur$not$buf);
  or #GATE_NS X6$or$g (X6$or, T11$clear, X6$hold, Init);
  and #GATE_NS X6$g (X6, X6$or, AUdur$not$buf$buf);

  // X7 = (X6.a + /(X10.X20).X7)./Init./AUdur
  and #GATE_NS T6$clear$g (T6$clear, X6, a);
  and #GATE_NS X7$cdx0$g (X7$cdx0, X10, X20);
  not #GATE_NS X7$cdx0$not$g (X7$cdx0$not, X7$cdx0);
  and #GATE_NS X7$hold$g (X7$hold, X7$cdx0$not, X7);
  buf #GATE_NS Init$not$buf$g (Init$not$buf, Init$not);
  or #GATE_NS X7$or$g (X7$or, T6$clear, X7$hold);
  and #GATE_NS X7$g (X7, X7$or, Init$not$buf, AUdur$not$buf);

  // X10 = (X7.x + /X11.X10)./Init./AUdur
  and #GATE_NS T7$clear$g (T7$clear, X7, x);
  not #GATE_NS X11$not$g (X11$not, X11);
  and #GATE_NS X10$hold$g (X10$hold, X11$not, X10);
  or #GATE_NS X10$or$g (X10$or, T7$clear, X10$hold);
  and #GATE_NS X10$g (X10, X10$or, Init$not$buf, AUdur$not$buf);

  // X11 = (X10.y + /X6.X11)./Init./AUdur
  and #GATE_NS T10$clear$g (T10$clear, X10, y);
  not #GATE_NS X6$not$g (X6$not, X6);
  and #GATE_NS X11$hold$g (X11$hold, X6$not, X11);
  or #GATE_NS X11$or$g (X11$or, T10$clear, X11$hold);
  and #GATE_NS X11$g (X11, X11$or, Init$not$buf, AUdur$not$buf);

  // X20 = (X7.x + /X21.X20)./Init./AUdur
  not #GATE_NS X21$not$g (X21$not, X21);
  and #GATE_NS X20$hold$g (X20$hold, X21$not, X20);
  or #GATE_NS X20$or$g (X20$or, T7$clear, X20$hold);
  and #GATE_NS X20$g (X20, X20$or, Init$not$buf, AUdur$not$buf);

  // X21 = (X20.t + /X6.X21)./Init./AUdur
  and #GATE_NS T20$clear$g (T20$clear, X20, t);
  and #GATE_NS X21$hold$g (X21$hold, X6$not, X21);
  or #GATE_NS X21$or$g (X21$or, T20$clear, X21$hold);
  and #GATE_NS X21$g (X21, X21$or, Init$not$buf, AUdur$not$buf);
endmodule
