// parallel_convergence "Séquences parallèles, convergence" (parallel-convergence.grafcet): 43 cells.
// Style clocked, CDX by transitions, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist parallel-convergence.grafcet --style clocked --cdx transition --modes on --to verilog --scan 10ms
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $clear    of a transition: it is cleared; of a step: Init deactivates it
//   $evolved  the step after the transitions, before any order
//   $hold     keeps the owner as it is
//   $next     the owner as it is from the next clock on
//   $not      the owner inverted
`timescale 1ns/1ps

module parallel_convergence (
  input x,
  input b,
  input c,
  input d,
  input f,
  input Init,
  input AUdur,
  input AUdoux,
  input clk,
  output X0,
  output X30,
  output X31,
  output X47,
  output X48,
  output X6,
  output X7
);
  wire Init$not, AUdur$not;
  wire T0$clear;
  wire T30$clear;
  wire T47$clear;
  wire T31$clear;
  wire T6$clear;
  wire x$not, T7$clear;
  wire T0$clear$not, X0$hold, X0$evolved, X0$next;
  wire T30$clear$not, X30$hold, X30$evolved, X30$next;
  wire T31$clear$not, X31$hold, X31$evolved, X31$next;
  wire T47$clear$not, X47$hold, X47$evolved, X47$next;
  wire X48$hold, X48$evolved, X48$next;
  wire T6$clear$not, X6$hold, X6$evolved, X6$next;
  wire T7$clear$not, X7$hold, X7$evolved, X7$next;

  // inputs
  not Init$not$g (Init$not, Init);
  not AUdur$not$g (AUdur$not, AUdur);

  // T0
  and T0$clear$g (T0$clear, X0, x, Init$not);

  // T30
  and T30$clear$g (T30$clear, X30, b, Init$not);

  // T47
  and T47$clear$g (T47$clear, X47, c, Init$not);

  // T31
  and T31$clear$g (T31$clear, X31, X48, d, Init$not);

  // T6
  and T6$clear$g (T6$clear, X6, f, Init$not);

  // T7
  not x$not$g (x$not, x);
  and T7$clear$g (T7$clear, X7, x$not, Init$not);

  // X0 = (X7./x + /(X0.x).X0 + Init)./AUdur
  not T0$clear$not$g (T0$clear$not, T0$clear);
  and X0$hold$g (X0$hold, X0, T0$clear$not);
  or X0$evolved$g (X0$evolved, T7$clear, X0$hold, Init);
  and X0$next$g (X0$next, X0$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b1)) X0$g (.d(X0$next), .c(clk), .q(X0));

  // X30 = (X0.x + /(X30.b).X30)./Init./AUdur
  not T30$clear$not$g (T30$clear$not, T30$clear);
  and X30$hold$g (X30$hold, X30, T30$clear$not, Init$not);
  or X30$evolved$g (X30$evolved, T0$clear, X30$hold);
  and X30$next$g (X30$next, X30$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X30$g (.d(X30$next), .c(clk), .q(X30));

  // X31 = (X30.b + /(X31.X48.d).X31)./Init./AUdur
  not T31$clear$not$g (T31$clear$not, T31$clear);
  and X31$hold$g (X31$hold, X31, T31$clear$not, Init$not);
  or X31$evolved$g (X31$evolved, T30$clear, X31$hold);
  and X31$next$g (X31$next, X31$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X31$g (.d(X31$next), .c(clk), .q(X31));

  // X47 = (X0.x + /(X47.c).X47)./Init./AUdur
  not T47$clear$not$g (T47$clear$not, T47$clear);
  and X47$hold$g (X47$hold, X47, T47$clear$not, Init$not);
  or X47$evolved$g (X47$evolved, T0$clear, X47$hold);
  and X47$next$g (X47$next, X47$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X47$g (.d(X47$next), .c(clk), .q(X47));

  // X48 = (X47.c + /(X31.X48.d).X48)./Init./AUdur
  and X48$hold$g (X48$hold, X48, T31$clear$not, Init$not);
  or X48$evolved$g (X48$evolved, T47$clear, X48$hold);
  and X48$next$g (X48$next, X48$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X48$g (.d(X48$next), .c(clk), .q(X48));

  // X6 = (X31.X48.d + /(X6.f).X6)./Init./AUdur
  not T6$clear$not$g (T6$clear$not, T6$clear);
  and X6$hold$g (X6$hold, X6, T6$clear$not, Init$not);
  or X6$evolved$g (X6$evolved, T31$clear, X6$hold);
  and X6$next$g (X6$next, X6$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X6$g (.d(X6$next), .c(clk), .q(X6));

  // X7 = (X6.f + /(X7./x).X7)./Init./AUdur
  not T7$clear$not$g (T7$clear$not, T7$clear);
  and X7$hold$g (X7$hold, X7, T7$clear$not, Init$not);
  or X7$evolved$g (X7$evolved, T6$clear, X7$hold);
  and X7$next$g (X7$next, X7$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X7$g (.d(X7$next), .c(clk), .q(X7));
endmodule

`timescale 1ps/1ps

// D flip-flop.
module grafwire_dff #(parameter INIT = 1'bx) (input d, input c, output reg q);
  initial q = INIT;
  always @(posedge c) q <= d;
endmodule
