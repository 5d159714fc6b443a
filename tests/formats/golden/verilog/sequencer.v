// sequencer: 16 cells.
// GATE_NS is how long a gate takes, in ns. Pulses last several gate delays and grow with it.
`timescale 1ns/1ps

module sequencer #(parameter GATE_NS = 1) (
  input a,
  input b,
  input c,
  input Init,
  output X0,
  output X1,
  output X2,
  output lamp
);
  wire Init$not;
  wire X0$set, X0$reset, X0$q;
  wire X1$set, X1$any, X1$reset, X1$q;
  wire X2$set, X2$any, X2$reset, X2$q;

  // inputs
  not #GATE_NS Init$not$g (Init$not, Init);

  // X0 = (X2.c + /X1.X0)
  nand #GATE_NS X0$set$g (X0$set, X2, c);
  nand #GATE_NS X0$reset$g (X0$reset, X1, Init$not);
  nand #GATE_NS X0$g (X0, X0$set, X0$q, Init$not);
  nand #GATE_NS X0$q$g (X0$q, X0, X0$reset);

  // X1 = (X0.a + /X2.X1)
  nand #GATE_NS X1$set$g (X1$set, X0, a, Init$not);
  nor #GATE_NS X1$any$g (X1$any, X2, Init);
  buf #GATE_NS X1$reset$g (X1$reset, X1$any);
  nand #GATE_NS X1$g (X1, X1$set, X1$q);
  nand #GATE_NS X1$q$g (X1$q, X1, X1$reset);

  // X2 = (X1.b + /X0.X2)
  nand #GATE_NS X2$set$g (X2$set, X1, b, Init$not);
  nor #GATE_NS X2$any$g (X2$any, X0, Init);
  buf #GATE_NS X2$reset$g (X2$reset, X2$any);
  nand #GATE_NS X2$g (X2, X2$set, X2$q);
  nand #GATE_NS X2$q$g (X2$q, X2, X2$reset);

  // lamp = X1 + X2
  or #GATE_NS lamp$g (lamp, X1, X2);
endmodule
