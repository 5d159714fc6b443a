// positioning_axis "Axe de positionnement" (positioning-axis.grafcet): 121 cells.
// Style rs, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist positioning-axis.grafcet --style rs --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $N       a gate of a condition of the owner
//   $buf     the owner, a gate delay later
//   $held    the owner as it was before the writes of this instant
//   $idle    nothing is being written to the owner
//   $init    Init activates the step
//   $not     the owner inverted
//   $q       the other gate of the latch
//   $resetN  resets the owner: term N of CDX, or write N
//   $riseN   rising edge of the owner, edge N of the chart
//   $setT    sets the owner: of a step, by transition T; of others, write T
//   \Marche%20Moteur = Marche Moteur
//   \Sens%20Moteur = Sens Moteur
//   \Voyant%20Droite = Voyant Droite
//   \Voyant%20Gauche = Voyant Gauche
// GATE_NS is how long a gate takes, in ns. Pulses last several gate delays and grow with it.
`timescale 1ns/1ps

// When the netlist is let go after power-up, in ns, and the moment, in ps, from which a delay that
// begins now counts. A test bench may set these before.
`ifndef GRAFWIRE_START
`define GRAFWIRE_START (100 * GATE_NS)
`endif
`ifndef GRAFWIRE_INSTANT
`define GRAFWIRE_INSTANT $time
`endif

module positioning_axis #(parameter GATE_NS = 1) (
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
  wire X0$1, X0$set3, X0$2, X0$3, X0$4, X0$5, X0$6, X2$buf, X2$buf$buf, X2$buf$buf$buf, X2$buf$buf$buf$buf, X2$buf$buf$buf$buf$buf, X2$buf$buf$buf$buf$buf$buf, X0$set4, X5$buf, X5$buf$buf, X5$buf$buf$buf, X5$buf$buf$buf$buf, X5$buf$buf$buf$buf$buf, X5$buf$buf$buf$buf$buf$buf, X0$set7, X0$init, X0$reset0, X0$reset1, X0$q;
  wire X1$set0, X1$reset0, X1$q;
  wire X2$1, X2$set1, X2$reset0, X2$reset1, X2$q;
  wire X0$1$not, X3$set2, X3$reset0, X3$q;
  wire X0$6$not, X2$buf$buf$buf$buf$buf$buf$buf, X4$set5, X4$reset0, X4$q;
  wire X4$buf, X4$buf$buf, X4$buf$buf$buf, X4$buf$buf$buf$buf, X5$set6, X5$reset0, X5$q;
  wire \Marche%20Moteur$1 , AUdoux$not;
  wire X3$buf, X3$buf$buf, X3$buf$buf$buf, X3$buf$buf$buf$buf, \Voyant%20Droite$1 , \Voyant%20Droite$2 , \Voyant%20Droite$3 ;
  wire \Sens%20Moteur$not , X3$buf$buf$buf$buf$buf, \Voyant%20Gauche$1 , \Voyant%20Gauche$2 , \Voyant%20Gauche$3 ;
  wire X2$rise0, r0$idle, r0$held;
  wire r1$idle, r1$held;
  wire r2$idle, r2$held;
  wire X4$rise1, \Sens%20Moteur$1 , \Sens%20Moteur$2 , \Sens%20Moteur$3 , \Sens%20Moteur$4 , \Sens%20Moteur$5 , \Sens%20Moteur$6 , \Sens%20Moteur$7 , \Sens%20Moteur$8 , \Sens%20Moteur$7$buf , \Sens%20Moteur$9 , \Sens%20Moteur$10 , \Sens%20Moteur$9$not , \Sens%20Moteur$set0 , \Sens%20Moteur$reset0 ;
  wire r0$set0, b0$not, r0$reset0, r0;
  wire b1$buf, r1$1, r1$set0, r1$1$not, r1$reset0, r1;
  wire b1$not, b2$buf, r2$1, r2$set0, r2$1$not, r2$reset0, r2;
  wire b2$not, b3$buf, r3$1, r3$set0, r3$1$not, r3$reset0, r3;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);

  // X0 = (X3.(p0 + p1 + p2 + p3) + X2.(p0.r0 + p1.r1 + p2.r2 + p3.r3) + X5.(p0.r0 + p1.r1 + p2.r2 + p3.r3) + /(X1 + X3).X0 + Init)./AUdur
  or #GATE_NS X0$1$g (X0$1, p0, p1, p2, p3);
  nand #GATE_NS X0$set3$g (X0$set3, X3, X0$1, AUdur$not);
  and #GATE_NS X0$2$g (X0$2, p0, r0);
  and #GATE_NS X0$3$g (X0$3, p1, r1);
  and #GATE_NS X0$4$g (X0$4, p2, r2);
  and #GATE_NS X0$5$g (X0$5, p3, r3);
  or #GATE_NS X0$6$g (X0$6, X0$2, X0$3, X0$4, X0$5);
  buf #GATE_NS X2$buf$g (X2$buf, X2);
  buf #GATE_NS X2$buf$buf$g (X2$buf$buf, X2$buf);
  buf #GATE_NS X2$buf$buf$buf$g (X2$buf$buf$buf, X2$buf$buf);
  buf #GATE_NS X2$buf$buf$buf$buf$g (X2$buf$buf$buf$buf, X2$buf$buf$buf);
  buf #GATE_NS X2$buf$buf$buf$buf$buf$g (X2$buf$buf$buf$buf$buf, X2$buf$buf$buf$buf);
  buf #GATE_NS X2$buf$buf$buf$buf$buf$buf$g (X2$buf$buf$buf$buf$buf$buf, X2$buf$buf$buf$buf$buf);
  nand #GATE_NS X0$set4$g (X0$set4, X2$buf$buf$buf$buf$buf$buf, X0$6, AUdur$not);
  buf #GATE_NS X5$buf$g (X5$buf, X5);
  buf #GATE_NS X5$buf$buf$g (X5$buf$buf, X5$buf);
  buf #GATE_NS X5$buf$buf$buf$g (X5$buf$buf$buf, X5$buf$buf);
  buf #GATE_NS X5$buf$buf$buf$buf$g (X5$buf$buf$buf$buf, X5$buf$buf$buf);
  buf #GATE_NS X5$buf$buf$buf$buf$buf$g (X5$buf$buf$buf$buf$buf, X5$buf$buf$buf$buf);
  buf #GATE_NS X5$buf$buf$buf$buf$buf$buf$g (X5$buf$buf$buf$buf$buf$buf, X5$buf$buf$buf$buf$buf);
  nand #GATE_NS X0$set7$g (X0$set7, X5$buf$buf$buf$buf$buf$buf, X0$6, AUdur$not);
  nand #GATE_NS X0$init$g (X0$init, Init, AUdur$not);
  not #GATE_NS X0$reset0$g (X0$reset0, X1);
  not #GATE_NS X0$reset1$g (X0$reset1, X3);
  nand #GATE_NS X0$g (X0, X0$set3, X0$set4, X0$set7, X0$init, X0$q);
  nand #GATE_NS X0$q$g (X0$q, X0$reset0, X0$reset1, AUdur$not, X0);

  // X1 = (X0.(p0 + p1 + p2 + p3) + /X2.X1)./Init./AUdur
  nand #GATE_NS X1$set0$g (X1$set0, X0, X0$1, Init$not, AUdur$not);
  not #GATE_NS X1$reset0$g (X1$reset0, X2);
  nand #GATE_NS X1$g (X1, X1$set0, X1$q);
  nand #GATE_NS X1$q$g (X1$q, X1$reset0, Init$not, AUdur$not, X1);

  // X2 = (X1.(b0 + b1 + b2 + b3) + /(X0 + X4).X2)./Init./AUdur
  or #GATE_NS X2$1$g (X2$1, b0, b1, b2, b3);
  nand #GATE_NS X2$set1$g (X2$set1, X1, X2$1, Init$not, AUdur$not);
  not #GATE_NS X2$reset0$g (X2$reset0, X0);
  not #GATE_NS X2$reset1$g (X2$reset1, X4);
  nand #GATE_NS X2$g (X2, X2$set1, X2$q);
  nand #GATE_NS X2$q$g (X2$q, X2$reset0, X2$reset1, Init$not, AUdur$not, X2);

  // X3 = (X0./(p0 + p1 + p2 + p3) + /X0.X3)./Init./AUdur
  not #GATE_NS X0$1$not$g (X0$1$not, X0$1);
  nand #GATE_NS X3$set2$g (X3$set2, X0, X0$1$not, Init$not, AUdur$not);
  not #GATE_NS X3$reset0$g (X3$reset0, X0);
  nand #GATE_NS X3$g (X3, X3$set2, X3$q);
  nand #GATE_NS X3$q$g (X3$q, X3$reset0, Init$not, AUdur$not, X3);

  // X4 = (X2./(p0.r0 + p1.r1 + p2.r2 + p3.r3) + /X5.X4)./Init./AUdur
  not #GATE_NS X0$6$not$g (X0$6$not, X0$6);
  buf #GATE_NS X2$buf$buf$buf$buf$buf$buf$buf$g (X2$buf$buf$buf$buf$buf$buf$buf, X2$buf$buf$buf$buf$buf$buf);
  nand #GATE_NS X4$set5$g (X4$set5, X2$buf$buf$buf$buf$buf$buf$buf, X0$6$not, Init$not, AUdur$not);
  not #GATE_NS X4$reset0$g (X4$reset0, X5);
  nand #GATE_NS X4$g (X4, X4$set5, X4$q);
  nand #GATE_NS X4$q$g (X4$q, X4$reset0, Init$not, AUdur$not, X4);

  // X5 = (X4 + /X0.X5)./Init./AUdur
  buf #GATE_NS X4$buf$g (X4$buf, X4);
  buf #GATE_NS X4$buf$buf$g (X4$buf$buf, X4$buf);
  buf #GATE_NS X4$buf$buf$buf$g (X4$buf$buf$buf, X4$buf$buf);
  buf #GATE_NS X4$buf$buf$buf$buf$g (X4$buf$buf$buf$buf, X4$buf$buf$buf);
  nand #GATE_NS X5$set6$g (X5$set6, X4$buf$buf$buf$buf, Init$not, AUdur$not);
  not #GATE_NS X5$reset0$g (X5$reset0, X0);
  nand #GATE_NS X5$g (X5, X5$set6, X5$q);
  nand #GATE_NS X5$q$g (X5$q, X5$reset0, Init$not, AUdur$not, X5);

  // Marche Moteur = (X3 + X5)./AUdoux
  or #GATE_NS \Marche%20Moteur$1$g  (\Marche%20Moteur$1 , X3, X5);
  not #GATE_NS AUdoux$not$g (AUdoux$not, AUdoux);
  and #GATE_NS \Marche%20Moteur$g  (\Marche%20Moteur , \Marche%20Moteur$1 , AUdoux$not);

  // Voyant Droite = (X3."Sens Moteur" + X5."Sens Moteur")./AUdoux
  buf #GATE_NS X3$buf$g (X3$buf, X3);
  buf #GATE_NS X3$buf$buf$g (X3$buf$buf, X3$buf);
  buf #GATE_NS X3$buf$buf$buf$g (X3$buf$buf$buf, X3$buf$buf);
  buf #GATE_NS X3$buf$buf$buf$buf$g (X3$buf$buf$buf$buf, X3$buf$buf$buf);
  and #GATE_NS \Voyant%20Droite$1$g  (\Voyant%20Droite$1 , X3$buf$buf$buf$buf, \Sens%20Moteur );
  and #GATE_NS \Voyant%20Droite$2$g  (\Voyant%20Droite$2 , X5$buf$buf$buf$buf, \Sens%20Moteur );
  or #GATE_NS \Voyant%20Droite$3$g  (\Voyant%20Droite$3 , \Voyant%20Droite$1 , \Voyant%20Droite$2 );
  and #GATE_NS \Voyant%20Droite$g  (\Voyant%20Droite , \Voyant%20Droite$3 , AUdoux$not);

  // Voyant Gauche = (X3./"Sens Moteur" + X5./"Sens Moteur")./AUdoux
  not #GATE_NS \Sens%20Moteur$not$g  (\Sens%20Moteur$not , \Sens%20Moteur );
  buf #GATE_NS X3$buf$buf$buf$buf$buf$g (X3$buf$buf$buf$buf$buf, X3$buf$buf$buf$buf);
  and #GATE_NS \Voyant%20Gauche$1$g  (\Voyant%20Gauche$1 , X3$buf$buf$buf$buf$buf, \Sens%20Moteur$not );
  and #GATE_NS \Voyant%20Gauche$2$g  (\Voyant%20Gauche$2 , X5$buf$buf$buf$buf$buf, \Sens%20Moteur$not );
  or #GATE_NS \Voyant%20Gauche$3$g  (\Voyant%20Gauche$3 , \Voyant%20Gauche$1 , \Voyant%20Gauche$2 );
  and #GATE_NS \Voyant%20Gauche$g  (\Voyant%20Gauche , \Voyant%20Gauche$3 , AUdoux$not);

  // r0: set ↑X2.b0 reset ↑X2./b0
  grafwire_rise_pulse #(.GATE_NS(GATE_NS), .WIDTH_NS(2 * GATE_NS)) X2$rise0$g (.a(X2), .q(X2$rise0));
  not #GATE_NS r0$idle$g (r0$idle, X2$rise0);
  grafwire_hold #(.GATE_NS(GATE_NS), .INIT(1'b0)) r0$held$g (.d(r0), .e(r0$idle), .q(r0$held));

  // r1: set ↑X2.b1./b0 reset ↑X2./(b1./b0)
  not #GATE_NS r1$idle$g (r1$idle, X2$rise0);
  grafwire_hold #(.GATE_NS(GATE_NS), .INIT(1'b0)) r1$held$g (.d(r1), .e(r1$idle), .q(r1$held));

  // r2: set ↑X2.b2./b1./b0 reset ↑X2./(b2./b1./b0)
  not #GATE_NS r2$idle$g (r2$idle, X2$rise0);
  grafwire_hold #(.GATE_NS(GATE_NS), .INIT(1'b0)) r2$held$g (.d(r2), .e(r2$idle), .q(r2$held));

  // Sens Moteur: set ↑X4./(r0.(p1 + p2 + p3) + r1.(p2 + p3) + r2.p3) reset ↑X4.(r0.(p1 + p2 + p3) + r1.(p2 + p3) + r2.p3)
  grafwire_rise_pulse #(.GATE_NS(GATE_NS), .WIDTH_NS(2 * GATE_NS)) X4$rise1$g (.a(X4), .q(X4$rise1));
  or #GATE_NS \Sens%20Moteur$1$g  (\Sens%20Moteur$1 , p1, p2, p3);
  and #GATE_NS \Sens%20Moteur$2$g  (\Sens%20Moteur$2 , r0$held, \Sens%20Moteur$1 );
  and #GATE_NS \Sens%20Moteur$3$g  (\Sens%20Moteur$3 , r0, \Sens%20Moteur$1 );
  or #GATE_NS \Sens%20Moteur$4$g  (\Sens%20Moteur$4 , p2, p3);
  and #GATE_NS \Sens%20Moteur$5$g  (\Sens%20Moteur$5 , r1$held, \Sens%20Moteur$4 );
  and #GATE_NS \Sens%20Moteur$6$g  (\Sens%20Moteur$6 , r1, \Sens%20Moteur$4 );
  and #GATE_NS \Sens%20Moteur$7$g  (\Sens%20Moteur$7 , r2$held, p3);
  and #GATE_NS \Sens%20Moteur$8$g  (\Sens%20Moteur$8 , r2, p3);
  buf #GATE_NS \Sens%20Moteur$7$buf$g  (\Sens%20Moteur$7$buf , \Sens%20Moteur$7 );
  or #GATE_NS \Sens%20Moteur$9$g  (\Sens%20Moteur$9 , \Sens%20Moteur$2 , \Sens%20Moteur$5 , \Sens%20Moteur$7$buf );
  or #GATE_NS \Sens%20Moteur$10$g  (\Sens%20Moteur$10 , \Sens%20Moteur$3 , \Sens%20Moteur$6 , \Sens%20Moteur$8 );
  not #GATE_NS \Sens%20Moteur$9$not$g  (\Sens%20Moteur$9$not , \Sens%20Moteur$9 );
  and #GATE_NS \Sens%20Moteur$set0$g  (\Sens%20Moteur$set0 , X4$rise1, \Sens%20Moteur$9$not );
  and #GATE_NS \Sens%20Moteur$reset0$g  (\Sens%20Moteur$reset0 , X4$rise1, \Sens%20Moteur$9 );
  grafwire_latch #(.GATE_NS(GATE_NS), .INIT(1'b0)) \Sens%20Moteur$g  (.s(\Sens%20Moteur$set0 ), .r(\Sens%20Moteur$reset0 ), .q(\Sens%20Moteur ));

  // r0: set ↑X2.b0 reset ↑X2./b0
  and #GATE_NS r0$set0$g (r0$set0, X2$rise0, b0);
  not #GATE_NS b0$not$g (b0$not, b0);
  and #GATE_NS r0$reset0$g (r0$reset0, X2$rise0, b0$not);
  grafwire_latch #(.GATE_NS(GATE_NS), .INIT(1'b0)) r0$g (.s(r0$set0), .r(r0$reset0), .q(r0));

  // r1: set ↑X2.b1./b0 reset ↑X2./(b1./b0)
  buf #GATE_NS b1$buf$g (b1$buf, b1);
  and #GATE_NS r1$1$g (r1$1, b1$buf, b0$not);
  and #GATE_NS r1$set0$g (r1$set0, X2$rise0, r1$1);
  not #GATE_NS r1$1$not$g (r1$1$not, r1$1);
  and #GATE_NS r1$reset0$g (r1$reset0, X2$rise0, r1$1$not);
  grafwire_latch #(.GATE_NS(GATE_NS), .INIT(1'b0)) r1$g (.s(r1$set0), .r(r1$reset0), .q(r1));

  // r2: set ↑X2.b2./b1./b0 reset ↑X2./(b2./b1./b0)
  not #GATE_NS b1$not$g (b1$not, b1);
  buf #GATE_NS b2$buf$g (b2$buf, b2);
  and #GATE_NS r2$1$g (r2$1, b2$buf, b1$not, b0$not);
  and #GATE_NS r2$set0$g (r2$set0, X2$rise0, r2$1);
  not #GATE_NS r2$1$not$g (r2$1$not, r2$1);
  and #GATE_NS r2$reset0$g (r2$reset0, X2$rise0, r2$1$not);
  grafwire_latch #(.GATE_NS(GATE_NS), .INIT(1'b0)) r2$g (.s(r2$set0), .r(r2$reset0), .q(r2));

  // r3: set ↑X2.b3./b2./b1./b0 reset ↑X2./(b3./b2./b1./b0)
  not #GATE_NS b2$not$g (b2$not, b2);
  buf #GATE_NS b3$buf$g (b3$buf, b3);
  and #GATE_NS r3$1$g (r3$1, b3$buf, b2$not, b1$not, b0$not);
  and #GATE_NS r3$set0$g (r3$set0, X2$rise0, r3$1);
  not #GATE_NS r3$1$not$g (r3$1$not, r3$1);
  and #GATE_NS r3$reset0$g (r3$reset0, X2$rise0, r3$1$not);
  grafwire_latch #(.GATE_NS(GATE_NS), .INIT(1'b0)) r3$g (.s(r3$set0), .r(r3$reset0), .q(r3));
endmodule

`timescale 1ps/1ps

// Latch: s sets, r resets, both at once set.
module grafwire_latch #(parameter GATE_NS = 1, INIT = 1'bx) (input s, input r, output q);
  reg m;
`ifdef SYNTHESIS
  initial m = INIT;
  always @(s or r) if (s) m = 1'b1; else if (r) m = 1'b0;
`else
  reg started;
  initial begin
    m = INIT; started = 0;
    #(64'd1000 * `GRAFWIRE_START) started = 1;
  end
  always @(s or r or started) if (started) m = s | (~r & m);
`endif
  assign #(1000 * GATE_NS) q = m;
endmodule

// Hold latch: follows d while e is 1.
module grafwire_hold #(parameter GATE_NS = 1, INIT = 1'bx) (input d, input e, output q);
  reg m;
`ifdef SYNTHESIS
  initial m = INIT;
  always @(d or e) if (e) m = d;
`else
  reg started;
  initial begin
    m = INIT; started = 0;
    #(64'd1000 * `GRAFWIRE_START) started = 1;
  end
  always @(d or e or started) if (started) m = e ? d : m;
`endif
  assign #(1000 * GATE_NS) q = m;
endmodule

// Rising-edge pulse: 1 for WIDTH_NS after each rise of a, begun again by a new rise.
`ifdef SYNTHESIS
(* blackbox *)
`endif
module grafwire_rise_pulse #(parameter GATE_NS = 1, WIDTH_NS = 1) (input a, output q);
`ifndef SYNTHESIS
  reg last;
  integer begun = 0, ended = 0;
  always @(a) begin
    if (last === 1'b0 && a === 1'b1) begin
      begun = begun + 1;
      ended <= #(1000 * WIDTH_NS) begun;
    end
    last = a;
  end
  assign #(1000 * GATE_NS) q = begun != ended;
`endif
endmodule
