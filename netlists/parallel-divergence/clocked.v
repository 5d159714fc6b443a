// parallel_divergence "Séquences parallèles, divergence" (parallel-divergence.grafcet): 37 cells.
// Style clocked, CDX by transitions, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist parallel-divergence.grafcet --style clocked --cdx transition --modes on --to verilog --scan 10ms
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $clear    of a transition: it is cleared; of a step: Init deactivates it
//   $evolved  the step after the transitions, before any order
//   $hold     keeps the owner as it is
//   $next     the owner as it is from the next clock on
//   $not      the owner inverted
`timescale 1ns/1ps

module parallel_divergence (
  input a,
  input x,
  input y,
  input t,
  input Init,
  input AUdur,
  input AUdoux,
  input clk,
  output X6,
  output X7,
  output X10,
  output X11,
  output X20,
  output X21
);
  wire Init$not, AUdur$not;
  wire T6$clear;
  wire T7$clear;
  wire T10$clear;
  wire T20$clear;
  wire a$not, T11$clear;
  wire T6$clear$not, X6$hold, X6$evolved, X6$next;
  wire T7$clear$not, X7$hold, X7$evolved, X7$next;
  wire T10$clear$not, X10$hold, X10$evolved, X10$next;
  wire T11$clear$not, X11$hold, X11$evolved, X11$next;
  wire T20$clear$not, X20$hold, X20$evolved, X20$next;
  wire X21$hold, X21$evolved, X21$next;

  // inputs
  not Init$not$g (Init$not, Init);
  not AUdur$not$g (AUdur$not, AUdur);

  // T6
  and T6$clear$g (T6$clear, X6, a, Init$not);

  // T7
  and T7$clear$g (T7$clear, X7, x, Init$not);

  // T10
  and T10$clear$g (T10$clear, X10, y, Init$not);

  // T20
  and T20$clear$g (T20$clear, X20, t, Init$not);

  // T11
  not a$not$g (a$not, a);
  and T11$clear$g (T11$clear, X11, X21, a$not, Init$not);

  // X6 = (X11.X21./a + /(X6.a).X6 + Init)./AUdur
  not T6$clear$not$g (T6$clear$not, T6$clear);
  and X6$hold$g (X6$hold, X6, T6$clear$not);
  or X6$evolved$g (X6$evolved, T11$clear, X6$hold, Init);
  and X6$next$g (X6$next, X6$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b1)) X6$g (.d(X6$next), .c(clk), .q(X6));

  // X7 = (X6.a + /(X7.x).X7)./Init./AUdur
  not T7$clear$not$g (T7$clear$not, T7$clear);
  and X7$hold$g (X7$hold, X7, T7$clear$not, Init$not);
  or X7$evolved$g (X7$evolved, T6$clear, X7$hold);
  and X7$next$g (X7$next, X7$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X7$g (.d(X7$next), .c(clk), .q(X7));

  // X10 = (X7.x + /(X10.y).X10)./Init./AUdur
  not T10$clear$not$g (T10$clear$not, T10$clear);
  and X10$hold$g (X10$hold, X10, T10$clear$not, Init$not);
  or X10$evolved$g (X10$evolved, T7$clear, X10$hold);
  and X10$next$g (X10$next, X10$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X10$g (.d(X10$next), .c(clk), .q(X10));

  // X11 = (X10.y + /(X11.X21./a).X11)./Init./AUdur
  not T11$clear$not$g (T11$clear$not, T11$clear);
  and X11$hold$g (X11$hold, X11, T11$clear$not, Init$not);
  or X11$evolved$g (X11$evolved, T10$clear, X11$hold);
  and X11$next$g (X11$next, X11$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X11$g (.d(X11$next), .c(clk), .q(X11));

  // X20 = (X7.x + /(X20.t).X20)./Init./AUdur
  not T20$clear$not$g (T20$clear$not, T20$clear);
  and X20$hold$g (X20$hold, X20, T20$clear$not, Init$not);
  or X20$evolved$g (X20$evolved, T7$clear, X20$hold);
  and X20$next$g (X20$next, X20$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X20$g (.d(X20$next), .c(clk), .q(X20));

  // X21 = (X20.t + /(X11.X21./a).X21)./Init./AUdur
  and X21$hold$g (X21$hold, X21, T11$clear$not, Init$not);
  or X21$evolved$g (X21$evolved, T20$clear, X21$hold);
  and X21$next$g (X21$next, X21$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X21$g (.d(X21$next), .c(clk), .q(X21));
endmodule

`timescale 1ps/1ps

// D flip-flop.
module grafwire_dff #(parameter INIT = 1'bx) (input d, input c, output reg q);
  initial q = INIT;
  always @(posedge c) q <= d;
endmodule
