// nine_steps "Exercice : GRAFCET à neuf étapes" (nine-steps.grafcet): 51 cells.
// Style gates, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist nine-steps.grafcet --style gates --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $buf    the owner, a gate delay later
//   $cdx    CDX of the step
//   $cdxN   term N of CDX
//   $clear  of a transition: it is cleared; of a step: Init deactivates it
//   $hold   keeps the owner as it is
//   $not    the owner inverted
//   $or     all that makes the step active, or keeps it so
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
  wire Init$not, AUdur$not;
  wire T4$clear, X1$cdx0, X1$cdx0$not, X1$hold, AUdur$not$buf, X1$or;
  wire T1$clear, X3$not, X2$hold, Init$not$buf, X2$or;
  wire T2$clear, X4$not, X3$hold, X3$or;
  wire T3$clear, X1$not, X4$hold, X4$or;
  wire X6$not, X5$hold, X5$or;
  wire T5$clear, X6$cdx, X6$cdx$not, X6$hold, X6$or;
  wire T6$clear, X8$not, X7$hold, X7$or;
  wire T7$clear, T9$clear, X8$hold, X8$or;
  wire T8$clear, X9$hold, X9$or;
  wire AUdoux$not;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);

  // X1 = (X4.X8 + /(X2.X5).X1 + Init)./AUdur
  and #GATE_NS T4$clear$g (T4$clear, X4, X8);
  and #GATE_NS X1$cdx0$g (X1$cdx0, X2, X5);
  not #GATE_NS X1$cdx0$not$g (X1$cdx0$not, X1$cdx0);
  and #GATE_NS X1$hold$g (X1$hold, X1$cdx0$not, X1);
  buf #GATE_NS AUdur$not$buf$g (AUdur$not$buf, AUdur$not);
  or #GATE_NS X1$or$g (X1$or, T4$clear, X1$hold, Init);
  and #GATE_NS X1$g (X1, X1$or, AUdur$not$buf);

  // X2 = (X1.m + /X3.X2)./Init./AUdur
  and #GATE_NS T1$clear$g (T1$clear, X1, m);
  not #GATE_NS X3$not$g (X3$not, X3);
  and #GATE_NS X2$hold$g (X2$hold, X3$not, X2);
  buf #GATE_NS Init$not$buf$g (Init$not$buf, Init$not);
  or #GATE_NS X2$or$g (X2$or, T1$clear, X2$hold);
  and #GATE_NS X2$g (X2, X2$or, Init$not$buf, AUdur$not$buf);

  // X3 = (X2.b + /X4.X3)./Init./AUdur
  and #GATE_NS T2$clear$g (T2$clear, X2, b);
  not #GATE_NS X4$not$g (X4$not, X4);
  and #GATE_NS X3$hold$g (X3$hold, X4$not, X3);
  or #GATE_NS X3$or$g (X3$or, T2$clear, X3$hold);
  and #GATE_NS X3$g (X3, X3$or, Init$not$buf, AUdur$not$buf);

  // X4 = (X3.c + /X1.X4)./Init./AUdur
  and #GATE_NS T3$clear$g (T3$clear, X3, c);
  not #GATE_NS X1$not$g (X1$not, X1);
  and #GATE_NS X4$hold$g (X4$hold, X1$not, X4);
  or #GATE_NS X4$or$g (X4$or, T3$clear, X4$hold);
  and #GATE_NS X4$g (X4, X4$or, Init$not$buf, AUdur$not$buf);

  // X5 = (X1.m + /X6.X5)./Init./AUdur
  not #GATE_NS X6$not$g (X6$not, X6);
  and #GATE_NS X5$hold$g (X5$hold, X6$not, X5);
  or #GATE_NS X5$or$g (X5$or, T1$clear, X5$hold);
  and #GATE_NS X5$g (X5, X5$or, Init$not$buf, AUdur$not$buf);

  // X6 = (X5.a + /(X7 + X9).X6)./Init./AUdur
  and #GATE_NS T5$clear$g (T5$clear, X5, a);
  or #GATE_NS X6$cdx$g (X6$cdx, X7, X9);
  not #GATE_NS X6$cdx$not$g (X6$cdx$not, X6$cdx);
  and #GATE_NS X6$hold$g (X6$hold, X6$cdx$not, X6);
  or #GATE_NS X6$or$g (X6$or, T5$clear, X6$hold);
  and #GATE_NS X6$g (X6, X6$or, Init$not$buf, AUdur$not$buf);

  // X7 = (X6.d1 + /X8.X7)./Init./AUdur
  and #GATE_NS T6$clear$g (T6$clear, X6, d1);
  not #GATE_NS X8$not$g (X8$not, X8);
  and #GATE_NS X7$hold$g (X7$hold, X8$not, X7);
  or #GATE_NS X7$or$g (X7$or, T6$clear, X7$hold);
  and #GATE_NS X7$g (X7, X7$or, Init$not$buf, AUdur$not$buf);

  // X8 = (X7.e + X9.f + /X1.X8)./Init./AUdur
  and #GATE_NS T7$clear$g (T7$clear, X7, e);
  and #GATE_NS T9$clear$g (T9$clear, X9, f);
  and #GATE_NS X8$hold$g (X8$hold, X1$not, X8);
  or #GATE_NS X8$or$g (X8$or, T7$clear, T9$clear, X8$hold);
  and #GATE_NS X8$g (X8, X8$or, Init$not$buf, AUdur$not$buf);

  // X9 = (X6.d2 + /X8.X9)./Init./AUdur
  and #GATE_NS T8$clear$g (T8$clear, X6, d2);
  and #GATE_NS X9$hold$g (X9$hold, X8$not, X9);
  or #GATE_NS X9$or$g (X9$or, T8$clear, X9$hold);
  and #GATE_NS X9$g (X9, X9$or, Init$not$buf, AUdur$not$buf);

  // A = X3./AUdoux
  not #GATE_NS AUdoux$not$g (AUdoux$not, AUdoux);
  and #GATE_NS A$g (A, X3, AUdoux$not);
endmodule
