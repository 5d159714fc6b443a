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
  wire X2$not, X1$hold, Init$not$buf, AUdur$not$buf, X1$or;
  wire T2$clear, T2$clear$not, X2$hold, X2$or;
  wire AUdoux$not;

  // inputs
  not #1 Init$not$g (Init$not, Init);
  not #1 AUdur$not$g (AUdur$not, AUdur);

  // X1 = (s + /X2.X1)./Init./AUdur
  not #1 X2$not$g (X2$not, X2);
  and #1 X1$hold$g (X1$hold, X2$not, X1);
  buf #1 Init$not$buf$g (Init$not$buf, Init$not);
  buf #1 AUdur$not$buf$g (AUdur$not$buf, AUdur$not);
  or #1 X1$or$g (X1$or, s, X1$hold);
  and #1 X1$g (X1, X1$or, Init$not$buf, AUdur$not$buf);

  // X2 = (X1 + /(X2.k).X2 + Init)./AUdur
  and #1 T2$clear$g (T2$clear, X2, k);
  not #1 T2$clear$not$g (T2$clear$not, T2$clear);
  and #1 X2$hold$g (X2$hold, T2$clear$not, X2);
  or #1 X2$or$g (X2$or, X1, X2$hold, Init);
  and #1 X2$g (X2, X2$or, AUdur$not$buf);

  // present = X1./AUdoux
  not #1 AUdoux$not$g (AUdoux$not, AUdoux);
  and #1 present$g (present, X1, AUdoux$not);

  // loaded = X2./AUdoux
  and #1 loaded$g (loaded, X2, AUdoux$not);
endmodule
