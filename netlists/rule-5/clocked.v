// rule_5 "Règle n° 5" (rule-5.grafcet): 20 cells.
// Style clocked, CDX by transitions, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist rule-5.grafcet --style clocked --cdx transition --modes on --to verilog --scan 10ms
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $N        a gate of a condition of the owner
//   $clear    of a transition: it is cleared; of a step: Init deactivates it
//   $evolved  the step after the transitions, before any order
//   $hold     keeps the owner as it is
//   $next     the owner as it is from the next clock on
//   $not      the owner inverted
`timescale 1ns/1ps

module rule_5 (
  input s,
  input k,
  input Init,
  input AUdur,
  input AUdoux,
  input clk,
  output X1,
  output X2,
  output present,
  output loaded
);
  wire Init$not, AUdur$not;
  wire T0$clear;
  wire T1$clear;
  wire T2$clear;
  wire T1$clear$not, X1$hold, X1$evolved, X1$next;
  wire T2$clear$not, X2$hold, X2$evolved, X2$next;
  wire AUdoux$not, present$1;
  wire loaded$1;

  // inputs
  not Init$not$g (Init$not, Init);
  not AUdur$not$g (AUdur$not, AUdur);

  // T0
  and T0$clear$g (T0$clear, s, Init$not);

  // T1
  and T1$clear$g (T1$clear, X1, Init$not);

  // T2
  and T2$clear$g (T2$clear, X2, k, Init$not);

  // X1 = (s + /X1.X1)./Init./AUdur
  not T1$clear$not$g (T1$clear$not, T1$clear);
  and X1$hold$g (X1$hold, X1, T1$clear$not, Init$not);
  or X1$evolved$g (X1$evolved, T0$clear, X1$hold);
  and X1$next$g (X1$next, X1$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X1$g (.d(X1$next), .c(clk), .q(X1));

  // X2 = (X1 + /(X2.k).X2 + Init)./AUdur
  not T2$clear$not$g (T2$clear$not, T2$clear);
  and X2$hold$g (X2$hold, X2, T2$clear$not);
  or X2$evolved$g (X2$evolved, T1$clear, X2$hold, Init);
  and X2$next$g (X2$next, X2$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b1)) X2$g (.d(X2$next), .c(clk), .q(X2));

  // present = X1./AUdoux
  not AUdoux$not$g (AUdoux$not, AUdoux);
  and present$1$g (present$1, X1, AUdoux$not);
  buf present$g (present, present$1);

  // loaded = X2./AUdoux
  and loaded$1$g (loaded$1, X2, AUdoux$not);
  buf loaded$g (loaded, loaded$1);
endmodule

`timescale 1ps/1ps

// D flip-flop.
module grafwire_dff #(parameter INIT = 1'bx) (input d, input c, output reg q);
  initial q = INIT;
  always @(posedge c) q <= d;
endmodule
