// rule_5: 15 cells.
`timescale 1ns/1ps

module rule_5 (
  input s,
  input k,
  input Init,
  input AUdur,
  input AUdoux,
  output X1,
  output X2,
  output present,
  output loaded
);
  wire Init$not, AUdur$not;
  wire X1$set0, X1$reset0, X1$q;
  wire T2$clear, X2$set1, X2$init, X2$reset0, X2$q;
  wire AUdoux$not;

  // inputs
  not #1 Init$not$g (Init$not, Init);
  not #1 AUdur$not$g (AUdur$not, AUdur);

  // X1 = (s + /X2.X1)./Init./AUdur
  nand #1 X1$set0$g (X1$set0, s, Init$not, AUdur$not);
  nand #1 X1$reset0$g (X1$reset0, X2, X1$set0);
  nand #1 X1$g (X1, X1$set0, X1$q);
  nand #1 X1$q$g (X1$q, X1$reset0, Init$not, AUdur$not, X1);

  // X2 = (X1 + /(X2.k).X2 + Init)./AUdur
  and #1 T2$clear$g (T2$clear, X2, k);
  nand #1 X2$set1$g (X2$set1, X1, AUdur$not);
  nand #1 X2$init$g (X2$init, Init, AUdur$not);
  nand #1 X2$reset0$g (X2$reset0, T2$clear, X2$set1, X2$init);
  nand #1 X2$g (X2, X2$set1, X2$init, X2$q);
  nand #1 X2$q$g (X2$q, X2$reset0, AUdur$not, X2);

  // present = X1./AUdoux
  not #1 AUdoux$not$g (AUdoux$not, AUdoux);
  and #1 present$g (present, X1, AUdoux$not);

  // loaded = X2./AUdoux
  and #1 loaded$g (loaded, X2, AUdoux$not);
endmodule
