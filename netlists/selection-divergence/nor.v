// selection_divergence "Choix de séquence, divergence" (selection-divergence.grafcet): 30 cells.
// Style nor, CDX by successor steps, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist selection-divergence.grafcet --style nor --cdx successor --modes on --to verilog
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
  wire X6$reset0, a$not, X6$reset0$not, X6$set11, X6$set21, X6$init, X6$q;
  wire X10$not, X20$not, X7$set6, X7$q;
  wire X11$not, X10$set7, X10$q;
  wire X6$not, X11$set10, X11$q;
  wire X21$not, X20$set8, X20$q;
  wire X21$set20, X21$q;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);
  not #GATE_NS AUdur$not$g (AUdur$not, AUdur);

  // X6 = (X11./a + X21./a + /X7.X6 + Init)./AUdur
  and #GATE_NS X6$reset0$g (X6$reset0, X7, Init$not);
  not #GATE_NS a$not$g (a$not, a);
  not #GATE_NS X6$reset0$not$g (X6$reset0$not, X6$reset0);
  and #GATE_NS X6$set11$g (X6$set11, X11, a$not, X6$reset0$not, AUdur$not);
  and #GATE_NS X6$set21$g (X6$set21, X21, a$not, X6$reset0$not, AUdur$not);
  and #GATE_NS X6$init$g (X6$init, Init, X6$reset0$not, AUdur$not);
  nor #GATE_NS X6$g (X6, X6$reset0, AUdur, X6$q);
  nor #GATE_NS X6$q$g (X6$q, X6$set11, X6$set21, X6$init, X6);

  // X7 = (X6.a + /(X10 + X20).X7)./Init./AUdur
  not #GATE_NS X10$not$g (X10$not, X10);
  not #GATE_NS X20$not$g (X20$not, X20);
  and #GATE_NS X7$set6$g (X7$set6, X6, a, X10$not, X20$not, Init$not, AUdur$not);
  nor #GATE_NS X7$g (X7, X10, X20, Init, AUdur, X7$q);
  nor #GATE_NS X7$q$g (X7$q, X7$set6, X7);

  // X10 = (X7.x + /X11.X10)./Init./AUdur
  not #GATE_NS X11$not$g (X11$not, X11);
  and #GATE_NS X10$set7$g (X10$set7, X7, x, X11$not, Init$not, AUdur$not);
  nor #GATE_NS X10$g (X10, X11, Init, AUdur, X10$q);
  nor #GATE_NS X10$q$g (X10$q, X10$set7, X10);

  // X11 = (X10.y + /X6.X11)./Init./AUdur
  not #GATE_NS X6$not$g (X6$not, X6);
  and #GATE_NS X11$set10$g (X11$set10, X10, y, X6$not, Init$not, AUdur$not);
  nor #GATE_NS X11$g (X11, X6, Init, AUdur, X11$q);
  nor #GATE_NS X11$q$g (X11$q, X11$set10, X11);

  // X20 = (X7.z + /X21.X20)./Init./AUdur
  not #GATE_NS X21$not$g (X21$not, X21);
  and #GATE_NS X20$set8$g (X20$set8, X7, z, X21$not, Init$not, AUdur$not);
  nor #GATE_NS X20$g (X20, X21, Init, AUdur, X20$q);
  nor #GATE_NS X20$q$g (X20$q, X20$set8, X20);

  // X21 = (X20.t + /X6.X21)./Init./AUdur
  and #GATE_NS X21$set20$g (X21$set20, X20, t, X6$not, Init$not, AUdur$not);
  nor #GATE_NS X21$g (X21, X6, Init, AUdur, X21$q);
  nor #GATE_NS X21$q$g (X21$q, X21$set20, X21);
endmodule
