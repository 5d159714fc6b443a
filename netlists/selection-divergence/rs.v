// selection_divergence "Choix de séquence, divergence" (selection-divergence.grafcet): 30 cells.
// Style rs, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist selection-divergence.grafcet --style rs --cdx successor --modes on --to verilog
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $init    Init activates the step
//   $not     the owner inverted
//   $q       the other gate of the latch
//   $resetN  resets the owner: term N of CDX, or write N
//   $setT    sets the owner: of a step, by transition T; of others, write T
// GATE_NS is how long a gate takes, in ns. Pulses last several gate delays and grow with it.
`timescale 1ns/1ps

module selection_divergence #(parameter GATE_NS = 1) (
  input a,
  input x,
  input z,
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
  wire a$not, X6$set11, X6$set21, X6$init, X6$reset0, X6$q;
  wire X7$set6, X7$reset0, X7$reset1, X7$q;
  wire X10$set7, X10$reset0, X10$q;
  wire X11$set10, X11$reset0, X11$q;
  wire X20$set8, X20$reset0, X20$q;
  wire X21$set20, X21$reset0, X21$q;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);

  // X6 = (X11./a + X21./a + /X7.X6 + Init)./AUdur
  not #GATE_NS a$not$g (a$not, a);
  nand #GATE_NS X6$set11$g (X6$set11, X11, a$not, AUdur$not);
  nand #GATE_NS X6$set21$g (X6$set21, X21, a$not, AUdur$not);
  nand #GATE_NS X6$init$g (X6$init, Init, AUdur$not);
  not #GATE_NS X6$reset0$g (X6$reset0, X7);
  nand #GATE_NS X6$g (X6, X6$set11, X6$set21, X6$init, X6$q);
  nand #GATE_NS X6$q$g (X6$q, X6$reset0, AUdur$not, X6);

  // X7 = (X6.a + /(X10 + X20).X7)./Init./AUdur
  nand #GATE_NS X7$set6$g (X7$set6, X6, a, Init$not, AUdur$not);
  not #GATE_NS X7$reset0$g (X7$reset0, X10);
  not #GATE_NS X7$reset1$g (X7$reset1, X20);
  nand #GATE_NS X7$g (X7, X7$set6, X7$q);
  nand #GATE_NS X7$q$g (X7$q, X7$reset0, X7$reset1, Init$not, AUdur$not, X7);

  // X10 = (X7.x + /X11.X10)./Init./AUdur
  nand #GATE_NS X10$set7$g (X10$set7, X7, x, Init$not, AUdur$not);
  not #GATE_NS X10$reset0$g (X10$reset0, X11);
  nand #GATE_NS X10$g (X10, X10$set7, X10$q);
  nand #GATE_NS X10$q$g (X10$q, X10$reset0, Init$not, AUdur$not, X10);

  // X11 = (X10.y + /X6.X11)./Init./AUdur
  nand #GATE_NS X11$set10$g (X11$set10, X10, y, Init$not, AUdur$not);
  not #GATE_NS X11$reset0$g (X11$reset0, X6);
  nand #GATE_NS X11$g (X11, X11$set10, X11$q);
  nand #GATE_NS X11$q$g (X11$q, X11$reset0, Init$not, AUdur$not, X11);

  // X20 = (X7.z + /X21.X20)./Init./AUdur
  nand #GATE_NS X20$set8$g (X20$set8, X7, z, Init$not, AUdur$not);
  not #GATE_NS X20$reset0$g (X20$reset0, X21);
  nand #GATE_NS X20$g (X20, X20$set8, X20$q);
  nand #GATE_NS X20$q$g (X20$q, X20$reset0, Init$not, AUdur$not, X20);

  // X21 = (X20.t + /X6.X21)./Init./AUdur
  nand #GATE_NS X21$set20$g (X21$set20, X20, t, Init$not, AUdur$not);
  not #GATE_NS X21$reset0$g (X21$reset0, X6);
  nand #GATE_NS X21$g (X21, X21$set20, X21$q);
  nand #GATE_NS X21$q$g (X21$q, X21$reset0, Init$not, AUdur$not, X21);
endmodule
