// lift "Monte-charge" (lift.grafcet): 371 cells.
// Style clocked, CDX by transitions, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist lift.grafcet --style clocked --cdx transition --modes on --to verilog --scan 10ms
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $N         a gate of a condition of the owner
//   $aN        a gate of the arithmetic that works out a value
//   $clear     of a transition: it is cleared; of a step: Init deactivates it
//   edge$N     edge N of the chart, counted from 0
//   $evolved   the step after the transitions, before any order
//   $force     of the forcing orders to the graph
//   $forced    a forcing order activates the step
//   $free      no forcing order stands against it
//   $high      always 1
//   $hold      keeps the owner as it is
//   $low       always 0
//   $memory    the operand of the edge, a scan ago
//   $next      the owner as it is from the next clock on
//   $not       the owner inverted
//   $qN        bit N of the counter
//   $running   1 from the second scan on
//   timer$N    time condition N of the chart, counted from 0
//   $unforced  a forcing order deactivates the step
//   $whenN     something is written to the owner
`timescale 1ns/1ps

module lift #(parameter [63:0] SCAN_PS = 64'd10000000000) (
  input crate,
  input top,
  input \arrêt ,
  input \int ,
  input Init,
  input AUdur,
  input AUdoux,
  input clk,
  output X0,
  output X1,
  output X2,
  output X10,
  output X11,
  output X12,
  output UP,
  output blow,
  output lamp
);
  wire Init$not, AUdur$not, \$low ;
  wire \$high , edges$running, edge$0$memory, edge$0$memory$not, edge$0, edge$1$memory, edge$1$memory$not, edge$1;
  wire T0$clear;
  wire \arrêt$not , T1$1, T1$clear;
  wire T2$clear;
  wire n$q0$not, Tgo$1$a1, Tgo$1$a2, Tgo$1$a2$not, Tgo$2, Tgo$clear;
  wire T4$clear;
  wire T5$clear;
  wire T0$clear$not, X0$hold, X0$evolved, X0$next;
  wire T1$clear$not, X1$hold, X1$evolved, X1$next;
  wire T2$clear$not, X2$hold, X2$evolved, X2$next;
  wire Tgo$clear$not, X10$hold, X10$evolved, X10$next;
  wire T4$clear$not, X11$hold, X11$evolved, X11$next;
  wire T5$clear$not, X12$hold, X12$evolved, X12$next;
  wire XWork$force$free, X10$unforced, X10$forced, X11$unforced, X12$unforced;
  wire full$next$a1, full$when2, full$when2$not, full$next$a2, full$next$a3, full;
  wire X11$not, n$when1, n$next$a1, n$next$a2, n$next$a3, n$next$a1$not, n$next$a4, n$next$a5, n$next$a6, n$next$a2$not, n$next$a7, n$next$a8, n$next$a9, n$next$a9$not, n$next$a10, n$next$a11, n$next$a7$not, n$next$a12, n$next$a13, n$next$a14, n$next$a15, n$next$a16, n$next$a17, n$next$a18, n$next$a19, n$next$a20, n$next$a21, n$next$a22, n$next$a23, n$next$a24, n$next$a25, n$next$a26, n$next$a27, n$next$a28, n$next$a29, n$next$a30, n$next$a31, n$next$a32, n$next$a33, n$next$a34, n$next$a35, n$next$a36, n$next$a37, n$next$a38, n$next$a39, n$next$a40, n$next$a41, n$next$a42, n$next$a43, n$next$a44, n$next$a45, n$next$a46, n$next$a47, n$next$a48, n$next$a49, n$next$a50, n$next$a51, n$next$a52, n$next$a53, n$next$a54, n$next$a55, n$next$a56, n$next$a57, n$next$a58, n$next$a59, n$next$a60, n$next$a61, n$next$a62, n$next$a63, n$next$a64, n$next$a65, n$next$a66, n$next$a67, n$next$a68, n$next$a69, n$next$a70, n$next$a71, n$next$a72, n$next$a73, n$next$a74, n$next$a75, n$next$a76, n$next$a77, n$next$a78, n$next$a79, n$next$a80, n$next$a81, n$next$a82, n$next$a83, n$next$a84, n$next$a85, n$next$a86, n$next$a87, n$next$a88, n$next$a89, n$next$a90, n$next$a91, n$next$a92, n$next$a93, n$next$a94, n$next$a95, n$next$a96, n$next$a97, n$next$a98, n$next$a99, n$next$a100, n$next$a101, n$next$a102, n$next$a103, n$next$a104, n$next$a105, n$next$a106, n$next$a107, n$next$a108, n$next$a109, n$next$a110, n$next$a111, n$next$a112, n$next$a113, n$next$a114, n$next$a115, n$next$a116, n$next$a117, n$next$a118, n$next$a119, n$next$a120, n$next$a121, n$next$a122, n$next$a123, n$next$a124, n$next$a125, n$next$a126, n$next$a127, n$next$a128, n$next$a129, n$next$a130, n$next$a131, n$next$a132, n$next$a133, n$next$a134, n$next$a135, n$next$a136, n$next$a137, n$next$a138, n$next$a139, n$next$a140, n$next$a141, n$next$a142, n$next$a143, n$next$a144, n$next$a145, n$next$a146, n$next$a147, n$next$a148, n$next$a149, n$next$a150, n$next$a151, n$next$a152, n$next$a153, n$next$a154, n$next$a155, n$next$a156, n$next$a157, n$next$a158, n$next$a159, n$next$a160, n$next$a161, n$next$a162, n$next$a163, n$next$a164, n$next$a165, n$next$a166, n$next$a167, n$next$a168, n$next$a169, n$next$a170, n$next$a171, n$next$a172, n$next$a173, n$next$a174, n$next$a175, n$next$a176, n$next$a177, n$next$a178, n$next$a179, n$next$a180, n$next$a181, n$next$a182, n$next$a183, n$next$a184, n$next$a185, n$next$a186, n$next$a187, n$next$a188, n$next$a189, n$next$a190, n$next$a191, n$next$a192, n$next$a193, n$next$a194, n$next$a195, n$next$a196, n$next$a197, n$next$a198, n$next$a199, n$next$a200, n$next$a201, n$next$a202, n$next$a203, n$next$a204, n$next$a205, n$next$a206, n$next$a207, n$next$a208, n$next$a209, n$next$a210, n$next$a211, n$next$a212, n$next$a213, n$next$a214, n$next$a215, n$next$a216, n$next$a217, n$next$a218, n$next$a219, n$next$a220, n$next$a221, n$next$a222, n$next$a223, n$next$a224, n$next$a225, n$next$a226, n$next$a227, n$next$a228, n$next$a229, n$next$a230, n$next$a231, n$next$a232, n$next$a233, n$next$a234, n$next$a235, n$next$a236, n$next$a237, n$next$a238, n$next$a239, n$next$a240, n$next$a241, n$next$a242, n$next$a243, n$next$a244, n$next$a245, n$next$a246, n$next$a247, n$next$a248, n$next$a249, n$next$a250, n$next$a251, n$next$a252, n$next$a253, n$next$a254, n$next$a255, n$next$a256, n$next$a257, n$next$a258, n$next$a259, n$next$a260, n$next$a261, n$next$a262, n$next$a263, n$next$a264, n$next$a265, n$next$a266, n$next$a267, n$next$a268, n$next$a269, n$next$a270, n$next$a270$not, n$next$a271, n$next$a271$not, n$next$a272, n$next$a273, n$next$a274, n$next$a275, n$next$a276, n$next$a277, n$next$a278, n$next$a279, n$next$a280, n$when1$not, n$next$a281, n$next$a282, n$next$a283, n$next$a284, n$next$a285, n$next$a286, n$q0, n$q1;
  wire timer$0;
  wire top$not, AUdoux$not, UP$1;
  wire blow$1;
  wire lamp$1;

  // inputs
  not Init$not$g (Init$not, Init);
  not AUdur$not$g (AUdur$not, AUdur);
  assign \$low  = 1'b0;

  // edges
  assign \$high  = 1'b1;
  grafwire_dff #(.INIT(1'b0)) edges$running$g (.d(\$high ), .c(clk), .q(edges$running));
  grafwire_dff #(.INIT(1'b0)) edge$0$memory$g (.d(top), .c(clk), .q(edge$0$memory));
  not edge$0$memory$not$g (edge$0$memory$not, edge$0$memory);
  and edge$0$g (edge$0, top, edge$0$memory$not, edges$running);
  grafwire_dff #(.INIT(1'b0)) edge$1$memory$g (.d(crate), .c(clk), .q(edge$1$memory));
  not edge$1$memory$not$g (edge$1$memory$not, edge$1$memory);
  and edge$1$g (edge$1, crate, edge$1$memory$not, edges$running);

  // T0
  and T0$clear$g (T0$clear, X0, \arrêt , Init$not);

  // T1
  not \arrêt$not$g  (\arrêt$not , \arrêt );
  xor T1$1$g (T1$1, \arrêt$not , \int );
  and T1$clear$g (T1$clear, X1, T1$1, Init$not);

  // T2
  and T2$clear$g (T2$clear, X2, Init$not);

  // Tgo
  not n$q0$not$g (n$q0$not, n$q0);
  xor Tgo$1$a1$g (Tgo$1$a1, n$q1, n$q0);
  and Tgo$1$a2$g (Tgo$1$a2, n$q1, n$q0);
  not Tgo$1$a2$not$g (Tgo$1$a2$not, Tgo$1$a2);
  and Tgo$2$g (Tgo$2, edge$1, Tgo$1$a2$not);
  and Tgo$clear$g (Tgo$clear, X10, Tgo$2, Init$not);

  // T4
  and T4$clear$g (T4$clear, X11, timer$0, Init$not);

  // T5
  and T5$clear$g (T5$clear, X12, Init$not);

  // X0 = (X2 + /(X0.arrêt).X0 + Init)./AUdur
  not T0$clear$not$g (T0$clear$not, T0$clear);
  and X0$hold$g (X0$hold, X0, T0$clear$not);
  or X0$evolved$g (X0$evolved, T2$clear, X0$hold, Init);
  and X0$next$g (X0$next, X0$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b1)) X0$g (.d(X0$next), .c(clk), .q(X0));

  // X1 = (X0.arrêt + /(X1.(/arrêt ⊕ int)).X1)./Init./AUdur
  not T1$clear$not$g (T1$clear$not, T1$clear);
  and X1$hold$g (X1$hold, X1, T1$clear$not, Init$not);
  or X1$evolved$g (X1$evolved, T0$clear, X1$hold);
  and X1$next$g (X1$next, X1$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X1$g (.d(X1$next), .c(clk), .q(X1));

  // X2 = (X1.(/arrêt ⊕ int) + /X2.X2)./Init./AUdur
  not T2$clear$not$g (T2$clear$not, T2$clear);
  and X2$hold$g (X2$hold, X2, T2$clear$not, Init$not);
  or X2$evolved$g (X2$evolved, T1$clear, X2$hold);
  and X2$next$g (X2$next, X2$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X2$g (.d(X2$next), .c(clk), .q(X2));

  // X10 = ((X12 + /(X10.↑crate.[n < 3]).X10 + Init)./(X1 + X2) + X2)./AUdur
  not Tgo$clear$not$g (Tgo$clear$not, Tgo$clear);
  and X10$hold$g (X10$hold, X10, Tgo$clear$not);
  or X10$evolved$g (X10$evolved, T5$clear, X10$hold, Init);
  and X10$next$g (X10$next, X10$forced, AUdur$not);
  grafwire_dff #(.INIT(1'b1)) X10$g (.d(X10$next), .c(clk), .q(X10));

  // X11 = (X10.↑crate.[n < 3] + /(X11 . 1.5s/top/20ms).X11)./Init./(X1 + X2)./AUdur
  not T4$clear$not$g (T4$clear$not, T4$clear);
  and X11$hold$g (X11$hold, X11, T4$clear$not, Init$not);
  or X11$evolved$g (X11$evolved, Tgo$clear, X11$hold);
  and X11$next$g (X11$next, X11$unforced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X11$g (.d(X11$next), .c(clk), .q(X11));

  // X12 = (X11 . 1.5s/top/20ms + /X12.X12)./Init./(X1 + X2)./AUdur
  not T5$clear$not$g (T5$clear$not, T5$clear);
  and X12$hold$g (X12$hold, X12, T5$clear$not, Init$not);
  or X12$evolved$g (X12$evolved, T4$clear, X12$hold);
  and X12$next$g (X12$next, X12$unforced, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X12$g (.d(X12$next), .c(clk), .q(X12));

  // XWork$force
  nor XWork$force$free$g (XWork$force$free, X1$evolved, X2$evolved);
  and X10$unforced$g (X10$unforced, X10$evolved, XWork$force$free);
  or X10$forced$g (X10$forced, X2$evolved, X10$unforced);
  and X11$unforced$g (X11$unforced, X11$evolved, XWork$force$free);
  and X12$unforced$g (X12$unforced, X12$evolved, XWork$force$free);

  // full
  and full$next$a1$g (full$next$a1, T5$clear$not, full);
  and full$when2$g (full$when2, X12$next, edge$0);
  not full$when2$not$g (full$when2$not, full$when2);
  and full$next$a2$g (full$next$a2, full$when2$not, full$next$a1);
  or full$next$a3$g (full$next$a3, full$when2, full$next$a2);
  grafwire_dff #(.INIT(1'b0)) full$g (.d(full$next$a3), .c(clk), .q(full));

  // n
  not X11$not$g (X11$not, X11);
  and n$when1$g (n$when1, X11$not, X11$next);
  xor n$next$a1$g (n$next$a1, n$q1, n$q0);
  and n$next$a2$g (n$next$a2, n$q1, n$q0);
  or n$next$a3$g (n$next$a3, n$q0$not, n$q0);
  not n$next$a1$not$g (n$next$a1$not, n$next$a1);
  xor n$next$a4$g (n$next$a4, n$next$a1$not, n$next$a3);
  and n$next$a5$g (n$next$a5, n$next$a1$not, n$next$a3);
  or n$next$a6$g (n$next$a6, n$next$a1, n$next$a5);
  not n$next$a2$not$g (n$next$a2$not, n$next$a2);
  xor n$next$a7$g (n$next$a7, n$next$a2$not, n$next$a6);
  and n$next$a8$g (n$next$a8, n$next$a2$not, n$next$a6);
  or n$next$a9$g (n$next$a9, n$next$a2, n$next$a8);
  not n$next$a9$not$g (n$next$a9$not, n$next$a9);
  xor n$next$a10$g (n$next$a10, n$next$a4, n$q0$not);
  and n$next$a11$g (n$next$a11, n$next$a4, n$q0$not);
  not n$next$a7$not$g (n$next$a7$not, n$next$a7);
  xor n$next$a12$g (n$next$a12, n$next$a7$not, n$next$a11);
  and n$next$a13$g (n$next$a13, n$next$a7$not, n$next$a11);
  or n$next$a14$g (n$next$a14, n$next$a7, n$next$a13);
  xor n$next$a15$g (n$next$a15, n$next$a9, n$next$a14);
  and n$next$a16$g (n$next$a16, n$next$a9, n$next$a14);
  or n$next$a17$g (n$next$a17, n$next$a9$not, n$next$a16);
  xor n$next$a18$g (n$next$a18, n$next$a9, n$next$a17);
  and n$next$a19$g (n$next$a19, n$next$a9, n$next$a17);
  or n$next$a20$g (n$next$a20, n$next$a9$not, n$next$a19);
  xor n$next$a21$g (n$next$a21, n$next$a9, n$next$a20);
  and n$next$a22$g (n$next$a22, n$next$a9, n$next$a20);
  or n$next$a23$g (n$next$a23, n$next$a9$not, n$next$a22);
  xor n$next$a24$g (n$next$a24, n$next$a9, n$next$a23);
  and n$next$a25$g (n$next$a25, n$next$a9, n$next$a23);
  or n$next$a26$g (n$next$a26, n$next$a9$not, n$next$a25);
  xor n$next$a27$g (n$next$a27, n$next$a9, n$next$a26);
  and n$next$a28$g (n$next$a28, n$next$a9, n$next$a26);
  or n$next$a29$g (n$next$a29, n$next$a9$not, n$next$a28);
  xor n$next$a30$g (n$next$a30, n$next$a9, n$next$a29);
  and n$next$a31$g (n$next$a31, n$next$a9, n$next$a29);
  or n$next$a32$g (n$next$a32, n$next$a9$not, n$next$a31);
  xor n$next$a33$g (n$next$a33, n$next$a9, n$next$a32);
  and n$next$a34$g (n$next$a34, n$next$a9, n$next$a32);
  or n$next$a35$g (n$next$a35, n$next$a9$not, n$next$a34);
  xor n$next$a36$g (n$next$a36, n$next$a9, n$next$a35);
  and n$next$a37$g (n$next$a37, n$next$a9, n$next$a35);
  or n$next$a38$g (n$next$a38, n$next$a9$not, n$next$a37);
  xor n$next$a39$g (n$next$a39, n$next$a9, n$next$a38);
  and n$next$a40$g (n$next$a40, n$next$a9, n$next$a38);
  or n$next$a41$g (n$next$a41, n$next$a9$not, n$next$a40);
  xor n$next$a42$g (n$next$a42, n$next$a9, n$next$a41);
  and n$next$a43$g (n$next$a43, n$next$a9, n$next$a41);
  or n$next$a44$g (n$next$a44, n$next$a9$not, n$next$a43);
  xor n$next$a45$g (n$next$a45, n$next$a9, n$next$a44);
  and n$next$a46$g (n$next$a46, n$next$a9, n$next$a44);
  or n$next$a47$g (n$next$a47, n$next$a9$not, n$next$a46);
  xor n$next$a48$g (n$next$a48, n$next$a9, n$next$a47);
  and n$next$a49$g (n$next$a49, n$next$a9, n$next$a47);
  or n$next$a50$g (n$next$a50, n$next$a9$not, n$next$a49);
  xor n$next$a51$g (n$next$a51, n$next$a9, n$next$a50);
  and n$next$a52$g (n$next$a52, n$next$a9, n$next$a50);
  or n$next$a53$g (n$next$a53, n$next$a9$not, n$next$a52);
  xor n$next$a54$g (n$next$a54, n$next$a9, n$next$a53);
  and n$next$a55$g (n$next$a55, n$next$a9, n$next$a53);
  or n$next$a56$g (n$next$a56, n$next$a9$not, n$next$a55);
  xor n$next$a57$g (n$next$a57, n$next$a9, n$next$a56);
  and n$next$a58$g (n$next$a58, n$next$a9, n$next$a56);
  or n$next$a59$g (n$next$a59, n$next$a9$not, n$next$a58);
  xor n$next$a60$g (n$next$a60, n$next$a9, n$next$a59);
  and n$next$a61$g (n$next$a61, n$next$a9, n$next$a59);
  or n$next$a62$g (n$next$a62, n$next$a9$not, n$next$a61);
  xor n$next$a63$g (n$next$a63, n$next$a9, n$next$a62);
  and n$next$a64$g (n$next$a64, n$next$a9, n$next$a62);
  or n$next$a65$g (n$next$a65, n$next$a9$not, n$next$a64);
  xor n$next$a66$g (n$next$a66, n$next$a9, n$next$a65);
  and n$next$a67$g (n$next$a67, n$next$a9, n$next$a65);
  or n$next$a68$g (n$next$a68, n$next$a9$not, n$next$a67);
  xor n$next$a69$g (n$next$a69, n$next$a9, n$next$a68);
  and n$next$a70$g (n$next$a70, n$next$a9, n$next$a68);
  or n$next$a71$g (n$next$a71, n$next$a9$not, n$next$a70);
  xor n$next$a72$g (n$next$a72, n$next$a9, n$next$a71);
  and n$next$a73$g (n$next$a73, n$next$a9, n$next$a71);
  or n$next$a74$g (n$next$a74, n$next$a9$not, n$next$a73);
  xor n$next$a75$g (n$next$a75, n$next$a9, n$next$a74);
  and n$next$a76$g (n$next$a76, n$next$a9, n$next$a74);
  or n$next$a77$g (n$next$a77, n$next$a9$not, n$next$a76);
  xor n$next$a78$g (n$next$a78, n$next$a9, n$next$a77);
  and n$next$a79$g (n$next$a79, n$next$a9, n$next$a77);
  or n$next$a80$g (n$next$a80, n$next$a9$not, n$next$a79);
  xor n$next$a81$g (n$next$a81, n$next$a9, n$next$a80);
  and n$next$a82$g (n$next$a82, n$next$a9, n$next$a80);
  or n$next$a83$g (n$next$a83, n$next$a9$not, n$next$a82);
  xor n$next$a84$g (n$next$a84, n$next$a9, n$next$a83);
  and n$next$a85$g (n$next$a85, n$next$a9, n$next$a83);
  or n$next$a86$g (n$next$a86, n$next$a9$not, n$next$a85);
  xor n$next$a87$g (n$next$a87, n$next$a9, n$next$a86);
  and n$next$a88$g (n$next$a88, n$next$a9, n$next$a86);
  or n$next$a89$g (n$next$a89, n$next$a9$not, n$next$a88);
  xor n$next$a90$g (n$next$a90, n$next$a9, n$next$a89);
  and n$next$a91$g (n$next$a91, n$next$a9, n$next$a89);
  or n$next$a92$g (n$next$a92, n$next$a9$not, n$next$a91);
  xor n$next$a93$g (n$next$a93, n$next$a9, n$next$a92);
  and n$next$a94$g (n$next$a94, n$next$a9, n$next$a92);
  or n$next$a95$g (n$next$a95, n$next$a9$not, n$next$a94);
  xor n$next$a96$g (n$next$a96, n$next$a9, n$next$a95);
  and n$next$a97$g (n$next$a97, n$next$a9, n$next$a95);
  or n$next$a98$g (n$next$a98, n$next$a9$not, n$next$a97);
  xor n$next$a99$g (n$next$a99, n$next$a9, n$next$a98);
  and n$next$a100$g (n$next$a100, n$next$a9, n$next$a98);
  or n$next$a101$g (n$next$a101, n$next$a9$not, n$next$a100);
  xor n$next$a102$g (n$next$a102, n$next$a9, n$next$a101);
  and n$next$a103$g (n$next$a103, n$next$a9, n$next$a101);
  or n$next$a104$g (n$next$a104, n$next$a9$not, n$next$a103);
  xor n$next$a105$g (n$next$a105, n$next$a9, n$next$a104);
  and n$next$a106$g (n$next$a106, n$next$a9, n$next$a104);
  or n$next$a107$g (n$next$a107, n$next$a9$not, n$next$a106);
  xor n$next$a108$g (n$next$a108, n$next$a9, n$next$a107);
  and n$next$a109$g (n$next$a109, n$next$a9, n$next$a107);
  or n$next$a110$g (n$next$a110, n$next$a9$not, n$next$a109);
  xor n$next$a111$g (n$next$a111, n$next$a9, n$next$a110);
  and n$next$a112$g (n$next$a112, n$next$a9, n$next$a110);
  or n$next$a113$g (n$next$a113, n$next$a9$not, n$next$a112);
  xor n$next$a114$g (n$next$a114, n$next$a9, n$next$a113);
  and n$next$a115$g (n$next$a115, n$next$a9, n$next$a113);
  or n$next$a116$g (n$next$a116, n$next$a9$not, n$next$a115);
  xor n$next$a117$g (n$next$a117, n$next$a9, n$next$a116);
  and n$next$a118$g (n$next$a118, n$next$a9, n$next$a116);
  or n$next$a119$g (n$next$a119, n$next$a9$not, n$next$a118);
  xor n$next$a120$g (n$next$a120, n$next$a9, n$next$a119);
  and n$next$a121$g (n$next$a121, n$next$a9, n$next$a119);
  or n$next$a122$g (n$next$a122, n$next$a9$not, n$next$a121);
  xor n$next$a123$g (n$next$a123, n$next$a9, n$next$a122);
  and n$next$a124$g (n$next$a124, n$next$a9, n$next$a122);
  or n$next$a125$g (n$next$a125, n$next$a9$not, n$next$a124);
  xor n$next$a126$g (n$next$a126, n$next$a9, n$next$a125);
  and n$next$a127$g (n$next$a127, n$next$a9, n$next$a125);
  or n$next$a128$g (n$next$a128, n$next$a9$not, n$next$a127);
  xor n$next$a129$g (n$next$a129, n$next$a9, n$next$a128);
  and n$next$a130$g (n$next$a130, n$next$a9, n$next$a128);
  or n$next$a131$g (n$next$a131, n$next$a9$not, n$next$a130);
  xor n$next$a132$g (n$next$a132, n$next$a9, n$next$a131);
  and n$next$a133$g (n$next$a133, n$next$a9, n$next$a131);
  or n$next$a134$g (n$next$a134, n$next$a9$not, n$next$a133);
  xor n$next$a135$g (n$next$a135, n$next$a9, n$next$a134);
  and n$next$a136$g (n$next$a136, n$next$a9, n$next$a134);
  or n$next$a137$g (n$next$a137, n$next$a9$not, n$next$a136);
  xor n$next$a138$g (n$next$a138, n$next$a9, n$next$a137);
  and n$next$a139$g (n$next$a139, n$next$a9, n$next$a137);
  or n$next$a140$g (n$next$a140, n$next$a9$not, n$next$a139);
  xor n$next$a141$g (n$next$a141, n$next$a9, n$next$a140);
  and n$next$a142$g (n$next$a142, n$next$a9, n$next$a140);
  or n$next$a143$g (n$next$a143, n$next$a9$not, n$next$a142);
  xor n$next$a144$g (n$next$a144, n$next$a9, n$next$a143);
  and n$next$a145$g (n$next$a145, n$next$a9, n$next$a143);
  or n$next$a146$g (n$next$a146, n$next$a9$not, n$next$a145);
  xor n$next$a147$g (n$next$a147, n$next$a9, n$next$a146);
  and n$next$a148$g (n$next$a148, n$next$a9, n$next$a146);
  or n$next$a149$g (n$next$a149, n$next$a9$not, n$next$a148);
  xor n$next$a150$g (n$next$a150, n$next$a9, n$next$a149);
  and n$next$a151$g (n$next$a151, n$next$a9, n$next$a149);
  or n$next$a152$g (n$next$a152, n$next$a9$not, n$next$a151);
  xor n$next$a153$g (n$next$a153, n$next$a9, n$next$a152);
  and n$next$a154$g (n$next$a154, n$next$a9, n$next$a152);
  or n$next$a155$g (n$next$a155, n$next$a9$not, n$next$a154);
  xor n$next$a156$g (n$next$a156, n$next$a9, n$next$a155);
  and n$next$a157$g (n$next$a157, n$next$a9, n$next$a155);
  or n$next$a158$g (n$next$a158, n$next$a9$not, n$next$a157);
  xor n$next$a159$g (n$next$a159, n$next$a9, n$next$a158);
  and n$next$a160$g (n$next$a160, n$next$a9, n$next$a158);
  or n$next$a161$g (n$next$a161, n$next$a9$not, n$next$a160);
  xor n$next$a162$g (n$next$a162, n$next$a9, n$next$a161);
  and n$next$a163$g (n$next$a163, n$next$a9, n$next$a161);
  or n$next$a164$g (n$next$a164, n$next$a9$not, n$next$a163);
  xor n$next$a165$g (n$next$a165, n$next$a9, n$next$a164);
  and n$next$a166$g (n$next$a166, n$next$a9, n$next$a164);
  or n$next$a167$g (n$next$a167, n$next$a9$not, n$next$a166);
  xor n$next$a168$g (n$next$a168, n$next$a9, n$next$a167);
  and n$next$a169$g (n$next$a169, n$next$a9, n$next$a167);
  or n$next$a170$g (n$next$a170, n$next$a9$not, n$next$a169);
  xor n$next$a171$g (n$next$a171, n$next$a9, n$next$a170);
  and n$next$a172$g (n$next$a172, n$next$a9, n$next$a170);
  or n$next$a173$g (n$next$a173, n$next$a9$not, n$next$a172);
  xor n$next$a174$g (n$next$a174, n$next$a9, n$next$a173);
  and n$next$a175$g (n$next$a175, n$next$a9, n$next$a173);
  or n$next$a176$g (n$next$a176, n$next$a9$not, n$next$a175);
  xor n$next$a177$g (n$next$a177, n$next$a9, n$next$a176);
  and n$next$a178$g (n$next$a178, n$next$a9, n$next$a176);
  or n$next$a179$g (n$next$a179, n$next$a9$not, n$next$a178);
  xor n$next$a180$g (n$next$a180, n$next$a9, n$next$a179);
  and n$next$a181$g (n$next$a181, n$next$a9, n$next$a179);
  or n$next$a182$g (n$next$a182, n$next$a9$not, n$next$a181);
  xor n$next$a183$g (n$next$a183, n$next$a9, n$next$a182);
  and n$next$a184$g (n$next$a184, n$next$a9, n$next$a182);
  or n$next$a185$g (n$next$a185, n$next$a9$not, n$next$a184);
  xor n$next$a186$g (n$next$a186, n$next$a9, n$next$a185);
  and n$next$a187$g (n$next$a187, n$next$a9, n$next$a185);
  or n$next$a188$g (n$next$a188, n$next$a9$not, n$next$a187);
  xor n$next$a189$g (n$next$a189, n$next$a9, n$next$a188);
  and n$next$a190$g (n$next$a190, n$next$a9, n$next$a188);
  or n$next$a191$g (n$next$a191, n$next$a9$not, n$next$a190);
  xor n$next$a192$g (n$next$a192, n$next$a9, n$next$a191);
  and n$next$a193$g (n$next$a193, n$next$a9, n$next$a191);
  or n$next$a194$g (n$next$a194, n$next$a9$not, n$next$a193);
  xor n$next$a195$g (n$next$a195, n$next$a9, n$next$a194);
  and n$next$a196$g (n$next$a196, n$next$a9, n$next$a194);
  or n$next$a197$g (n$next$a197, n$next$a9$not, n$next$a196);
  xor n$next$a198$g (n$next$a198, n$next$a9, n$next$a197);
  and n$next$a199$g (n$next$a199, n$next$a9, n$next$a197);
  or n$next$a200$g (n$next$a200, n$next$a9$not, n$next$a199);
  xor n$next$a201$g (n$next$a201, n$next$a9, n$next$a200);
  and n$next$a202$g (n$next$a202, n$next$a9, n$next$a200);
  or n$next$a203$g (n$next$a203, n$next$a9$not, n$next$a202);
  xor n$next$a204$g (n$next$a204, n$next$a9, n$next$a203);
  or n$next$a205$g (n$next$a205, n$q0, n$next$a10);
  or n$next$a206$g (n$next$a206, n$next$a205, n$next$a12);
  or n$next$a207$g (n$next$a207, n$next$a206, n$next$a15);
  or n$next$a208$g (n$next$a208, n$next$a207, n$next$a18);
  or n$next$a209$g (n$next$a209, n$next$a208, n$next$a21);
  or n$next$a210$g (n$next$a210, n$next$a209, n$next$a24);
  or n$next$a211$g (n$next$a211, n$next$a210, n$next$a27);
  or n$next$a212$g (n$next$a212, n$next$a211, n$next$a30);
  or n$next$a213$g (n$next$a213, n$next$a212, n$next$a33);
  or n$next$a214$g (n$next$a214, n$next$a213, n$next$a36);
  or n$next$a215$g (n$next$a215, n$next$a214, n$next$a39);
  or n$next$a216$g (n$next$a216, n$next$a215, n$next$a42);
  or n$next$a217$g (n$next$a217, n$next$a216, n$next$a45);
  or n$next$a218$g (n$next$a218, n$next$a217, n$next$a48);
  or n$next$a219$g (n$next$a219, n$next$a218, n$next$a51);
  or n$next$a220$g (n$next$a220, n$next$a219, n$next$a54);
  or n$next$a221$g (n$next$a221, n$next$a220, n$next$a57);
  or n$next$a222$g (n$next$a222, n$next$a221, n$next$a60);
  or n$next$a223$g (n$next$a223, n$next$a222, n$next$a63);
  or n$next$a224$g (n$next$a224, n$next$a223, n$next$a66);
  or n$next$a225$g (n$next$a225, n$next$a224, n$next$a69);
  or n$next$a226$g (n$next$a226, n$next$a225, n$next$a72);
  or n$next$a227$g (n$next$a227, n$next$a226, n$next$a75);
  or n$next$a228$g (n$next$a228, n$next$a227, n$next$a78);
  or n$next$a229$g (n$next$a229, n$next$a228, n$next$a81);
  or n$next$a230$g (n$next$a230, n$next$a229, n$next$a84);
  or n$next$a231$g (n$next$a231, n$next$a230, n$next$a87);
  or n$next$a232$g (n$next$a232, n$next$a231, n$next$a90);
  or n$next$a233$g (n$next$a233, n$next$a232, n$next$a93);
  or n$next$a234$g (n$next$a234, n$next$a233, n$next$a96);
  or n$next$a235$g (n$next$a235, n$next$a234, n$next$a99);
  or n$next$a236$g (n$next$a236, n$next$a235, n$next$a102);
  or n$next$a237$g (n$next$a237, n$next$a236, n$next$a105);
  or n$next$a238$g (n$next$a238, n$next$a237, n$next$a108);
  or n$next$a239$g (n$next$a239, n$next$a238, n$next$a111);
  or n$next$a240$g (n$next$a240, n$next$a239, n$next$a114);
  or n$next$a241$g (n$next$a241, n$next$a240, n$next$a117);
  or n$next$a242$g (n$next$a242, n$next$a241, n$next$a120);
  or n$next$a243$g (n$next$a243, n$next$a242, n$next$a123);
  or n$next$a244$g (n$next$a244, n$next$a243, n$next$a126);
  or n$next$a245$g (n$next$a245, n$next$a244, n$next$a129);
  or n$next$a246$g (n$next$a246, n$next$a245, n$next$a132);
  or n$next$a247$g (n$next$a247, n$next$a246, n$next$a135);
  or n$next$a248$g (n$next$a248, n$next$a247, n$next$a138);
  or n$next$a249$g (n$next$a249, n$next$a248, n$next$a141);
  or n$next$a250$g (n$next$a250, n$next$a249, n$next$a144);
  or n$next$a251$g (n$next$a251, n$next$a250, n$next$a147);
  or n$next$a252$g (n$next$a252, n$next$a251, n$next$a150);
  or n$next$a253$g (n$next$a253, n$next$a252, n$next$a153);
  or n$next$a254$g (n$next$a254, n$next$a253, n$next$a156);
  or n$next$a255$g (n$next$a255, n$next$a254, n$next$a159);
  or n$next$a256$g (n$next$a256, n$next$a255, n$next$a162);
  or n$next$a257$g (n$next$a257, n$next$a256, n$next$a165);
  or n$next$a258$g (n$next$a258, n$next$a257, n$next$a168);
  or n$next$a259$g (n$next$a259, n$next$a258, n$next$a171);
  or n$next$a260$g (n$next$a260, n$next$a259, n$next$a174);
  or n$next$a261$g (n$next$a261, n$next$a260, n$next$a177);
  or n$next$a262$g (n$next$a262, n$next$a261, n$next$a180);
  or n$next$a263$g (n$next$a263, n$next$a262, n$next$a183);
  or n$next$a264$g (n$next$a264, n$next$a263, n$next$a186);
  or n$next$a265$g (n$next$a265, n$next$a264, n$next$a189);
  or n$next$a266$g (n$next$a266, n$next$a265, n$next$a192);
  or n$next$a267$g (n$next$a267, n$next$a266, n$next$a195);
  or n$next$a268$g (n$next$a268, n$next$a267, n$next$a198);
  or n$next$a269$g (n$next$a269, n$next$a268, n$next$a201);
  or n$next$a270$g (n$next$a270, n$next$a269, n$next$a204);
  not n$next$a270$not$g (n$next$a270$not, n$next$a270);
  or n$next$a271$g (n$next$a271, n$next$a204, n$next$a270$not);
  not n$next$a271$not$g (n$next$a271$not, n$next$a271);
  and n$next$a272$g (n$next$a272, n$next$a271, n$q0$not);
  or n$next$a273$g (n$next$a273, n$next$a271$not, n$next$a272);
  and n$next$a274$g (n$next$a274, n$next$a271, n$next$a4);
  or n$next$a275$g (n$next$a275, n$next$a271$not, n$next$a274);
  and n$next$a276$g (n$next$a276, n$next$a271, n$next$a7);
  and n$next$a277$g (n$next$a277, n$next$a9, n$next$a273);
  and n$next$a278$g (n$next$a278, n$next$a9, n$next$a275);
  and n$next$a279$g (n$next$a279, n$next$a9, n$next$a276);
  and n$next$a280$g (n$next$a280, n$when1, n$next$a277);
  not n$when1$not$g (n$when1$not, n$when1);
  and n$next$a281$g (n$next$a281, n$when1$not, n$q0);
  or n$next$a282$g (n$next$a282, n$next$a280, n$next$a281);
  and n$next$a283$g (n$next$a283, n$when1, n$next$a278);
  and n$next$a284$g (n$next$a284, n$when1$not, n$q1);
  or n$next$a285$g (n$next$a285, n$next$a283, n$next$a284);
  and n$next$a286$g (n$next$a286, n$when1, n$next$a279);
  grafwire_dff #(.INIT(1'b0)) n$q0$g (.d(n$next$a282), .c(clk), .q(n$q0));
  grafwire_dff #(.INIT(1'b0)) n$q1$g (.d(n$next$a285), .c(clk), .q(n$q1));

  // timer$0
  grafwire_scan_timer #(.RISE_PS(64'd1500000000000), .FALL_PS(64'd20000000000), .SCAN_PS(SCAN_PS), .INIT(1'b0)) timer$0$g (.a(top), .c(clk), .q(timer$0));  // 1.5s, 20ms

  // UP = X11./top./AUdoux
  not top$not$g (top$not, top);
  not AUdoux$not$g (AUdoux$not, AUdoux);
  and UP$1$g (UP$1, X11, top$not, AUdoux$not);
  buf UP$g (UP, UP$1);

  // blow = X12./AUdoux
  and blow$1$g (blow$1, X12, AUdoux$not);
  buf blow$g (blow, blow$1);

  // lamp = X1./AUdoux
  and lamp$1$g (lamp$1, X1, AUdoux$not);
  buf lamp$g (lamp, lamp$1);
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
