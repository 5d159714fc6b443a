// parallel_convergence "Séquences parallèles, convergence" (parallel-convergence.grafcet): 40 cells.
// Style gates, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist parallel-convergence.grafcet --style gates --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $buf    the owner, a gate delay later
//   $cdxN   term N of CDX
//   $clear  of a transition: it is cleared; of a step: Init deactivates it
//   $hold   keeps the owner as it is
//   $not    the owner inverted
//   $or     all that makes the step active, or keeps it so
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
  wire Init$not, AUdur$not;
  wire x$not, T7$clear, X0$cdx0, X0$cdx0$not, X0$hold, AUdur$not$buf, AUdur$not$buf$buf, X0$or;
  wire T0$clear, X31$not, X30$hold, Init$not$buf, X30$or;
  wire T30$clear, X6$not, X31$hold, X31$or;
  wire X48$not, X47$hold, X47$or;
  wire T47$clear, X48$hold, X48$or;
  wire T31$clear, X7$not, X6$hold, X6$or;
  wire T6$clear, X0$not, X7$hold, X7$or;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);

  // X0 = (X7./x + /(X30.X47).X0 + Init)./AUdur
  not #GATE_NS x$not$g (x$not, x);
  and #GATE_NS T7$clear$g (T7$clear, X7, x$not);
  and #GATE_NS X0$cdx0$g (X0$cdx0, X30, X47);
  not #GATE_NS X0$cdx0$not$g (X0$cdx0$not, X0$cdx0);
  and #GATE_NS X0$hold$g (X0$hold, X0$cdx0$not, X0);
  buf #GATE_NS AUdur$not$buf$g (AUdur$not$buf, AUdur$not);
  buf #GATE_NS AUdur$not$buf$buf$g (AUdur$not$buf$buf, AUdur$not$buf);
  or #GATE_NS X0$or$g (X0$or, T7$clear, X0$hold, Init);
  and #GATE_NS X0$g (X0, X0$or, AUdur$not$buf$buf);

  // X30 = (X0.x + /X31.X30)./Init./AUdur
  and #GATE_NS T0$clear$g (T0$clear, X0, x);
  not #GATE_NS X31$not$g (X31$not, X31);
  and #GATE_NS X30$hold$g (X30$hold, X31$not, X30);
  buf #GATE_NS Init$not$buf$g (Init$not$buf, Init$not);
  or #GATE_NS X30$or$g (X30$or, T0$clear, X30$hold);
  and #GATE_NS X30$g (X30, X30$or, Init$not$buf, AUdur$not$buf);

  // X31 = (X30.b + /X6.X31)./Init./AUdur
  and #GATE_NS T30$clear$g (T30$clear, X30, b);
  not #GATE_NS X6$not$g (X6$not, X6);
  and #GATE_NS X31$hold$g (X31$hold, X6$not, X31);
  or #GATE_NS X31$or$g (X31$or, T30$clear, X31$hold);
  and #GATE_NS X31$g (X31, X31$or, Init$not$buf, AUdur$not$buf);

  // X47 = (X0.x + /X48.X47)./Init./AUdur
  not #GATE_NS X48$not$g (X48$not, X48);
  and #GATE_NS X47$hold$g (X47$hold, X48$not, X47);
  or #GATE_NS X47$or$g (X47$or, T0$clear, X47$hold);
  and #GATE_NS X47$g (X47, X47$or, Init$not$buf, AUdur$not$buf);

  // X48 = (X47.c + /X6.X48)./Init./AUdur
  and #GATE_NS T47$clear$g (T47$clear, X47, c);
  and #GATE_NS X48$hold$g (X48$hold, X6$not, X48);
  or #GATE_NS X48$or$g (X48$or, T47$clear, X48$hold);
  and #GATE_NS X48$g (X48, X48$or, Init$not$buf, AUdur$not$buf);

  // X6 = (X31.X48.d + /X7.X6)./Init./AUdur
  and #GATE_NS T31$clear$g (T31$clear, X31, X48, d);
  not #GATE_NS X7$not$g (X7$not, X7);
  and #GATE_NS X6$hold$g (X6$hold, X7$not, X6);
  or #GATE_NS X6$or$g (X6$or, T31$clear, X6$hold);
  and #GATE_NS X6$g (X6, X6$or, Init$not$buf, AUdur$not$buf);

  // X7 = (X6.f + /X0.X7)./Init./AUdur
  and #GATE_NS T6$clear$g (T6$clear, X6, f);
  not #GATE_NS X0$not$g (X0$not, X0);
  and #GATE_NS X7$hold$g (X7$hold, X0$not, X7);
  or #GATE_NS X7$or$g (X7$or, T6$clear, X7$hold);
  and #GATE_NS X7$g (X7, X7$or, Init$not$buf, AUdur$not$buf);
endmodule
