// nine_steps "Exercice : GRAFCET à neuf étapes" (nine-steps.grafcet): 59 cells.
// Style clocked, CDX by transitions, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist nine-steps.grafcet --style clocked --cdx transition --modes on --to verilog --scan 10ms
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $N        a gate of a condition of the owner
//   $clear    of a transition: it is cleared; of a step: Init deactivates it
//   $evolved  the step after the transitions, before any order
//   $hold     keeps the owner as it is
//   $next     the owner as it is from the next clock on
//   $not      the owner inverted
`timescale 1ns/1ps

module nine_steps (
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
  input clk,
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
  wire T1$clear;
  wire T2$clear;
  wire T3$clear;
  wire T5$clear;
  wire T6$clear;
  wire T7$clear;
  wire T8$clear;
  wire T9$clear;
  wire T4$clear;
  wire T1$clear$not, X1$hold, X1$evolved, X1$next;
  wire T2$clear$not, X2$hold, X2$evolved, X2$next;
  wire T3$clear$not, X3$hold, X3$evolved, X3$next;
  wire T4$clear$not, X4$hold, X4$evolved, X4$next;
  wire T5$clear$not, X5$hold, X5$evolved, X5$next;
  wire T6$clear$not, T8$clear$not, X6$hold, X6$evolved, X6$next;
  wire T7$clear$not, X7$hold, X7$evolved, X7$next;
  wire X8$hold, X8$evolved, X8$next;
  wire T9$clear$not, X9$hold, X9$evolved, X9$next;
  wire AUdoux$not, A$1;

  // inputs
  not Init$not$g (Init$not, Init);
  not AUdur$not$g (AUdur$not, AUdur);

  // T1
  and T1$clear$g (T1$clear, X1, m, Init$not);

  // T2
  and T2$clear$g (T2$clear, X2, b, Init$not);

  // T3
  and T3$clear$g (T3$clear, X3, c, Init$not);

  // T5
  and T5$clear$g (T5$clear, X5, a, Init$not);

  // T6
  and T6$clear$g (T6$clear, X6, d1, Init$not);

  // T7
  and T7$clear$g (T7$clear, X7, e, Init$not);

  // T8
  and T8$clear$g (T8$clear, X6, d2, Init$not);

  // T9
  and T9$clear$g (T9$clear, X9, f, Init$not);

  // T4
  and T4$clear$g (T4$clear, X4, X8, Init$not);

  // X1 = (X4.X8 + /(X1.m).X1 + Init)./AUdur
  not T1$clear$not$g (T1$clear$not, T1$clear);
  and X1$hold$g (X1$hold, X1, T1$clear$not);
  or X1$evolved$g (X1$evolved, T4$clear, X1$hold, Init);
  and X1$next$g (X1$next, X1$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b1)) X1$g (.d(X1$next), .c(clk), .q(X1));

  // X2 = (X1.m + /(X2.b).X2)./Init./AUdur
  not T2$clear$not$g (T2$clear$not, T2$clear);
  and X2$hold$g (X2$hold, X2, T2$clear$not, Init$not);
  or X2$evolved$g (X2$evolved, T1$clear, X2$hold);
  and X2$next$g (X2$next, X2$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X2$g (.d(X2$next), .c(clk), .q(X2));

  // X3 = (X2.b + /(X3.c).X3)./Init./AUdur
  not T3$clear$not$g (T3$clear$not, T3$clear);
  and X3$hold$g (X3$hold, X3, T3$clear$not, Init$not);
  or X3$evolved$g (X3$evolved, T2$clear, X3$hold);
  and X3$next$g (X3$next, X3$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X3$g (.d(X3$next), .c(clk), .q(X3));

  // X4 = (X3.c + /(X4.X8).X4)./Init./AUdur
  not T4$clear$not$g (T4$clear$not, T4$clear);
  and X4$hold$g (X4$hold, X4, T4$clear$not, Init$not);
  or X4$evolved$g (X4$evolved, T3$clear, X4$hold);
  and X4$next$g (X4$next, X4$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X4$g (.d(X4$next), .c(clk), .q(X4));

  // X5 = (X1.m + /(X5.a).X5)./Init./AUdur
  not T5$clear$not$g (T5$clear$not, T5$clear);
  and X5$hold$g (X5$hold, X5, T5$clear$not, Init$not);
  or X5$evolved$g (X5$evolved, T1$clear, X5$hold);
  and X5$next$g (X5$next, X5$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X5$g (.d(X5$next), .c(clk), .q(X5));

  // X6 = (X5.a + /(X6.d1 + X6.d2).X6)./Init./AUdur
  not T6$clear$not$g (T6$clear$not, T6$clear);
  not T8$clear$not$g (T8$clear$not, T8$clear);
  and X6$hold$g (X6$hold, X6, T6$clear$not, T8$clear$not, Init$not);
  or X6$evolved$g (X6$evolved, T5$clear, X6$hold);
  and X6$next$g (X6$next, X6$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X6$g (.d(X6$next), .c(clk), .q(X6));

  // X7 = (X6.d1 + /(X7.e).X7)./Init./AUdur
  not T7$clear$not$g (T7$clear$not, T7$clear);
  and X7$hold$g (X7$hold, X7, T7$clear$not, Init$not);
  or X7$evolved$g (X7$evolved, T6$clear, X7$hold);
  and X7$next$g (X7$next, X7$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X7$g (.d(X7$next), .c(clk), .q(X7));

  // X8 = (X7.e + X9.f + /(X4.X8).X8)./Init./AUdur
  and X8$hold$g (X8$hold, X8, T4$clear$not, Init$not);
  or X8$evolved$g (X8$evolved, T7$clear, T9$clear, X8$hold);
  and X8$next$g (X8$next, X8$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X8$g (.d(X8$next), .c(clk), .q(X8));

  // X9 = (X6.d2 + /(X9.f).X9)./Init./AUdur
  not T9$clear$not$g (T9$clear$not, T9$clear);
  and X9$hold$g (X9$hold, X9, T9$clear$not, Init$not);
  or X9$evolved$g (X9$evolved, T8$clear, X9$hold);
  and X9$next$g (X9$next, X9$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X9$g (.d(X9$next), .c(clk), .q(X9));

  // A = X3./AUdoux
  not AUdoux$not$g (AUdoux$not, AUdoux);
  and A$1$g (A$1, X3, AUdoux$not);
  buf A$g (A, A$1);
endmodule

`timescale 1ps/1ps

// D flip-flop.
module grafwire_dff #(parameter INIT = 1'bx) (input d, input c, output reg q);
  initial q = INIT;
  always @(posedge c) q <= d;
endmodule
