// press "Presse à emboutir" (press.grafcet): 471 cells.
// Style clocked, CDX by transitions, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist press.grafcet --style clocked --cdx transition --modes on --to verilog --scan 10ms
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $N         a gate of a condition of the owner
//   $aN        a gate of the arithmetic that works out a value
//   $clear     of a transition: it is cleared; of a step: Init deactivates it
//   edge$N     edge N of the chart, counted from 0
//   $enclose   of the enclosure of the graph
//   $enclosed  the step, as far as the enclosing step is active
//   $evolved   the step after the transitions, before any order
//   $high      always 1
//   $hold      keeps the owner as it is
//   $link      an enclosing step that becomes active activates what it is linked to
//   $linked    the step, or activated by the step that encloses it
//   $low       always 0
//   $memory    the operand of the edge, a scan ago
//   $next      the owner as it is from the next clock on
//   $not       the owner inverted
//   $qN        bit N of the counter
//   $running   1 from the second scan on
//   timer$N    time condition N of the chart, counted from 0
//   \KM%20down = KM down
//   \KM%20up = KM up
//   \tray%20full = tray full
`timescale 1ns/1ps

module press #(parameter [63:0] SCAN_PS = 64'd10000000000) (
  input start,
  input ack,
  input guard,
  input part,
  input tray,
  input top,
  input bottom,
  input Init,
  input AUdur,
  input AUdoux,
  input clk,
  output X0,
  output X1,
  output X2,
  output X10,
  output XE11,
  output X111,
  output X112,
  output X113,
  output XS11,
  output X12,
  output X13,
  output X20,
  output X21,
  output X22,
  output \KM%20down ,
  output \KM%20up ,
  output blow,
  output ready,
  output busy,
  output alarm,
  output \tray%20full 
);
  wire Init$not, AUdur$not, \$low ;
  wire \$high , edges$running, edge$0$memory, edge$0$memory$not, edge$0, edge$1$memory, edge$1$memory$not, edge$1;
  wire T0$1, T0$clear;
  wire guard$not, T1$clear;
  wire T2$clear;
  wire T10$1, T10$clear;
  wire T11$clear;
  wire part$not, pieces$q0$not, T12$1$a1, pieces$q1$not, T12$1$a2, T12$1$a3, T12$1$a4, T12$1$a5, T12$1$a6, T12$1$a6$not, T12$2, T12$clear;
  wire T13$1$a1, T13$1$a2, T13$1$a3, T13$1$a4, T13$1$a5, T13$1$a6, T13$1$a6$not, T13$1$a7, T13$1$a8, T13$1$a9, T13$1$a10, T13$1$a11, T13$1$a12, T13$1$a12$not, T13$2, T13$clear;
  wire T14$clear;
  wire T110$clear;
  wire T111$clear;
  wire T112$clear;
  wire T113$clear;
  wire T20$clear;
  wire T21$clear;
  wire T0$clear$not, X0$hold, X0$evolved, X0$next;
  wire T1$clear$not, X1$hold, X1$evolved, X1$next;
  wire T2$clear$not, X2$hold, X2$evolved, X2$next;
  wire T10$clear$not, X10$hold, X10$evolved, X10$next;
  wire T110$clear$not, XE11$hold, XE11$evolved, XE11$next;
  wire T111$clear$not, X111$hold, X111$evolved, X111$next;
  wire T112$clear$not, X112$hold, X112$evolved, X112$next;
  wire T113$clear$not, X113$hold, X113$evolved, X113$next;
  wire T11$clear$not, XS11$hold, XS11$evolved, XS11$next;
  wire T12$clear$not, T13$clear$not, X12$hold, X12$evolved, X12$next;
  wire T14$clear$not, X13$hold, X13$evolved, X13$next;
  wire T20$clear$not, X20$hold, X20$next;
  wire T21$clear$not, X21$hold, X21$evolved, X21$next;
  wire X22$hold, X22$evolved, X22$next;
  wire X1$not, XGA$enclose$link, X10$enclosed, XE11$enclosed, X111$enclosed, X112$enclosed, X113$enclosed, XS11$enclosed, X12$enclosed, X13$enclosed, X10$linked;
  wire X12$not, XGB$enclose$link, X20$enclosed, X21$enclosed, X22$enclosed, X20$linked;
  wire pieces$next$a1, pieces$next$a2, pieces$next$a3, pieces$next$a4, pieces$next$a5, pieces$next$a1$not, pieces$next$a6, pieces$next$a7, pieces$next$a8, pieces$next$a3$not, pieces$next$a9, pieces$next$a10, pieces$next$a11, pieces$next$a4$not, pieces$next$a12, pieces$next$a13, pieces$next$a14, pieces$next$a14$not, pieces$next$a15, pieces$next$a6$not, pieces$next$a16, pieces$next$a17, pieces$next$a18, pieces$next$a19, pieces$next$a20, pieces$next$a12$not, pieces$next$a21, pieces$next$a22, pieces$next$a23, pieces$next$a24, pieces$next$a25, pieces$next$a26, pieces$next$a27, pieces$next$a28, pieces$next$a29, pieces$next$a30, pieces$next$a31, pieces$next$a32, pieces$next$a33, pieces$next$a34, pieces$next$a35, pieces$next$a36, pieces$next$a37, pieces$next$a38, pieces$next$a39, pieces$next$a40, pieces$next$a41, pieces$next$a42, pieces$next$a43, pieces$next$a44, pieces$next$a45, pieces$next$a46, pieces$next$a47, pieces$next$a48, pieces$next$a49, pieces$next$a50, pieces$next$a51, pieces$next$a52, pieces$next$a53, pieces$next$a54, pieces$next$a55, pieces$next$a56, pieces$next$a57, pieces$next$a58, pieces$next$a59, pieces$next$a60, pieces$next$a61, pieces$next$a62, pieces$next$a63, pieces$next$a64, pieces$next$a65, pieces$next$a66, pieces$next$a67, pieces$next$a68, pieces$next$a69, pieces$next$a70, pieces$next$a71, pieces$next$a72, pieces$next$a73, pieces$next$a74, pieces$next$a75, pieces$next$a76, pieces$next$a77, pieces$next$a78, pieces$next$a79, pieces$next$a80, pieces$next$a81, pieces$next$a82, pieces$next$a83, pieces$next$a84, pieces$next$a85, pieces$next$a86, pieces$next$a87, pieces$next$a88, pieces$next$a89, pieces$next$a90, pieces$next$a91, pieces$next$a92, pieces$next$a93, pieces$next$a94, pieces$next$a95, pieces$next$a96, pieces$next$a97, pieces$next$a98, pieces$next$a99, pieces$next$a100, pieces$next$a101, pieces$next$a102, pieces$next$a103, pieces$next$a104, pieces$next$a105, pieces$next$a106, pieces$next$a107, pieces$next$a108, pieces$next$a109, pieces$next$a110, pieces$next$a111, pieces$next$a112, pieces$next$a113, pieces$next$a114, pieces$next$a115, pieces$next$a116, pieces$next$a117, pieces$next$a118, pieces$next$a119, pieces$next$a120, pieces$next$a121, pieces$next$a122, pieces$next$a123, pieces$next$a124, pieces$next$a125, pieces$next$a126, pieces$next$a127, pieces$next$a128, pieces$next$a129, pieces$next$a130, pieces$next$a131, pieces$next$a132, pieces$next$a133, pieces$next$a134, pieces$next$a135, pieces$next$a136, pieces$next$a137, pieces$next$a138, pieces$next$a139, pieces$next$a140, pieces$next$a141, pieces$next$a142, pieces$next$a143, pieces$next$a144, pieces$next$a145, pieces$next$a146, pieces$next$a147, pieces$next$a148, pieces$next$a149, pieces$next$a150, pieces$next$a151, pieces$next$a152, pieces$next$a153, pieces$next$a154, pieces$next$a155, pieces$next$a156, pieces$next$a157, pieces$next$a158, pieces$next$a159, pieces$next$a160, pieces$next$a161, pieces$next$a162, pieces$next$a163, pieces$next$a164, pieces$next$a165, pieces$next$a166, pieces$next$a167, pieces$next$a168, pieces$next$a169, pieces$next$a170, pieces$next$a171, pieces$next$a172, pieces$next$a173, pieces$next$a174, pieces$next$a175, pieces$next$a176, pieces$next$a177, pieces$next$a178, pieces$next$a179, pieces$next$a180, pieces$next$a181, pieces$next$a182, pieces$next$a183, pieces$next$a184, pieces$next$a185, pieces$next$a186, pieces$next$a187, pieces$next$a188, pieces$next$a189, pieces$next$a190, pieces$next$a191, pieces$next$a192, pieces$next$a193, pieces$next$a194, pieces$next$a195, pieces$next$a196, pieces$next$a197, pieces$next$a198, pieces$next$a199, pieces$next$a200, pieces$next$a201, pieces$next$a202, pieces$next$a203, pieces$next$a204, pieces$next$a205, pieces$next$a206, pieces$next$a207, pieces$next$a208, pieces$next$a209, pieces$next$a210, pieces$next$a211, pieces$next$a212, pieces$next$a213, pieces$next$a214, pieces$next$a215, pieces$next$a216, pieces$next$a217, pieces$next$a218, pieces$next$a219, pieces$next$a220, pieces$next$a221, pieces$next$a222, pieces$next$a223, pieces$next$a224, pieces$next$a225, pieces$next$a226, pieces$next$a227, pieces$next$a228, pieces$next$a229, pieces$next$a230, pieces$next$a231, pieces$next$a232, pieces$next$a233, pieces$next$a234, pieces$next$a235, pieces$next$a236, pieces$next$a237, pieces$next$a238, pieces$next$a239, pieces$next$a240, pieces$next$a241, pieces$next$a242, pieces$next$a243, pieces$next$a244, pieces$next$a245, pieces$next$a246, pieces$next$a247, pieces$next$a248, pieces$next$a249, pieces$next$a250, pieces$next$a251, pieces$next$a252, pieces$next$a253, pieces$next$a254, pieces$next$a255, pieces$next$a256, pieces$next$a257, pieces$next$a258, pieces$next$a259, pieces$next$a260, pieces$next$a261, pieces$next$a262, pieces$next$a263, pieces$next$a264, pieces$next$a265, pieces$next$a266, pieces$next$a267, pieces$next$a268, pieces$next$a269, pieces$next$a270, pieces$next$a271, pieces$next$a272, pieces$next$a273, pieces$next$a274, pieces$next$a275, pieces$next$a276, pieces$next$a276$not, pieces$next$a277, pieces$next$a277$not, pieces$next$a278, pieces$next$a279, pieces$next$a280, pieces$next$a281, pieces$next$a282, pieces$next$a283, pieces$next$a284, pieces$next$a285, pieces$next$a286, pieces$next$a287, pieces$next$a288, pieces$next$a289, pieces$next$a290, pieces$next$a291, pieces$next$a292, pieces$next$a293, pieces$next$a294, pieces$next$a295, pieces$next$a296, pieces$next$a297, pieces$next$a298, pieces$next$a299, pieces$next$a300, pieces$q0, pieces$q1, pieces$q2;
  wire timer$0;
  wire timer$1;
  wire timer$2;
  wire AUdoux$not, \KM%20down$1 ;
  wire \KM%20up$1 ;
  wire blow$1, blow$2;
  wire ready$1;
  wire busy$1, busy$2;
  wire alarm$1;
  wire \tray%20full$1 ;

  // inputs
  not Init$not$g (Init$not, Init);
  not AUdur$not$g (AUdur$not, AUdur);
  assign \$low  = 1'b0;

  // edges
  assign \$high  = 1'b1;
  grafwire_dff #(.INIT(1'b0)) edges$running$g (.d(\$high ), .c(clk), .q(edges$running));
  grafwire_dff #(.INIT(1'b0)) edge$0$memory$g (.d(start), .c(clk), .q(edge$0$memory));
  not edge$0$memory$not$g (edge$0$memory$not, edge$0$memory);
  and edge$0$g (edge$0, start, edge$0$memory$not, edges$running);
  grafwire_dff #(.INIT(1'b0)) edge$1$memory$g (.d(tray), .c(clk), .q(edge$1$memory));
  not edge$1$memory$not$g (edge$1$memory$not, edge$1$memory);
  and edge$1$g (edge$1, tray, edge$1$memory$not, edges$running);

  // T0
  and T0$1$g (T0$1, guard, edge$0);
  and T0$clear$g (T0$clear, X0, T0$1, Init$not);

  // T1
  not guard$not$g (guard$not, guard);
  and T1$clear$g (T1$clear, X1, guard$not, Init$not);

  // T2
  and T2$clear$g (T2$clear, X2, ack, Init$not);

  // T10
  and T10$1$g (T10$1, edge$0, part);
  and T10$clear$g (T10$clear, X10, T10$1, Init$not);

  // T11
  and T11$clear$g (T11$clear, XS11, Init$not);

  // T12
  not part$not$g (part$not, part);
  not pieces$q0$not$g (pieces$q0$not, pieces$q0);
  or T12$1$a1$g (T12$1$a1, pieces$q0, pieces$q0$not);
  not pieces$q1$not$g (pieces$q1$not, pieces$q1);
  xor T12$1$a2$g (T12$1$a2, pieces$q1$not, T12$1$a1);
  and T12$1$a3$g (T12$1$a3, pieces$q1$not, T12$1$a1);
  or T12$1$a4$g (T12$1$a4, pieces$q1, T12$1$a3);
  xor T12$1$a5$g (T12$1$a5, pieces$q2, T12$1$a4);
  and T12$1$a6$g (T12$1$a6, pieces$q2, T12$1$a4);
  not T12$1$a6$not$g (T12$1$a6$not, T12$1$a6);
  and T12$2$g (T12$2, part$not, X22, T12$1$a6$not);
  and T12$clear$g (T12$clear, X12, T12$2, Init$not);

  // T13
  or T13$1$a1$g (T13$1$a1, pieces$q0, pieces$q0$not);
  xor T13$1$a2$g (T13$1$a2, pieces$q1$not, T13$1$a1);
  and T13$1$a3$g (T13$1$a3, pieces$q1$not, T13$1$a1);
  or T13$1$a4$g (T13$1$a4, pieces$q1, T13$1$a3);
  xor T13$1$a5$g (T13$1$a5, pieces$q2, T13$1$a4);
  and T13$1$a6$g (T13$1$a6, pieces$q2, T13$1$a4);
  not T13$1$a6$not$g (T13$1$a6$not, T13$1$a6);
  or T13$1$a7$g (T13$1$a7, pieces$q0, T13$1$a2);
  or T13$1$a8$g (T13$1$a8, T13$1$a7, T13$1$a5);
  or T13$1$a9$g (T13$1$a9, T13$1$a8, T13$1$a6$not);
  or T13$1$a10$g (T13$1$a10, T13$1$a9, T13$1$a6$not);
  or T13$1$a11$g (T13$1$a11, T13$1$a10, T13$1$a6$not);
  or T13$1$a12$g (T13$1$a12, T13$1$a11, T13$1$a6$not);
  not T13$1$a12$not$g (T13$1$a12$not, T13$1$a12);
  and T13$2$g (T13$2, part$not, X22, T13$1$a12$not);
  and T13$clear$g (T13$clear, X12, T13$2, Init$not);

  // T14
  and T14$clear$g (T14$clear, X13, edge$1, Init$not);

  // T110
  and T110$clear$g (T110$clear, XE11, top, Init$not);

  // T111
  and T111$clear$g (T111$clear, X111, bottom, Init$not);

  // T112
  and T112$clear$g (T112$clear, X112, timer$0, Init$not);

  // T113
  and T113$clear$g (T113$clear, X113, top, Init$not);

  // T20
  and T20$clear$g (T20$clear, X20, timer$1, Init$not);

  // T21
  and T21$clear$g (T21$clear, X21, timer$2, Init$not);

  // X0 = (X2.ack + /(X0.guard.↑start).X0 + Init)./AUdur
  not T0$clear$not$g (T0$clear$not, T0$clear);
  and X0$hold$g (X0$hold, X0, T0$clear$not);
  or X0$evolved$g (X0$evolved, T2$clear, X0$hold, Init);
  and X0$next$g (X0$next, X0$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b1)) X0$g (.d(X0$next), .c(clk), .q(X0));

  // X1 = (X0.guard.↑start + /(X1./guard).X1)./Init./AUdur
  not T1$clear$not$g (T1$clear$not, T1$clear);
  and X1$hold$g (X1$hold, X1, T1$clear$not, Init$not);
  or X1$evolved$g (X1$evolved, T0$clear, X1$hold);
  and X1$next$g (X1$next, X1$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X1$g (.d(X1$next), .c(clk), .q(X1));

  // X2 = (X1./guard + /(X2.ack).X2)./Init./AUdur
  not T2$clear$not$g (T2$clear$not, T2$clear);
  and X2$hold$g (X2$hold, X2, T2$clear$not, Init$not);
  or X2$evolved$g (X2$evolved, T1$clear, X2$hold);
  and X2$next$g (X2$next, X2$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X2$g (.d(X2$next), .c(clk), .q(X2));

  // X10 = ((X12./part.X22.[pieces < 4] + X13.↑tray + /(X10.↑start.part).X10)./Init.X1 + ↑X1./Init)./AUdur
  not T10$clear$not$g (T10$clear$not, T10$clear);
  and X10$hold$g (X10$hold, X10, T10$clear$not, Init$not);
  or X10$evolved$g (X10$evolved, T12$clear, T14$clear, X10$hold);
  and X10$next$g (X10$next, X10$linked, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X10$g (.d(X10$next), .c(clk), .q(X10));

  // XE11 = (X10.↑start.part + /(XE11.top).XE11)./Init.X1./AUdur
  not T110$clear$not$g (T110$clear$not, T110$clear);
  and XE11$hold$g (XE11$hold, XE11, T110$clear$not, Init$not);
  or XE11$evolved$g (XE11$evolved, T10$clear, XE11$hold);
  and XE11$next$g (XE11$next, XE11$enclosed, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) XE11$g (.d(XE11$next), .c(clk), .q(XE11));

  // X111 = (XE11.top + /(X111.bottom).X111)./Init.X1./AUdur
  not T111$clear$not$g (T111$clear$not, T111$clear);
  and X111$hold$g (X111$hold, X111, T111$clear$not, Init$not);
  or X111$evolved$g (X111$evolved, T110$clear, X111$hold);
  and X111$next$g (X111$next, X111$enclosed, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X111$g (.d(X111$next), .c(clk), .q(X111));

  // X112 = (X111.bottom + /(X112 . 500ms/X112).X112)./Init.X1./AUdur
  not T112$clear$not$g (T112$clear$not, T112$clear);
  and X112$hold$g (X112$hold, X112, T112$clear$not, Init$not);
  or X112$evolved$g (X112$evolved, T111$clear, X112$hold);
  and X112$next$g (X112$next, X112$enclosed, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X112$g (.d(X112$next), .c(clk), .q(X112));

  // X113 = (X112 . 500ms/X112 + /(X113.top).X113)./Init.X1./AUdur
  not T113$clear$not$g (T113$clear$not, T113$clear);
  and X113$hold$g (X113$hold, X113, T113$clear$not, Init$not);
  or X113$evolved$g (X113$evolved, T112$clear, X113$hold);
  and X113$next$g (X113$next, X113$enclosed, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X113$g (.d(X113$next), .c(clk), .q(X113));

  // XS11 = (X113.top + /XS11.XS11)./Init.X1./AUdur
  not T11$clear$not$g (T11$clear$not, T11$clear);
  and XS11$hold$g (XS11$hold, XS11, T11$clear$not, Init$not);
  or XS11$evolved$g (XS11$evolved, T113$clear, XS11$hold);
  and XS11$next$g (XS11$next, XS11$enclosed, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) XS11$g (.d(XS11$next), .c(clk), .q(XS11));

  // X12 = (XS11 + /(X12./part.X22.[pieces < 4] + X12./part.X22.[pieces = 4]).X12)./Init.X1./AUdur
  not T12$clear$not$g (T12$clear$not, T12$clear);
  not T13$clear$not$g (T13$clear$not, T13$clear);
  and X12$hold$g (X12$hold, X12, T12$clear$not, T13$clear$not, Init$not);
  or X12$evolved$g (X12$evolved, T11$clear, X12$hold);
  and X12$next$g (X12$next, X12$enclosed, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X12$g (.d(X12$next), .c(clk), .q(X12));

  // X13 = (X12./part.X22.[pieces = 4] + /(X13.↑tray).X13)./Init.X1./AUdur
  not T14$clear$not$g (T14$clear$not, T14$clear);
  and X13$hold$g (X13$hold, X13, T14$clear$not, Init$not);
  or X13$evolved$g (X13$evolved, T13$clear, X13$hold);
  and X13$next$g (X13$next, X13$enclosed, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X13$g (.d(X13$next), .c(clk), .q(X13));

  // X20 = (/(X20 . 200ms/X20).X20./Init.X12 + ↑X12./Init)./AUdur
  not T20$clear$not$g (T20$clear$not, T20$clear);
  and X20$hold$g (X20$hold, X20, T20$clear$not, Init$not);
  and X20$next$g (X20$next, X20$linked, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X20$g (.d(X20$next), .c(clk), .q(X20));

  // X21 = (X20 . 200ms/X20 + /(X21 . 300ms/X21).X21)./Init.X12./AUdur
  not T21$clear$not$g (T21$clear$not, T21$clear);
  and X21$hold$g (X21$hold, X21, T21$clear$not, Init$not);
  or X21$evolved$g (X21$evolved, T20$clear, X21$hold);
  and X21$next$g (X21$next, X21$enclosed, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X21$g (.d(X21$next), .c(clk), .q(X21));

  // X22 = (X21 . 300ms/X21 + X22)./Init.X12./AUdur
  and X22$hold$g (X22$hold, X22, Init$not);
  or X22$evolved$g (X22$evolved, T21$clear, X22$hold);
  and X22$next$g (X22$next, X22$enclosed, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X22$g (.d(X22$next), .c(clk), .q(X22));

  // XGA$enclose
  not X1$not$g (X1$not, X1);
  and XGA$enclose$link$g (XGA$enclose$link, X1$evolved, X1$not, Init$not);
  and X10$enclosed$g (X10$enclosed, X10$evolved, X1$evolved);
  and XE11$enclosed$g (XE11$enclosed, XE11$evolved, X1$evolved);
  and X111$enclosed$g (X111$enclosed, X111$evolved, X1$evolved);
  and X112$enclosed$g (X112$enclosed, X112$evolved, X1$evolved);
  and X113$enclosed$g (X113$enclosed, X113$evolved, X1$evolved);
  and XS11$enclosed$g (XS11$enclosed, XS11$evolved, X1$evolved);
  and X12$enclosed$g (X12$enclosed, X12$evolved, X1$evolved);
  and X13$enclosed$g (X13$enclosed, X13$evolved, X1$evolved);
  or X10$linked$g (X10$linked, X10$enclosed, XGA$enclose$link);

  // XGB$enclose
  not X12$not$g (X12$not, X12);
  and XGB$enclose$link$g (XGB$enclose$link, X12$enclosed, X12$not, Init$not);
  and X20$enclosed$g (X20$enclosed, X20$hold, X12$enclosed);
  and X21$enclosed$g (X21$enclosed, X21$evolved, X12$enclosed);
  and X22$enclosed$g (X22$enclosed, X22$evolved, X12$enclosed);
  or X20$linked$g (X20$linked, X20$enclosed, XGB$enclose$link);

  // pieces
  xor pieces$next$a1$g (pieces$next$a1, pieces$q1, pieces$q0);
  and pieces$next$a2$g (pieces$next$a2, pieces$q1, pieces$q0);
  xor pieces$next$a3$g (pieces$next$a3, pieces$q2, pieces$next$a2);
  and pieces$next$a4$g (pieces$next$a4, pieces$q2, pieces$next$a2);
  or pieces$next$a5$g (pieces$next$a5, pieces$q0$not, pieces$q0);
  not pieces$next$a1$not$g (pieces$next$a1$not, pieces$next$a1);
  xor pieces$next$a6$g (pieces$next$a6, pieces$next$a1$not, pieces$next$a5);
  and pieces$next$a7$g (pieces$next$a7, pieces$next$a1$not, pieces$next$a5);
  or pieces$next$a8$g (pieces$next$a8, pieces$next$a1, pieces$next$a7);
  not pieces$next$a3$not$g (pieces$next$a3$not, pieces$next$a3);
  xor pieces$next$a9$g (pieces$next$a9, pieces$next$a3$not, pieces$next$a8);
  and pieces$next$a10$g (pieces$next$a10, pieces$next$a3$not, pieces$next$a8);
  or pieces$next$a11$g (pieces$next$a11, pieces$next$a3, pieces$next$a10);
  not pieces$next$a4$not$g (pieces$next$a4$not, pieces$next$a4);
  xor pieces$next$a12$g (pieces$next$a12, pieces$next$a4$not, pieces$next$a11);
  and pieces$next$a13$g (pieces$next$a13, pieces$next$a4$not, pieces$next$a11);
  or pieces$next$a14$g (pieces$next$a14, pieces$next$a4, pieces$next$a13);
  not pieces$next$a14$not$g (pieces$next$a14$not, pieces$next$a14);
  or pieces$next$a15$g (pieces$next$a15, pieces$q0$not, pieces$q0);
  not pieces$next$a6$not$g (pieces$next$a6$not, pieces$next$a6);
  xor pieces$next$a16$g (pieces$next$a16, pieces$next$a6$not, pieces$next$a15);
  and pieces$next$a17$g (pieces$next$a17, pieces$next$a6$not, pieces$next$a15);
  or pieces$next$a18$g (pieces$next$a18, pieces$next$a6, pieces$next$a17);
  xor pieces$next$a19$g (pieces$next$a19, pieces$next$a9, pieces$next$a18);
  and pieces$next$a20$g (pieces$next$a20, pieces$next$a9, pieces$next$a18);
  not pieces$next$a12$not$g (pieces$next$a12$not, pieces$next$a12);
  xor pieces$next$a21$g (pieces$next$a21, pieces$next$a12$not, pieces$next$a20);
  and pieces$next$a22$g (pieces$next$a22, pieces$next$a12$not, pieces$next$a20);
  or pieces$next$a23$g (pieces$next$a23, pieces$next$a12, pieces$next$a22);
  xor pieces$next$a24$g (pieces$next$a24, pieces$next$a14, pieces$next$a23);
  and pieces$next$a25$g (pieces$next$a25, pieces$next$a14, pieces$next$a23);
  or pieces$next$a26$g (pieces$next$a26, pieces$next$a14$not, pieces$next$a25);
  xor pieces$next$a27$g (pieces$next$a27, pieces$next$a14, pieces$next$a26);
  and pieces$next$a28$g (pieces$next$a28, pieces$next$a14, pieces$next$a26);
  or pieces$next$a29$g (pieces$next$a29, pieces$next$a14$not, pieces$next$a28);
  xor pieces$next$a30$g (pieces$next$a30, pieces$next$a14, pieces$next$a29);
  and pieces$next$a31$g (pieces$next$a31, pieces$next$a14, pieces$next$a29);
  or pieces$next$a32$g (pieces$next$a32, pieces$next$a14$not, pieces$next$a31);
  xor pieces$next$a33$g (pieces$next$a33, pieces$next$a14, pieces$next$a32);
  and pieces$next$a34$g (pieces$next$a34, pieces$next$a14, pieces$next$a32);
  or pieces$next$a35$g (pieces$next$a35, pieces$next$a14$not, pieces$next$a34);
  xor pieces$next$a36$g (pieces$next$a36, pieces$next$a14, pieces$next$a35);
  and pieces$next$a37$g (pieces$next$a37, pieces$next$a14, pieces$next$a35);
  or pieces$next$a38$g (pieces$next$a38, pieces$next$a14$not, pieces$next$a37);
  xor pieces$next$a39$g (pieces$next$a39, pieces$next$a14, pieces$next$a38);
  and pieces$next$a40$g (pieces$next$a40, pieces$next$a14, pieces$next$a38);
  or pieces$next$a41$g (pieces$next$a41, pieces$next$a14$not, pieces$next$a40);
  xor pieces$next$a42$g (pieces$next$a42, pieces$next$a14, pieces$next$a41);
  and pieces$next$a43$g (pieces$next$a43, pieces$next$a14, pieces$next$a41);
  or pieces$next$a44$g (pieces$next$a44, pieces$next$a14$not, pieces$next$a43);
  xor pieces$next$a45$g (pieces$next$a45, pieces$next$a14, pieces$next$a44);
  and pieces$next$a46$g (pieces$next$a46, pieces$next$a14, pieces$next$a44);
  or pieces$next$a47$g (pieces$next$a47, pieces$next$a14$not, pieces$next$a46);
  xor pieces$next$a48$g (pieces$next$a48, pieces$next$a14, pieces$next$a47);
  and pieces$next$a49$g (pieces$next$a49, pieces$next$a14, pieces$next$a47);
  or pieces$next$a50$g (pieces$next$a50, pieces$next$a14$not, pieces$next$a49);
  xor pieces$next$a51$g (pieces$next$a51, pieces$next$a14, pieces$next$a50);
  and pieces$next$a52$g (pieces$next$a52, pieces$next$a14, pieces$next$a50);
  or pieces$next$a53$g (pieces$next$a53, pieces$next$a14$not, pieces$next$a52);
  xor pieces$next$a54$g (pieces$next$a54, pieces$next$a14, pieces$next$a53);
  and pieces$next$a55$g (pieces$next$a55, pieces$next$a14, pieces$next$a53);
  or pieces$next$a56$g (pieces$next$a56, pieces$next$a14$not, pieces$next$a55);
  xor pieces$next$a57$g (pieces$next$a57, pieces$next$a14, pieces$next$a56);
  and pieces$next$a58$g (pieces$next$a58, pieces$next$a14, pieces$next$a56);
  or pieces$next$a59$g (pieces$next$a59, pieces$next$a14$not, pieces$next$a58);
  xor pieces$next$a60$g (pieces$next$a60, pieces$next$a14, pieces$next$a59);
  and pieces$next$a61$g (pieces$next$a61, pieces$next$a14, pieces$next$a59);
  or pieces$next$a62$g (pieces$next$a62, pieces$next$a14$not, pieces$next$a61);
  xor pieces$next$a63$g (pieces$next$a63, pieces$next$a14, pieces$next$a62);
  and pieces$next$a64$g (pieces$next$a64, pieces$next$a14, pieces$next$a62);
  or pieces$next$a65$g (pieces$next$a65, pieces$next$a14$not, pieces$next$a64);
  xor pieces$next$a66$g (pieces$next$a66, pieces$next$a14, pieces$next$a65);
  and pieces$next$a67$g (pieces$next$a67, pieces$next$a14, pieces$next$a65);
  or pieces$next$a68$g (pieces$next$a68, pieces$next$a14$not, pieces$next$a67);
  xor pieces$next$a69$g (pieces$next$a69, pieces$next$a14, pieces$next$a68);
  and pieces$next$a70$g (pieces$next$a70, pieces$next$a14, pieces$next$a68);
  or pieces$next$a71$g (pieces$next$a71, pieces$next$a14$not, pieces$next$a70);
  xor pieces$next$a72$g (pieces$next$a72, pieces$next$a14, pieces$next$a71);
  and pieces$next$a73$g (pieces$next$a73, pieces$next$a14, pieces$next$a71);
  or pieces$next$a74$g (pieces$next$a74, pieces$next$a14$not, pieces$next$a73);
  xor pieces$next$a75$g (pieces$next$a75, pieces$next$a14, pieces$next$a74);
  and pieces$next$a76$g (pieces$next$a76, pieces$next$a14, pieces$next$a74);
  or pieces$next$a77$g (pieces$next$a77, pieces$next$a14$not, pieces$next$a76);
  xor pieces$next$a78$g (pieces$next$a78, pieces$next$a14, pieces$next$a77);
  and pieces$next$a79$g (pieces$next$a79, pieces$next$a14, pieces$next$a77);
  or pieces$next$a80$g (pieces$next$a80, pieces$next$a14$not, pieces$next$a79);
  xor pieces$next$a81$g (pieces$next$a81, pieces$next$a14, pieces$next$a80);
  and pieces$next$a82$g (pieces$next$a82, pieces$next$a14, pieces$next$a80);
  or pieces$next$a83$g (pieces$next$a83, pieces$next$a14$not, pieces$next$a82);
  xor pieces$next$a84$g (pieces$next$a84, pieces$next$a14, pieces$next$a83);
  and pieces$next$a85$g (pieces$next$a85, pieces$next$a14, pieces$next$a83);
  or pieces$next$a86$g (pieces$next$a86, pieces$next$a14$not, pieces$next$a85);
  xor pieces$next$a87$g (pieces$next$a87, pieces$next$a14, pieces$next$a86);
  and pieces$next$a88$g (pieces$next$a88, pieces$next$a14, pieces$next$a86);
  or pieces$next$a89$g (pieces$next$a89, pieces$next$a14$not, pieces$next$a88);
  xor pieces$next$a90$g (pieces$next$a90, pieces$next$a14, pieces$next$a89);
  and pieces$next$a91$g (pieces$next$a91, pieces$next$a14, pieces$next$a89);
  or pieces$next$a92$g (pieces$next$a92, pieces$next$a14$not, pieces$next$a91);
  xor pieces$next$a93$g (pieces$next$a93, pieces$next$a14, pieces$next$a92);
  and pieces$next$a94$g (pieces$next$a94, pieces$next$a14, pieces$next$a92);
  or pieces$next$a95$g (pieces$next$a95, pieces$next$a14$not, pieces$next$a94);
  xor pieces$next$a96$g (pieces$next$a96, pieces$next$a14, pieces$next$a95);
  and pieces$next$a97$g (pieces$next$a97, pieces$next$a14, pieces$next$a95);
  or pieces$next$a98$g (pieces$next$a98, pieces$next$a14$not, pieces$next$a97);
  xor pieces$next$a99$g (pieces$next$a99, pieces$next$a14, pieces$next$a98);
  and pieces$next$a100$g (pieces$next$a100, pieces$next$a14, pieces$next$a98);
  or pieces$next$a101$g (pieces$next$a101, pieces$next$a14$not, pieces$next$a100);
  xor pieces$next$a102$g (pieces$next$a102, pieces$next$a14, pieces$next$a101);
  and pieces$next$a103$g (pieces$next$a103, pieces$next$a14, pieces$next$a101);
  or pieces$next$a104$g (pieces$next$a104, pieces$next$a14$not, pieces$next$a103);
  xor pieces$next$a105$g (pieces$next$a105, pieces$next$a14, pieces$next$a104);
  and pieces$next$a106$g (pieces$next$a106, pieces$next$a14, pieces$next$a104);
  or pieces$next$a107$g (pieces$next$a107, pieces$next$a14$not, pieces$next$a106);
  xor pieces$next$a108$g (pieces$next$a108, pieces$next$a14, pieces$next$a107);
  and pieces$next$a109$g (pieces$next$a109, pieces$next$a14, pieces$next$a107);
  or pieces$next$a110$g (pieces$next$a110, pieces$next$a14$not, pieces$next$a109);
  xor pieces$next$a111$g (pieces$next$a111, pieces$next$a14, pieces$next$a110);
  and pieces$next$a112$g (pieces$next$a112, pieces$next$a14, pieces$next$a110);
  or pieces$next$a113$g (pieces$next$a113, pieces$next$a14$not, pieces$next$a112);
  xor pieces$next$a114$g (pieces$next$a114, pieces$next$a14, pieces$next$a113);
  and pieces$next$a115$g (pieces$next$a115, pieces$next$a14, pieces$next$a113);
  or pieces$next$a116$g (pieces$next$a116, pieces$next$a14$not, pieces$next$a115);
  xor pieces$next$a117$g (pieces$next$a117, pieces$next$a14, pieces$next$a116);
  and pieces$next$a118$g (pieces$next$a118, pieces$next$a14, pieces$next$a116);
  or pieces$next$a119$g (pieces$next$a119, pieces$next$a14$not, pieces$next$a118);
  xor pieces$next$a120$g (pieces$next$a120, pieces$next$a14, pieces$next$a119);
  and pieces$next$a121$g (pieces$next$a121, pieces$next$a14, pieces$next$a119);
  or pieces$next$a122$g (pieces$next$a122, pieces$next$a14$not, pieces$next$a121);
  xor pieces$next$a123$g (pieces$next$a123, pieces$next$a14, pieces$next$a122);
  and pieces$next$a124$g (pieces$next$a124, pieces$next$a14, pieces$next$a122);
  or pieces$next$a125$g (pieces$next$a125, pieces$next$a14$not, pieces$next$a124);
  xor pieces$next$a126$g (pieces$next$a126, pieces$next$a14, pieces$next$a125);
  and pieces$next$a127$g (pieces$next$a127, pieces$next$a14, pieces$next$a125);
  or pieces$next$a128$g (pieces$next$a128, pieces$next$a14$not, pieces$next$a127);
  xor pieces$next$a129$g (pieces$next$a129, pieces$next$a14, pieces$next$a128);
  and pieces$next$a130$g (pieces$next$a130, pieces$next$a14, pieces$next$a128);
  or pieces$next$a131$g (pieces$next$a131, pieces$next$a14$not, pieces$next$a130);
  xor pieces$next$a132$g (pieces$next$a132, pieces$next$a14, pieces$next$a131);
  and pieces$next$a133$g (pieces$next$a133, pieces$next$a14, pieces$next$a131);
  or pieces$next$a134$g (pieces$next$a134, pieces$next$a14$not, pieces$next$a133);
  xor pieces$next$a135$g (pieces$next$a135, pieces$next$a14, pieces$next$a134);
  and pieces$next$a136$g (pieces$next$a136, pieces$next$a14, pieces$next$a134);
  or pieces$next$a137$g (pieces$next$a137, pieces$next$a14$not, pieces$next$a136);
  xor pieces$next$a138$g (pieces$next$a138, pieces$next$a14, pieces$next$a137);
  and pieces$next$a139$g (pieces$next$a139, pieces$next$a14, pieces$next$a137);
  or pieces$next$a140$g (pieces$next$a140, pieces$next$a14$not, pieces$next$a139);
  xor pieces$next$a141$g (pieces$next$a141, pieces$next$a14, pieces$next$a140);
  and pieces$next$a142$g (pieces$next$a142, pieces$next$a14, pieces$next$a140);
  or pieces$next$a143$g (pieces$next$a143, pieces$next$a14$not, pieces$next$a142);
  xor pieces$next$a144$g (pieces$next$a144, pieces$next$a14, pieces$next$a143);
  and pieces$next$a145$g (pieces$next$a145, pieces$next$a14, pieces$next$a143);
  or pieces$next$a146$g (pieces$next$a146, pieces$next$a14$not, pieces$next$a145);
  xor pieces$next$a147$g (pieces$next$a147, pieces$next$a14, pieces$next$a146);
  and pieces$next$a148$g (pieces$next$a148, pieces$next$a14, pieces$next$a146);
  or pieces$next$a149$g (pieces$next$a149, pieces$next$a14$not, pieces$next$a148);
  xor pieces$next$a150$g (pieces$next$a150, pieces$next$a14, pieces$next$a149);
  and pieces$next$a151$g (pieces$next$a151, pieces$next$a14, pieces$next$a149);
  or pieces$next$a152$g (pieces$next$a152, pieces$next$a14$not, pieces$next$a151);
  xor pieces$next$a153$g (pieces$next$a153, pieces$next$a14, pieces$next$a152);
  and pieces$next$a154$g (pieces$next$a154, pieces$next$a14, pieces$next$a152);
  or pieces$next$a155$g (pieces$next$a155, pieces$next$a14$not, pieces$next$a154);
  xor pieces$next$a156$g (pieces$next$a156, pieces$next$a14, pieces$next$a155);
  and pieces$next$a157$g (pieces$next$a157, pieces$next$a14, pieces$next$a155);
  or pieces$next$a158$g (pieces$next$a158, pieces$next$a14$not, pieces$next$a157);
  xor pieces$next$a159$g (pieces$next$a159, pieces$next$a14, pieces$next$a158);
  and pieces$next$a160$g (pieces$next$a160, pieces$next$a14, pieces$next$a158);
  or pieces$next$a161$g (pieces$next$a161, pieces$next$a14$not, pieces$next$a160);
  xor pieces$next$a162$g (pieces$next$a162, pieces$next$a14, pieces$next$a161);
  and pieces$next$a163$g (pieces$next$a163, pieces$next$a14, pieces$next$a161);
  or pieces$next$a164$g (pieces$next$a164, pieces$next$a14$not, pieces$next$a163);
  xor pieces$next$a165$g (pieces$next$a165, pieces$next$a14, pieces$next$a164);
  and pieces$next$a166$g (pieces$next$a166, pieces$next$a14, pieces$next$a164);
  or pieces$next$a167$g (pieces$next$a167, pieces$next$a14$not, pieces$next$a166);
  xor pieces$next$a168$g (pieces$next$a168, pieces$next$a14, pieces$next$a167);
  and pieces$next$a169$g (pieces$next$a169, pieces$next$a14, pieces$next$a167);
  or pieces$next$a170$g (pieces$next$a170, pieces$next$a14$not, pieces$next$a169);
  xor pieces$next$a171$g (pieces$next$a171, pieces$next$a14, pieces$next$a170);
  and pieces$next$a172$g (pieces$next$a172, pieces$next$a14, pieces$next$a170);
  or pieces$next$a173$g (pieces$next$a173, pieces$next$a14$not, pieces$next$a172);
  xor pieces$next$a174$g (pieces$next$a174, pieces$next$a14, pieces$next$a173);
  and pieces$next$a175$g (pieces$next$a175, pieces$next$a14, pieces$next$a173);
  or pieces$next$a176$g (pieces$next$a176, pieces$next$a14$not, pieces$next$a175);
  xor pieces$next$a177$g (pieces$next$a177, pieces$next$a14, pieces$next$a176);
  and pieces$next$a178$g (pieces$next$a178, pieces$next$a14, pieces$next$a176);
  or pieces$next$a179$g (pieces$next$a179, pieces$next$a14$not, pieces$next$a178);
  xor pieces$next$a180$g (pieces$next$a180, pieces$next$a14, pieces$next$a179);
  and pieces$next$a181$g (pieces$next$a181, pieces$next$a14, pieces$next$a179);
  or pieces$next$a182$g (pieces$next$a182, pieces$next$a14$not, pieces$next$a181);
  xor pieces$next$a183$g (pieces$next$a183, pieces$next$a14, pieces$next$a182);
  and pieces$next$a184$g (pieces$next$a184, pieces$next$a14, pieces$next$a182);
  or pieces$next$a185$g (pieces$next$a185, pieces$next$a14$not, pieces$next$a184);
  xor pieces$next$a186$g (pieces$next$a186, pieces$next$a14, pieces$next$a185);
  and pieces$next$a187$g (pieces$next$a187, pieces$next$a14, pieces$next$a185);
  or pieces$next$a188$g (pieces$next$a188, pieces$next$a14$not, pieces$next$a187);
  xor pieces$next$a189$g (pieces$next$a189, pieces$next$a14, pieces$next$a188);
  and pieces$next$a190$g (pieces$next$a190, pieces$next$a14, pieces$next$a188);
  or pieces$next$a191$g (pieces$next$a191, pieces$next$a14$not, pieces$next$a190);
  xor pieces$next$a192$g (pieces$next$a192, pieces$next$a14, pieces$next$a191);
  and pieces$next$a193$g (pieces$next$a193, pieces$next$a14, pieces$next$a191);
  or pieces$next$a194$g (pieces$next$a194, pieces$next$a14$not, pieces$next$a193);
  xor pieces$next$a195$g (pieces$next$a195, pieces$next$a14, pieces$next$a194);
  and pieces$next$a196$g (pieces$next$a196, pieces$next$a14, pieces$next$a194);
  or pieces$next$a197$g (pieces$next$a197, pieces$next$a14$not, pieces$next$a196);
  xor pieces$next$a198$g (pieces$next$a198, pieces$next$a14, pieces$next$a197);
  and pieces$next$a199$g (pieces$next$a199, pieces$next$a14, pieces$next$a197);
  or pieces$next$a200$g (pieces$next$a200, pieces$next$a14$not, pieces$next$a199);
  xor pieces$next$a201$g (pieces$next$a201, pieces$next$a14, pieces$next$a200);
  and pieces$next$a202$g (pieces$next$a202, pieces$next$a14, pieces$next$a200);
  or pieces$next$a203$g (pieces$next$a203, pieces$next$a14$not, pieces$next$a202);
  xor pieces$next$a204$g (pieces$next$a204, pieces$next$a14, pieces$next$a203);
  and pieces$next$a205$g (pieces$next$a205, pieces$next$a14, pieces$next$a203);
  or pieces$next$a206$g (pieces$next$a206, pieces$next$a14$not, pieces$next$a205);
  xor pieces$next$a207$g (pieces$next$a207, pieces$next$a14, pieces$next$a206);
  and pieces$next$a208$g (pieces$next$a208, pieces$next$a14, pieces$next$a206);
  or pieces$next$a209$g (pieces$next$a209, pieces$next$a14$not, pieces$next$a208);
  xor pieces$next$a210$g (pieces$next$a210, pieces$next$a14, pieces$next$a209);
  or pieces$next$a211$g (pieces$next$a211, pieces$q0$not, pieces$next$a16);
  or pieces$next$a212$g (pieces$next$a212, pieces$next$a211, pieces$next$a19);
  or pieces$next$a213$g (pieces$next$a213, pieces$next$a212, pieces$next$a21);
  or pieces$next$a214$g (pieces$next$a214, pieces$next$a213, pieces$next$a24);
  or pieces$next$a215$g (pieces$next$a215, pieces$next$a214, pieces$next$a27);
  or pieces$next$a216$g (pieces$next$a216, pieces$next$a215, pieces$next$a30);
  or pieces$next$a217$g (pieces$next$a217, pieces$next$a216, pieces$next$a33);
  or pieces$next$a218$g (pieces$next$a218, pieces$next$a217, pieces$next$a36);
  or pieces$next$a219$g (pieces$next$a219, pieces$next$a218, pieces$next$a39);
  or pieces$next$a220$g (pieces$next$a220, pieces$next$a219, pieces$next$a42);
  or pieces$next$a221$g (pieces$next$a221, pieces$next$a220, pieces$next$a45);
  or pieces$next$a222$g (pieces$next$a222, pieces$next$a221, pieces$next$a48);
  or pieces$next$a223$g (pieces$next$a223, pieces$next$a222, pieces$next$a51);
  or pieces$next$a224$g (pieces$next$a224, pieces$next$a223, pieces$next$a54);
  or pieces$next$a225$g (pieces$next$a225, pieces$next$a224, pieces$next$a57);
  or pieces$next$a226$g (pieces$next$a226, pieces$next$a225, pieces$next$a60);
  or pieces$next$a227$g (pieces$next$a227, pieces$next$a226, pieces$next$a63);
  or pieces$next$a228$g (pieces$next$a228, pieces$next$a227, pieces$next$a66);
  or pieces$next$a229$g (pieces$next$a229, pieces$next$a228, pieces$next$a69);
  or pieces$next$a230$g (pieces$next$a230, pieces$next$a229, pieces$next$a72);
  or pieces$next$a231$g (pieces$next$a231, pieces$next$a230, pieces$next$a75);
  or pieces$next$a232$g (pieces$next$a232, pieces$next$a231, pieces$next$a78);
  or pieces$next$a233$g (pieces$next$a233, pieces$next$a232, pieces$next$a81);
  or pieces$next$a234$g (pieces$next$a234, pieces$next$a233, pieces$next$a84);
  or pieces$next$a235$g (pieces$next$a235, pieces$next$a234, pieces$next$a87);
  or pieces$next$a236$g (pieces$next$a236, pieces$next$a235, pieces$next$a90);
  or pieces$next$a237$g (pieces$next$a237, pieces$next$a236, pieces$next$a93);
  or pieces$next$a238$g (pieces$next$a238, pieces$next$a237, pieces$next$a96);
  or pieces$next$a239$g (pieces$next$a239, pieces$next$a238, pieces$next$a99);
  or pieces$next$a240$g (pieces$next$a240, pieces$next$a239, pieces$next$a102);
  or pieces$next$a241$g (pieces$next$a241, pieces$next$a240, pieces$next$a105);
  or pieces$next$a242$g (pieces$next$a242, pieces$next$a241, pieces$next$a108);
  or pieces$next$a243$g (pieces$next$a243, pieces$next$a242, pieces$next$a111);
  or pieces$next$a244$g (pieces$next$a244, pieces$next$a243, pieces$next$a114);
  or pieces$next$a245$g (pieces$next$a245, pieces$next$a244, pieces$next$a117);
  or pieces$next$a246$g (pieces$next$a246, pieces$next$a245, pieces$next$a120);
  or pieces$next$a247$g (pieces$next$a247, pieces$next$a246, pieces$next$a123);
  or pieces$next$a248$g (pieces$next$a248, pieces$next$a247, pieces$next$a126);
  or pieces$next$a249$g (pieces$next$a249, pieces$next$a248, pieces$next$a129);
  or pieces$next$a250$g (pieces$next$a250, pieces$next$a249, pieces$next$a132);
  or pieces$next$a251$g (pieces$next$a251, pieces$next$a250, pieces$next$a135);
  or pieces$next$a252$g (pieces$next$a252, pieces$next$a251, pieces$next$a138);
  or pieces$next$a253$g (pieces$next$a253, pieces$next$a252, pieces$next$a141);
  or pieces$next$a254$g (pieces$next$a254, pieces$next$a253, pieces$next$a144);
  or pieces$next$a255$g (pieces$next$a255, pieces$next$a254, pieces$next$a147);
  or pieces$next$a256$g (pieces$next$a256, pieces$next$a255, pieces$next$a150);
  or pieces$next$a257$g (pieces$next$a257, pieces$next$a256, pieces$next$a153);
  or pieces$next$a258$g (pieces$next$a258, pieces$next$a257, pieces$next$a156);
  or pieces$next$a259$g (pieces$next$a259, pieces$next$a258, pieces$next$a159);
  or pieces$next$a260$g (pieces$next$a260, pieces$next$a259, pieces$next$a162);
  or pieces$next$a261$g (pieces$next$a261, pieces$next$a260, pieces$next$a165);
  or pieces$next$a262$g (pieces$next$a262, pieces$next$a261, pieces$next$a168);
  or pieces$next$a263$g (pieces$next$a263, pieces$next$a262, pieces$next$a171);
  or pieces$next$a264$g (pieces$next$a264, pieces$next$a263, pieces$next$a174);
  or pieces$next$a265$g (pieces$next$a265, pieces$next$a264, pieces$next$a177);
  or pieces$next$a266$g (pieces$next$a266, pieces$next$a265, pieces$next$a180);
  or pieces$next$a267$g (pieces$next$a267, pieces$next$a266, pieces$next$a183);
  or pieces$next$a268$g (pieces$next$a268, pieces$next$a267, pieces$next$a186);
  or pieces$next$a269$g (pieces$next$a269, pieces$next$a268, pieces$next$a189);
  or pieces$next$a270$g (pieces$next$a270, pieces$next$a269, pieces$next$a192);
  or pieces$next$a271$g (pieces$next$a271, pieces$next$a270, pieces$next$a195);
  or pieces$next$a272$g (pieces$next$a272, pieces$next$a271, pieces$next$a198);
  or pieces$next$a273$g (pieces$next$a273, pieces$next$a272, pieces$next$a201);
  or pieces$next$a274$g (pieces$next$a274, pieces$next$a273, pieces$next$a204);
  or pieces$next$a275$g (pieces$next$a275, pieces$next$a274, pieces$next$a207);
  or pieces$next$a276$g (pieces$next$a276, pieces$next$a275, pieces$next$a210);
  not pieces$next$a276$not$g (pieces$next$a276$not, pieces$next$a276);
  or pieces$next$a277$g (pieces$next$a277, pieces$next$a210, pieces$next$a276$not);
  not pieces$next$a277$not$g (pieces$next$a277$not, pieces$next$a277);
  and pieces$next$a278$g (pieces$next$a278, pieces$next$a277, pieces$q0$not);
  and pieces$next$a279$g (pieces$next$a279, pieces$next$a277, pieces$next$a6);
  and pieces$next$a280$g (pieces$next$a280, pieces$next$a277, pieces$next$a9);
  or pieces$next$a281$g (pieces$next$a281, pieces$next$a277$not, pieces$next$a280);
  and pieces$next$a282$g (pieces$next$a282, pieces$next$a277, pieces$next$a12);
  and pieces$next$a283$g (pieces$next$a283, pieces$next$a14, pieces$next$a278);
  and pieces$next$a284$g (pieces$next$a284, pieces$next$a14, pieces$next$a279);
  and pieces$next$a285$g (pieces$next$a285, pieces$next$a14, pieces$next$a281);
  and pieces$next$a286$g (pieces$next$a286, pieces$next$a14, pieces$next$a282);
  and pieces$next$a287$g (pieces$next$a287, T11$clear, pieces$next$a283);
  and pieces$next$a288$g (pieces$next$a288, T11$clear$not, pieces$q0);
  or pieces$next$a289$g (pieces$next$a289, pieces$next$a287, pieces$next$a288);
  and pieces$next$a290$g (pieces$next$a290, T11$clear, pieces$next$a284);
  and pieces$next$a291$g (pieces$next$a291, T11$clear$not, pieces$q1);
  or pieces$next$a292$g (pieces$next$a292, pieces$next$a290, pieces$next$a291);
  and pieces$next$a293$g (pieces$next$a293, T11$clear, pieces$next$a285);
  and pieces$next$a294$g (pieces$next$a294, T11$clear$not, pieces$q2);
  or pieces$next$a295$g (pieces$next$a295, pieces$next$a293, pieces$next$a294);
  and pieces$next$a296$g (pieces$next$a296, T11$clear, pieces$next$a286);
  and pieces$next$a297$g (pieces$next$a297, T14$clear$not, pieces$next$a289);
  and pieces$next$a298$g (pieces$next$a298, T14$clear$not, pieces$next$a292);
  and pieces$next$a299$g (pieces$next$a299, T14$clear$not, pieces$next$a295);
  and pieces$next$a300$g (pieces$next$a300, T14$clear$not, pieces$next$a296);
  grafwire_dff #(.INIT(1'b0)) pieces$q0$g (.d(pieces$next$a297), .c(clk), .q(pieces$q0));
  grafwire_dff #(.INIT(1'b0)) pieces$q1$g (.d(pieces$next$a298), .c(clk), .q(pieces$q1));
  grafwire_dff #(.INIT(1'b0)) pieces$q2$g (.d(pieces$next$a299), .c(clk), .q(pieces$q2));

  // timer$0
  grafwire_scan_timer #(.RISE_PS(64'd500000000000), .FALL_PS(64'd0), .SCAN_PS(SCAN_PS), .INIT(1'b0)) timer$0$g (.a(X112$next), .c(clk), .q(timer$0));  // 500ms, 0s

  // timer$1
  grafwire_scan_timer #(.RISE_PS(64'd200000000000), .FALL_PS(64'd0), .SCAN_PS(SCAN_PS), .INIT(1'b0)) timer$1$g (.a(X20$next), .c(clk), .q(timer$1));  // 200ms, 0s

  // timer$2
  grafwire_scan_timer #(.RISE_PS(64'd300000000000), .FALL_PS(64'd0), .SCAN_PS(SCAN_PS), .INIT(1'b0)) timer$2$g (.a(X21$next), .c(clk), .q(timer$2));  // 300ms, 0s

  // KM down = X111./AUdoux
  not AUdoux$not$g (AUdoux$not, AUdoux);
  and \KM%20down$1$g  (\KM%20down$1 , X111, AUdoux$not);
  buf \KM%20down$g  (\KM%20down , \KM%20down$1 );

  // KM up = X113./AUdoux
  and \KM%20up$1$g  (\KM%20up$1 , X113, AUdoux$not);
  buf \KM%20up$g  (\KM%20up , \KM%20up$1 );

  // blow = (X20 + X22)./AUdoux
  or blow$1$g (blow$1, X20, X22);
  and blow$2$g (blow$2, blow$1, AUdoux$not);
  buf blow$g (blow, blow$2);

  // ready = X10./AUdoux
  and ready$1$g (ready$1, X10, AUdoux$not);
  buf ready$g (ready, ready$1);

  // busy = X1.(XE11 + X111 + X112 + X113 + XS11 + X20 + X21 + X22)./AUdoux
  or busy$1$g (busy$1, XE11, X111, X112, X113, XS11, X20, X21, X22);
  and busy$2$g (busy$2, X1, busy$1, AUdoux$not);
  buf busy$g (busy, busy$2);

  // alarm = X2./AUdoux
  and alarm$1$g (alarm$1, X2, AUdoux$not);
  buf alarm$g (alarm, alarm$1);

  // tray full = X13./AUdoux
  and \tray%20full$1$g  (\tray%20full$1 , X13, AUdoux$not);
  buf \tray%20full$g  (\tray%20full , \tray%20full$1 );
endmodule

`timescale 1ps/1ps

// D flip-flop.
module grafwire_dff #(parameter INIT = 1'bx) (input d, input c, output reg q);
  initial q = INIT;
  always @(posedge c) q <= d;
endmodule

// Clocked timer: looks at a at each rise of the clock and follows it after so many cycles as make up
// RISE_PS or FALL_PS.
module grafwire_scan_timer #(parameter [63:0] RISE_PS = 0, FALL_PS = 0, SCAN_PS = 1, parameter INIT = 1'b0)
    (input a, input c, output reg q);
  localparam [63:0] RISE = (RISE_PS + SCAN_PS - 1) / SCAN_PS;
  localparam [63:0] FALL = (FALL_PS + SCAN_PS - 1) / SCAN_PS;
  localparam [63:0] LONGEST = RISE > FALL ? RISE : FALL;
  localparam WIDTH = $clog2(LONGEST + 1) + 1;
  reg [WIDTH-1:0] elapsed;
  initial begin q = INIT; elapsed = 0; end
  always @(posedge c)
    if (a == q) elapsed <= 0;
    else if (elapsed >= (a ? RISE[WIDTH-1:0] : FALL[WIDTH-1:0])) begin q <= a; elapsed <= 0; end
    else elapsed <= elapsed + 1'b1;
endmodule
