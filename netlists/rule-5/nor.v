// rule_5: 16 cells.
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
  wire X2$not, X1$set0, X1$q;
  wire T2$clear, X2$reset0, X2$reset0$not, X2$set1, X2$init, X2$q;
  wire AUdoux$not;

  // inputs
  not #1 Init$not$g (Init$not, Init);
  not #1 AUdur$not$g (AUdur$not, AUdur);

  // X1 = (s + /X2.X1)./Init./AUdur
  not #1 X2$not$g (X2$not, X2);
  and #1 X1$set0$g (X1$set0, s, X2$not, Init$not, AUdur$not);
  nor #1 X1$g (X1, X2, Init, AUdur, X1$q);
  nor #1 X1$q$g (X1$q, X1$set0, X1);

  // X2 = (X1 + /(X2.k).X2 + Init)./AUdur
  and #1 T2$clear$g (T2$clear, X2, k);
  and #1 X2$reset0$g (X2$reset0, T2$clear, Init$not);
  not #1 X2$reset0$not$g (X2$reset0$not, X2$reset0);
  and #1 X2$set1$g (X2$set1, X1, X2$reset0$not, AUdur$not);
  and #1 X2$init$g (X2$init, Init, X2$reset0$not, AUdur$not);
  nor #1 X2$g (X2, X2$reset0, AUdur, X2$q);
  nor #1 X2$q$g (X2$q, X2$set1, X2$init, X2);

  // present = X1./AUdoux
  not #1 AUdoux$not$g (AUdoux$not, AUdoux);
  and #1 present$g (present, X1, AUdoux$not);

  // loaded = X2./AUdoux
  and #1 loaded$g (loaded, X2, AUdoux$not);
endmodule
