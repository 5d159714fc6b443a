// positioning_axis "Axe de positionnement" (positioning-axis.grafcet): 111 cells.
// Style clocked, CDX by transitions, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist positioning-axis.grafcet --style clocked --cdx transition --modes on --to verilog --scan 10ms
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $N        a gate of a condition of the owner
//   $aN       a gate of the arithmetic that works out a value
//   $clear    of a transition: it is cleared; of a step: Init deactivates it
//   $evolved  the step after the transitions, before any order
//   $hold     keeps the owner as it is
//   $next     the owner as it is from the next clock on
//   $not      the owner inverted
//   $whenN    something is written to the owner
//   \Marche%20Moteur = Marche Moteur
//   \Sens%20Moteur = Sens Moteur
//   \Voyant%20Droite = Voyant Droite
//   \Voyant%20Gauche = Voyant Gauche
`timescale 1ns/1ps

module positioning_axis (
  input p0,
  input p1,
  input p2,
  input p3,
  input b0,
  input b1,
  input b2,
  input b3,
  input Init,
  input AUdur,
  input AUdoux,
  input clk,
  output X0,
  output X1,
  output X2,
  output X3,
  output X4,
  output X5,
  output \Marche%20Moteur ,
  output \Sens%20Moteur ,
  output \Voyant%20Droite ,
  output \Voyant%20Gauche 
);
  wire Init$not, AUdur$not;
  wire T0$1, T0$clear;
  wire T1$1, T1$clear;
  wire T0$1$not, T2$clear;
  wire T3$clear;
  wire T4$1, T4$2, T4$3, T4$4, T4$5, T4$clear;
  wire T4$5$not, T5$clear;
  wire T6$clear;
  wire T7$clear;
  wire T0$clear$not, T2$clear$not, X0$hold, X0$evolved, X0$next;
  wire T1$clear$not, X1$hold, X1$evolved, X1$next;
  wire T4$clear$not, T5$clear$not, X2$hold, X2$evolved, X2$next;
  wire T3$clear$not, X3$hold, X3$evolved, X3$next;
  wire T6$clear$not, X4$hold, X4$evolved, X4$next;
  wire T7$clear$not, X5$hold, X5$evolved, X5$next;
  wire \Sens%20Moteur$1 , \Sens%20Moteur$2 , \Sens%20Moteur$3 , \Sens%20Moteur$4 , \Sens%20Moteur$5 , \Sens%20Moteur$6 , \Sens%20Moteur$6$not , X4$not, \Sens%20Moteur$when7 , \Sens%20Moteur$next$a1 , \Sens%20Moteur$when7$not , \Sens%20Moteur$next$a2 , \Sens%20Moteur$next$a3 ;
  wire X2$not, r0$when1, r0$next$a1, r0$when1$not, r0$next$a2, r0$next$a3, r0;
  wire b0$not, r1$1, r1$when2, r1$next$a1, r1$when2$not, r1$next$a2, r1$next$a3, r1;
  wire b1$not, r2$1, r2$when2, r2$next$a1, r2$when2$not, r2$next$a2, r2$next$a3, r2;
  wire b2$not, r3$1, r3$when2, r3$next$a1, r3$when2$not, r3$next$a2, r3$next$a3, r3;
  wire \Marche%20Moteur$1 , AUdoux$not, \Marche%20Moteur$2 ;
  wire \Voyant%20Droite$1 , \Voyant%20Droite$2 , \Voyant%20Droite$3 , \Voyant%20Droite$4 ;
  wire \Sens%20Moteur$not , \Voyant%20Gauche$1 , \Voyant%20Gauche$2 , \Voyant%20Gauche$3 , \Voyant%20Gauche$4 ;

  // inputs
  not Init$not$g (Init$not, Init);
  not AUdur$not$g (AUdur$not, AUdur);

  // T0
  or T0$1$g (T0$1, p0, p1, p2, p3);
  and T0$clear$g (T0$clear, X0, T0$1, Init$not);

  // T1
  or T1$1$g (T1$1, b0, b1, b2, b3);
  and T1$clear$g (T1$clear, X1, T1$1, Init$not);

  // T2
  not T0$1$not$g (T0$1$not, T0$1);
  and T2$clear$g (T2$clear, X0, T0$1$not, Init$not);

  // T3
  and T3$clear$g (T3$clear, X3, T0$1, Init$not);

  // T4
  and T4$1$g (T4$1, p0, r0);
  and T4$2$g (T4$2, p1, r1);
  and T4$3$g (T4$3, p2, r2);
  and T4$4$g (T4$4, p3, r3);
  or T4$5$g (T4$5, T4$1, T4$2, T4$3, T4$4);
  and T4$clear$g (T4$clear, X2, T4$5, Init$not);

  // T5
  not T4$5$not$g (T4$5$not, T4$5);
  and T5$clear$g (T5$clear, X2, T4$5$not, Init$not);

  // T6
  and T6$clear$g (T6$clear, X4, Init$not);

  // T7
  and T7$clear$g (T7$clear, X5, T4$5, Init$not);

  // X0 = (X3.(p0 + p1 + p2 + p3) + X2.(p0.r0 + p1.r1 + p2.r2 + p3.r3) + X5.(p0.r0 + p1.r1 + p2.r2 + p3.r3) + /(X0.(p0 + p1 + p2 + p3) + X0./(p0 + p1 + p2 + p3)).X0 + Init)./AUdur
  not T0$clear$not$g (T0$clear$not, T0$clear);
  not T2$clear$not$g (T2$clear$not, T2$clear);
  and X0$hold$g (X0$hold, X0, T0$clear$not, T2$clear$not);
  or X0$evolved$g (X0$evolved, T3$clear, T4$clear, T7$clear, X0$hold, Init);
  and X0$next$g (X0$next, X0$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b1)) X0$g (.d(X0$next), .c(clk), .q(X0));

  // X1 = (X0.(p0 + p1 + p2 + p3) + /(X1.(b0 + b1 + b2 + b3)).X1)./Init./AUdur
  not T1$clear$not$g (T1$clear$not, T1$clear);
  and X1$hold$g (X1$hold, X1, T1$clear$not, Init$not);
  or X1$evolved$g (X1$evolved, T0$clear, X1$hold);
  and X1$next$g (X1$next, X1$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X1$g (.d(X1$next), .c(clk), .q(X1));

  // X2 = (X1.(b0 + b1 + b2 + b3) + /(X2.(p0.r0 + p1.r1 + p2.r2 + p3.r3) + X2./(p0.r0 + p1.r1 + p2.r2 + p3.r3)).X2)./Init./AUdur
  not T4$clear$not$g (T4$clear$not, T4$clear);
  not T5$clear$not$g (T5$clear$not, T5$clear);
  and X2$hold$g (X2$hold, X2, T4$clear$not, T5$clear$not, Init$not);
  or X2$evolved$g (X2$evolved, T1$clear, X2$hold);
  and X2$next$g (X2$next, X2$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X2$g (.d(X2$next), .c(clk), .q(X2));

  // X3 = (X0./(p0 + p1 + p2 + p3) + /(X3.(p0 + p1 + p2 + p3)).X3)./Init./AUdur
  not T3$clear$not$g (T3$clear$not, T3$clear);
  and X3$hold$g (X3$hold, X3, T3$clear$not, Init$not);
  or X3$evolved$g (X3$evolved, T2$clear, X3$hold);
  and X3$next$g (X3$next, X3$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X3$g (.d(X3$next), .c(clk), .q(X3));

  // X4 = (X2./(p0.r0 + p1.r1 + p2.r2 + p3.r3) + /X4.X4)./Init./AUdur
  not T6$clear$not$g (T6$clear$not, T6$clear);
  and X4$hold$g (X4$hold, X4, T6$clear$not, Init$not);
  or X4$evolved$g (X4$evolved, T5$clear, X4$hold);
  and X4$next$g (X4$next, X4$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X4$g (.d(X4$next), .c(clk), .q(X4));

  // X5 = (X4 + /(X5.(p0.r0 + p1.r1 + p2.r2 + p3.r3)).X5)./Init./AUdur
  not T7$clear$not$g (T7$clear$not, T7$clear);
  and X5$hold$g (X5$hold, X5, T7$clear$not, Init$not);
  or X5$evolved$g (X5$evolved, T6$clear, X5$hold);
  and X5$next$g (X5$next, X5$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X5$g (.d(X5$next), .c(clk), .q(X5));

  // Sens Moteur
  or \Sens%20Moteur$1$g  (\Sens%20Moteur$1 , p1, p2, p3);
  and \Sens%20Moteur$2$g  (\Sens%20Moteur$2 , r0, \Sens%20Moteur$1 );
  or \Sens%20Moteur$3$g  (\Sens%20Moteur$3 , p2, p3);
  and \Sens%20Moteur$4$g  (\Sens%20Moteur$4 , r1, \Sens%20Moteur$3 );
  and \Sens%20Moteur$5$g  (\Sens%20Moteur$5 , r2, p3);
  or \Sens%20Moteur$6$g  (\Sens%20Moteur$6 , \Sens%20Moteur$2 , \Sens%20Moteur$4 , \Sens%20Moteur$5 );
  not \Sens%20Moteur$6$not$g  (\Sens%20Moteur$6$not , \Sens%20Moteur$6 );
  not X4$not$g (X4$not, X4);
  and \Sens%20Moteur$when7$g  (\Sens%20Moteur$when7 , X4$not, X4$next);
  and \Sens%20Moteur$next$a1$g  (\Sens%20Moteur$next$a1 , \Sens%20Moteur$when7 , \Sens%20Moteur$6$not );
  not \Sens%20Moteur$when7$not$g  (\Sens%20Moteur$when7$not , \Sens%20Moteur$when7 );
  and \Sens%20Moteur$next$a2$g  (\Sens%20Moteur$next$a2 , \Sens%20Moteur$when7$not , \Sens%20Moteur );
  or \Sens%20Moteur$next$a3$g  (\Sens%20Moteur$next$a3 , \Sens%20Moteur$next$a1 , \Sens%20Moteur$next$a2 );
  grafwire_dff #(.INIT(1'b0)) \Sens%20Moteur$g  (.d(\Sens%20Moteur$next$a3 ), .c(clk), .q(\Sens%20Moteur ));

  // r0
  not X2$not$g (X2$not, X2);
  and r0$when1$g (r0$when1, X2$not, X2$next);
  and r0$next$a1$g (r0$next$a1, r0$when1, b0);
  not r0$when1$not$g (r0$when1$not, r0$when1);
  and r0$next$a2$g (r0$next$a2, r0$when1$not, r0);
  or r0$next$a3$g (r0$next$a3, r0$next$a1, r0$next$a2);
  grafwire_dff #(.INIT(1'b0)) r0$g (.d(r0$next$a3), .c(clk), .q(r0));

  // r1
  not b0$not$g (b0$not, b0);
  and r1$1$g (r1$1, b1, b0$not);
  and r1$when2$g (r1$when2, X2$not, X2$next);
  and r1$next$a1$g (r1$next$a1, r1$when2, r1$1);
  not r1$when2$not$g (r1$when2$not, r1$when2);
  and r1$next$a2$g (r1$next$a2, r1$when2$not, r1);
  or r1$next$a3$g (r1$next$a3, r1$next$a1, r1$next$a2);
  grafwire_dff #(.INIT(1'b0)) r1$g (.d(r1$next$a3), .c(clk), .q(r1));

  // r2
  not b1$not$g (b1$not, b1);
  and r2$1$g (r2$1, b2, b1$not, b0$not);
  and r2$when2$g (r2$when2, X2$not, X2$next);
  and r2$next$a1$g (r2$next$a1, r2$when2, r2$1);
  not r2$when2$not$g (r2$when2$not, r2$when2);
  and r2$next$a2$g (r2$next$a2, r2$when2$not, r2);
  or r2$next$a3$g (r2$next$a3, r2$next$a1, r2$next$a2);
  grafwire_dff #(.INIT(1'b0)) r2$g (.d(r2$next$a3), .c(clk), .q(r2));

  // r3
  not b2$not$g (b2$not, b2);
  and r3$1$g (r3$1, b3, b2$not, b1$not, b0$not);
  and r3$when2$g (r3$when2, X2$not, X2$next);
  and r3$next$a1$g (r3$next$a1, r3$when2, r3$1);
  not r3$when2$not$g (r3$when2$not, r3$when2);
  and r3$next$a2$g (r3$next$a2, r3$when2$not, r3);
  or r3$next$a3$g (r3$next$a3, r3$next$a1, r3$next$a2);
  grafwire_dff #(.INIT(1'b0)) r3$g (.d(r3$next$a3), .c(clk), .q(r3));

  // Marche Moteur = (X3 + X5)./AUdoux
  or \Marche%20Moteur$1$g  (\Marche%20Moteur$1 , X3, X5);
  not AUdoux$not$g (AUdoux$not, AUdoux);
  and \Marche%20Moteur$2$g  (\Marche%20Moteur$2 , \Marche%20Moteur$1 , AUdoux$not);
  buf \Marche%20Moteur$g  (\Marche%20Moteur , \Marche%20Moteur$2 );

  // Voyant Droite = (X3."Sens Moteur" + X5."Sens Moteur")./AUdoux
  and \Voyant%20Droite$1$g  (\Voyant%20Droite$1 , X3, \Sens%20Moteur );
  and \Voyant%20Droite$2$g  (\Voyant%20Droite$2 , X5, \Sens%20Moteur );
  or \Voyant%20Droite$3$g  (\Voyant%20Droite$3 , \Voyant%20Droite$1 , \Voyant%20Droite$2 );
  and \Voyant%20Droite$4$g  (\Voyant%20Droite$4 , \Voyant%20Droite$3 , AUdoux$not);
  buf \Voyant%20Droite$g  (\Voyant%20Droite , \Voyant%20Droite$4 );

  // Voyant Gauche = (X3./"Sens Moteur" + X5./"Sens Moteur")./AUdoux
  not \Sens%20Moteur$not$g  (\Sens%20Moteur$not , \Sens%20Moteur );
  and \Voyant%20Gauche$1$g  (\Voyant%20Gauche$1 , X3, \Sens%20Moteur$not );
  and \Voyant%20Gauche$2$g  (\Voyant%20Gauche$2 , X5, \Sens%20Moteur$not );
  or \Voyant%20Gauche$3$g  (\Voyant%20Gauche$3 , \Voyant%20Gauche$1 , \Voyant%20Gauche$2 );
  and \Voyant%20Gauche$4$g  (\Voyant%20Gauche$4 , \Voyant%20Gauche$3 , AUdoux$not);
  buf \Voyant%20Gauche$g  (\Voyant%20Gauche , \Voyant%20Gauche$4 );
endmodule

`timescale 1ps/1ps

// D flip-flop.
module grafwire_dff #(parameter INIT = 1'bx) (input d, input c, output reg q);
  initial q = INIT;
  always @(posedge c) q <= d;
endmodule
