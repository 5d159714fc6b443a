// level_crossing "Passage à niveau" (level-crossing.grafcet): 1316 cells.
// Style clocked, CDX by transitions, with Init, AUdur and AUdoux.
// Written by grafwire 0.2.0:
//   grafwire netlist level-crossing.grafcet --style clocked --cdx transition --modes on --to verilog --scan 10ms
// Inner nets are called OWNER$ROLE (N: a number, T: a transition):
//   $N        a gate of a condition of the owner
//   $aN       a gate of the arithmetic that works out a value
//   $clear    of a transition: it is cleared; of a step: Init deactivates it
//   edge$N    edge N of the chart, counted from 0
//   $evolved  the step after the transitions, before any order
//   $high     always 1
//   $hold     keeps the owner as it is
//   $low      always 0
//   $memory   the operand of the edge, a scan ago
//   $next     the owner as it is from the next clock on
//   $not      the owner inverted
//   $qN       bit N of the counter
//   $running  1 from the second scan on
//   timer$N   time condition N of the chart, counted from 0
//   $whenN    something is written to the owner
//   \KM%20down = KM down
//   \KM%20up = KM up
`timescale 1ns/1ps

module level_crossing #(parameter [63:0] SCAN_PS = 64'd10000000000) (
  input approach,
  input leave,
  input test,
  input up,
  input down,
  input obstacle,
  input Init,
  input AUdur,
  input AUdoux,
  input clk,
  output X0,
  output X10,
  output X11,
  output X12,
  output X13,
  output X14,
  output X15,
  output X16,
  output X17,
  output X20,
  output X21,
  output X22,
  output X23,
  output X30,
  output X31,
  output X32,
  output red,
  output bell,
  output \KM%20down ,
  output \KM%20up ,
  output left,
  output right
);
  wire Init$not, AUdur$not, \$low ;
  wire \$high , edges$running, edge$0$memory, edge$0$memory$not, edge$0, edge$1$memory, edge$1$memory$not, edge$1, edge$2$memory, edge$2$memory$not, edge$2;
  wire edge$1$not, T0$1, T0$clear;
  wire edge$0$not, T1$1, T1$clear;
  wire trains$q0$not, T10$1$a1, trains$q1$not, T10$1$a2, T10$1$a3, T10$1$a4, T10$1$a4$not, T10$1$a5, T10$1$a6, T10$1$a7, T10$1$a8, T10$1$a9, T10$1$a9$not, T10$1$a10, T10$1$a10$not, T10$2, T10$clear;
  wire T11$clear;
  wire T12$clear;
  wire down$not, T13$1, T13$clear;
  wire T14$clear;
  wire obstacle$not, T15$1, T15$clear;
  wire T16$1$a1, T16$1$a2, T16$1$a3, T16$1$a4, T16$1$a4$not, T16$1$a5, T16$1$a6, T16$1$a7, T16$1$a8, T16$1$a9, T16$1$a9$not, T16$clear;
  wire T17$1, T17$clear;
  wire T18$clear;
  wire T20$clear;
  wire T21$clear;
  wire X17$not, T22$1, T22$clear;
  wire T23$1, T23$clear;
  wire T24$clear;
  wire T30$clear;
  wire T31$clear;
  wire T32$clear;
  wire T0$clear$not, T1$clear$not, X0$hold, X0$evolved, X0$next;
  wire T10$clear$not, X10$hold, X10$evolved, X10$next;
  wire T11$clear$not, X11$hold, X11$evolved, X11$next;
  wire T12$clear$not, T13$clear$not, X12$hold, X12$evolved, X12$next;
  wire T16$clear$not, X13$hold, X13$evolved, X13$next;
  wire T14$clear$not, X14$hold, X14$evolved, X14$next;
  wire T15$clear$not, X15$hold, X15$evolved, X15$next;
  wire T17$clear$not, T18$clear$not, X16$hold, X16$evolved, X16$next;
  wire T24$clear$not, X17$hold, X17$evolved, X17$next;
  wire T20$clear$not, X20$hold, X20$evolved, X20$next;
  wire T21$clear$not, X21$hold, X21$evolved, X21$next;
  wire T22$clear$not, T23$clear$not, X22$hold, X22$evolved, X22$next;
  wire X23$hold, X23$evolved, X23$next;
  wire T30$clear$not, X30$hold, X30$evolved, X30$next;
  wire T31$clear$not, X31$hold, X31$evolved, X31$next;
  wire T32$clear$not, X32$hold, X32$evolved, X32$next;
  wire red$next$a1, red$next$a2, red$next$a3;
  wire trains$next$a1, trains$next$a2, trains$next$a3, trains$next$a1$not, trains$next$a4, trains$next$a5, trains$next$a6, trains$next$a2$not, trains$next$a7, trains$next$a8, trains$next$a9, trains$next$a9$not, trains$next$a10, trains$next$a11, trains$next$a7$not, trains$next$a12, trains$next$a13, trains$next$a14, trains$next$a15, trains$next$a16, trains$next$a17, trains$next$a18, trains$next$a19, trains$next$a20, trains$next$a21, trains$next$a22, trains$next$a23, trains$next$a24, trains$next$a25, trains$next$a26, trains$next$a27, trains$next$a28, trains$next$a29, trains$next$a30, trains$next$a31, trains$next$a32, trains$next$a33, trains$next$a34, trains$next$a35, trains$next$a36, trains$next$a37, trains$next$a38, trains$next$a39, trains$next$a40, trains$next$a41, trains$next$a42, trains$next$a43, trains$next$a44, trains$next$a45, trains$next$a46, trains$next$a47, trains$next$a48, trains$next$a49, trains$next$a50, trains$next$a51, trains$next$a52, trains$next$a53, trains$next$a54, trains$next$a55, trains$next$a56, trains$next$a57, trains$next$a58, trains$next$a59, trains$next$a60, trains$next$a61, trains$next$a62, trains$next$a63, trains$next$a64, trains$next$a65, trains$next$a66, trains$next$a67, trains$next$a68, trains$next$a69, trains$next$a70, trains$next$a71, trains$next$a72, trains$next$a73, trains$next$a74, trains$next$a75, trains$next$a76, trains$next$a77, trains$next$a78, trains$next$a79, trains$next$a80, trains$next$a81, trains$next$a82, trains$next$a83, trains$next$a84, trains$next$a85, trains$next$a86, trains$next$a87, trains$next$a88, trains$next$a89, trains$next$a90, trains$next$a91, trains$next$a92, trains$next$a93, trains$next$a94, trains$next$a95, trains$next$a96, trains$next$a97, trains$next$a98, trains$next$a99, trains$next$a100, trains$next$a101, trains$next$a102, trains$next$a103, trains$next$a104, trains$next$a105, trains$next$a106, trains$next$a107, trains$next$a108, trains$next$a109, trains$next$a110, trains$next$a111, trains$next$a112, trains$next$a113, trains$next$a114, trains$next$a115, trains$next$a116, trains$next$a117, trains$next$a118, trains$next$a119, trains$next$a120, trains$next$a121, trains$next$a122, trains$next$a123, trains$next$a124, trains$next$a125, trains$next$a126, trains$next$a127, trains$next$a128, trains$next$a129, trains$next$a130, trains$next$a131, trains$next$a132, trains$next$a133, trains$next$a134, trains$next$a135, trains$next$a136, trains$next$a137, trains$next$a138, trains$next$a139, trains$next$a140, trains$next$a141, trains$next$a142, trains$next$a143, trains$next$a144, trains$next$a145, trains$next$a146, trains$next$a147, trains$next$a148, trains$next$a149, trains$next$a150, trains$next$a151, trains$next$a152, trains$next$a153, trains$next$a154, trains$next$a155, trains$next$a156, trains$next$a157, trains$next$a158, trains$next$a159, trains$next$a160, trains$next$a161, trains$next$a162, trains$next$a163, trains$next$a164, trains$next$a165, trains$next$a166, trains$next$a167, trains$next$a168, trains$next$a169, trains$next$a170, trains$next$a171, trains$next$a172, trains$next$a173, trains$next$a174, trains$next$a175, trains$next$a176, trains$next$a177, trains$next$a178, trains$next$a179, trains$next$a180, trains$next$a181, trains$next$a182, trains$next$a183, trains$next$a184, trains$next$a185, trains$next$a186, trains$next$a187, trains$next$a188, trains$next$a189, trains$next$a190, trains$next$a191, trains$next$a192, trains$next$a193, trains$next$a194, trains$next$a195, trains$next$a196, trains$next$a197, trains$next$a198, trains$next$a199, trains$next$a200, trains$next$a201, trains$next$a202, trains$next$a203, trains$next$a204, trains$next$a205, trains$next$a206, trains$next$a207, trains$next$a208, trains$next$a209, trains$next$a210, trains$next$a211, trains$next$a212, trains$next$a213, trains$next$a214, trains$next$a215, trains$next$a216, trains$next$a217, trains$next$a218, trains$next$a219, trains$next$a220, trains$next$a221, trains$next$a222, trains$next$a223, trains$next$a224, trains$next$a225, trains$next$a226, trains$next$a227, trains$next$a228, trains$next$a229, trains$next$a230, trains$next$a231, trains$next$a232, trains$next$a233, trains$next$a234, trains$next$a235, trains$next$a236, trains$next$a237, trains$next$a238, trains$next$a239, trains$next$a240, trains$next$a241, trains$next$a242, trains$next$a243, trains$next$a244, trains$next$a245, trains$next$a246, trains$next$a247, trains$next$a248, trains$next$a249, trains$next$a250, trains$next$a251, trains$next$a252, trains$next$a253, trains$next$a254, trains$next$a255, trains$next$a256, trains$next$a257, trains$next$a258, trains$next$a259, trains$next$a260, trains$next$a261, trains$next$a262, trains$next$a263, trains$next$a264, trains$next$a265, trains$next$a266, trains$next$a267, trains$next$a268, trains$next$a269, trains$next$a270, trains$next$a270$not, trains$next$a271, trains$next$a271$not, trains$next$a272, trains$next$a273, trains$next$a274, trains$next$a275, trains$next$a276, trains$next$a277, trains$next$a278, trains$next$a279, trains$next$a280, trains$next$a281, trains$next$a282, trains$next$a283, trains$next$a284, trains$next$a285, trains$next$a286, trains$next$a287, trains$next$a288, trains$next$a289, trains$next$a289$not, trains$next$a290, trains$next$a287$not, trains$next$a291, trains$next$a292, trains$next$a293, trains$next$a294, trains$next$a295, trains$next$a296, trains$next$a297, trains$next$a298, trains$next$a299, trains$next$a300, trains$next$a301, trains$next$a302, trains$next$a303, trains$next$a304, trains$next$a305, trains$next$a306, trains$next$a307, trains$next$a308, trains$next$a309, trains$next$a310, trains$next$a311, trains$next$a312, trains$next$a313, trains$next$a314, trains$next$a315, trains$next$a316, trains$next$a317, trains$next$a318, trains$next$a319, trains$next$a320, trains$next$a321, trains$next$a322, trains$next$a323, trains$next$a324, trains$next$a325, trains$next$a326, trains$next$a327, trains$next$a328, trains$next$a329, trains$next$a330, trains$next$a331, trains$next$a332, trains$next$a333, trains$next$a334, trains$next$a335, trains$next$a336, trains$next$a337, trains$next$a338, trains$next$a339, trains$next$a340, trains$next$a341, trains$next$a342, trains$next$a343, trains$next$a344, trains$next$a345, trains$next$a346, trains$next$a347, trains$next$a348, trains$next$a349, trains$next$a350, trains$next$a351, trains$next$a352, trains$next$a353, trains$next$a354, trains$next$a355, trains$next$a356, trains$next$a357, trains$next$a358, trains$next$a359, trains$next$a360, trains$next$a361, trains$next$a362, trains$next$a363, trains$next$a364, trains$next$a365, trains$next$a366, trains$next$a367, trains$next$a368, trains$next$a369, trains$next$a370, trains$next$a371, trains$next$a372, trains$next$a373, trains$next$a374, trains$next$a375, trains$next$a376, trains$next$a377, trains$next$a378, trains$next$a379, trains$next$a380, trains$next$a381, trains$next$a382, trains$next$a383, trains$next$a384, trains$next$a385, trains$next$a386, trains$next$a387, trains$next$a388, trains$next$a389, trains$next$a390, trains$next$a391, trains$next$a392, trains$next$a393, trains$next$a394, trains$next$a395, trains$next$a396, trains$next$a397, trains$next$a398, trains$next$a399, trains$next$a400, trains$next$a401, trains$next$a402, trains$next$a403, trains$next$a404, trains$next$a405, trains$next$a406, trains$next$a407, trains$next$a408, trains$next$a409, trains$next$a410, trains$next$a411, trains$next$a412, trains$next$a413, trains$next$a414, trains$next$a415, trains$next$a416, trains$next$a417, trains$next$a418, trains$next$a419, trains$next$a420, trains$next$a421, trains$next$a422, trains$next$a423, trains$next$a424, trains$next$a425, trains$next$a426, trains$next$a427, trains$next$a428, trains$next$a429, trains$next$a430, trains$next$a431, trains$next$a432, trains$next$a433, trains$next$a434, trains$next$a435, trains$next$a436, trains$next$a437, trains$next$a438, trains$next$a439, trains$next$a440, trains$next$a441, trains$next$a442, trains$next$a443, trains$next$a444, trains$next$a445, trains$next$a446, trains$next$a447, trains$next$a448, trains$next$a449, trains$next$a450, trains$next$a451, trains$next$a452, trains$next$a453, trains$next$a454, trains$next$a455, trains$next$a456, trains$next$a457, trains$next$a458, trains$next$a459, trains$next$a460, trains$next$a461, trains$next$a462, trains$next$a463, trains$next$a464, trains$next$a465, trains$next$a466, trains$next$a467, trains$next$a468, trains$next$a469, trains$next$a470, trains$next$a471, trains$next$a472, trains$next$a473, trains$next$a474, trains$next$a475, trains$next$a476, trains$next$a477, trains$next$a478, trains$next$a479, trains$next$a480, trains$next$a481, trains$next$a482, trains$next$a483, trains$next$a484, trains$next$a485, trains$next$a294$not, trains$next$a486, trains$next$a487, trains$next$a488, trains$next$a297$not, trains$next$a489, trains$next$a490, trains$next$a491, trains$next$a300$not, trains$next$a492, trains$next$a493, trains$next$a494, trains$next$a303$not, trains$next$a495, trains$next$a496, trains$next$a497, trains$next$a306$not, trains$next$a498, trains$next$a499, trains$next$a500, trains$next$a309$not, trains$next$a501, trains$next$a502, trains$next$a503, trains$next$a312$not, trains$next$a504, trains$next$a505, trains$next$a506, trains$next$a315$not, trains$next$a507, trains$next$a508, trains$next$a509, trains$next$a318$not, trains$next$a510, trains$next$a511, trains$next$a512, trains$next$a321$not, trains$next$a513, trains$next$a514, trains$next$a515, trains$next$a324$not, trains$next$a516, trains$next$a517, trains$next$a518, trains$next$a327$not, trains$next$a519, trains$next$a520, trains$next$a521, trains$next$a330$not, trains$next$a522, trains$next$a523, trains$next$a524, trains$next$a333$not, trains$next$a525, trains$next$a526, trains$next$a527, trains$next$a336$not, trains$next$a528, trains$next$a529, trains$next$a530, trains$next$a339$not, trains$next$a531, trains$next$a532, trains$next$a533, trains$next$a342$not, trains$next$a534, trains$next$a535, trains$next$a536, trains$next$a345$not, trains$next$a537, trains$next$a538, trains$next$a539, trains$next$a348$not, trains$next$a540, trains$next$a541, trains$next$a542, trains$next$a351$not, trains$next$a543, trains$next$a544, trains$next$a545, trains$next$a354$not, trains$next$a546, trains$next$a547, trains$next$a548, trains$next$a357$not, trains$next$a549, trains$next$a550, trains$next$a551, trains$next$a360$not, trains$next$a552, trains$next$a553, trains$next$a554, trains$next$a363$not, trains$next$a555, trains$next$a556, trains$next$a557, trains$next$a366$not, trains$next$a558, trains$next$a559, trains$next$a560, trains$next$a369$not, trains$next$a561, trains$next$a562, trains$next$a563, trains$next$a372$not, trains$next$a564, trains$next$a565, trains$next$a566, trains$next$a375$not, trains$next$a567, trains$next$a568, trains$next$a569, trains$next$a378$not, trains$next$a570, trains$next$a571, trains$next$a572, trains$next$a381$not, trains$next$a573, trains$next$a574, trains$next$a575, trains$next$a384$not, trains$next$a576, trains$next$a577, trains$next$a578, trains$next$a387$not, trains$next$a579, trains$next$a580, trains$next$a581, trains$next$a390$not, trains$next$a582, trains$next$a583, trains$next$a584, trains$next$a393$not, trains$next$a585, trains$next$a586, trains$next$a587, trains$next$a396$not, trains$next$a588, trains$next$a589, trains$next$a590, trains$next$a399$not, trains$next$a591, trains$next$a592, trains$next$a593, trains$next$a402$not, trains$next$a594, trains$next$a595, trains$next$a596, trains$next$a405$not, trains$next$a597, trains$next$a598, trains$next$a599, trains$next$a408$not, trains$next$a600, trains$next$a601, trains$next$a602, trains$next$a411$not, trains$next$a603, trains$next$a604, trains$next$a605, trains$next$a414$not, trains$next$a606, trains$next$a607, trains$next$a608, trains$next$a417$not, trains$next$a609, trains$next$a610, trains$next$a611, trains$next$a420$not, trains$next$a612, trains$next$a613, trains$next$a614, trains$next$a423$not, trains$next$a615, trains$next$a616, trains$next$a617, trains$next$a426$not, trains$next$a618, trains$next$a619, trains$next$a620, trains$next$a429$not, trains$next$a621, trains$next$a622, trains$next$a623, trains$next$a432$not, trains$next$a624, trains$next$a625, trains$next$a626, trains$next$a435$not, trains$next$a627, trains$next$a628, trains$next$a629, trains$next$a438$not, trains$next$a630, trains$next$a631, trains$next$a632, trains$next$a441$not, trains$next$a633, trains$next$a634, trains$next$a635, trains$next$a444$not, trains$next$a636, trains$next$a637, trains$next$a638, trains$next$a447$not, trains$next$a639, trains$next$a640, trains$next$a641, trains$next$a450$not, trains$next$a642, trains$next$a643, trains$next$a644, trains$next$a453$not, trains$next$a645, trains$next$a646, trains$next$a647, trains$next$a456$not, trains$next$a648, trains$next$a649, trains$next$a650, trains$next$a459$not, trains$next$a651, trains$next$a652, trains$next$a653, trains$next$a462$not, trains$next$a654, trains$next$a655, trains$next$a656, trains$next$a465$not, trains$next$a657, trains$next$a658, trains$next$a659, trains$next$a468$not, trains$next$a660, trains$next$a661, trains$next$a662, trains$next$a471$not, trains$next$a663, trains$next$a664, trains$next$a665, trains$next$a474$not, trains$next$a666, trains$next$a667, trains$next$a668, trains$next$a477$not, trains$next$a669, trains$next$a670, trains$next$a671, trains$next$a480$not, trains$next$a672, trains$next$a673, trains$next$a674, trains$next$a483$not, trains$next$a675, trains$next$a676, trains$next$a677, trains$next$a678, trains$next$a679, trains$next$a680, trains$next$a681, trains$next$a682, trains$next$a683, trains$next$a684, trains$next$a685, trains$next$a686, trains$next$a687, trains$next$a688, trains$next$a689, trains$next$a690, trains$next$a691, trains$next$a692, trains$next$a693, trains$next$a694, trains$next$a695, trains$next$a696, trains$next$a697, trains$next$a698, trains$next$a699, trains$next$a700, trains$next$a701, trains$next$a702, trains$next$a703, trains$next$a704, trains$next$a705, trains$next$a706, trains$next$a707, trains$next$a708, trains$next$a709, trains$next$a710, trains$next$a711, trains$next$a712, trains$next$a713, trains$next$a714, trains$next$a715, trains$next$a716, trains$next$a717, trains$next$a718, trains$next$a719, trains$next$a720, trains$next$a721, trains$next$a722, trains$next$a723, trains$next$a724, trains$next$a725, trains$next$a726, trains$next$a727, trains$next$a728, trains$next$a729, trains$next$a730, trains$next$a731, trains$next$a732, trains$next$a733, trains$next$a734, trains$next$a735, trains$next$a736, trains$next$a737, trains$next$a738, trains$next$a739, trains$next$a740, trains$next$a741, trains$next$a742, trains$next$a743, trains$next$a744, trains$next$a744$not, trains$next$a745, trains$next$a745$not, trains$next$a746, trains$next$a747, trains$next$a748, trains$next$a749, trains$next$a750, trains$next$a751, trains$next$a752, trains$next$a753, trains$next$a754, trains$next$a755, trains$next$a756, trains$next$a757, trains$next$a758, trains$next$a759, trains$next$a760, trains$next$a761, trains$next$a762, trains$q0, trains$q1;
  wire X14$not, hindrances$when1, hindrances$q0$not, hindrances$next$a1, hindrances$next$a2, hindrances$next$a3, hindrances$next$a1$not, hindrances$next$a4, hindrances$next$a5, hindrances$next$a6, hindrances$next$a2$not, hindrances$next$a7, hindrances$next$a8, hindrances$next$a9, hindrances$next$a9$not, hindrances$next$a10, hindrances$next$a11, hindrances$next$a12, hindrances$next$a7$not, hindrances$next$a13, hindrances$next$a14, hindrances$next$a15, hindrances$next$a16, hindrances$next$a17, hindrances$next$a18, hindrances$next$a19, hindrances$next$a20, hindrances$next$a21, hindrances$next$a22, hindrances$next$a23, hindrances$next$a24, hindrances$next$a25, hindrances$next$a26, hindrances$next$a27, hindrances$next$a28, hindrances$next$a29, hindrances$next$a30, hindrances$next$a31, hindrances$next$a32, hindrances$next$a33, hindrances$next$a34, hindrances$next$a35, hindrances$next$a36, hindrances$next$a37, hindrances$next$a38, hindrances$next$a39, hindrances$next$a40, hindrances$next$a41, hindrances$next$a42, hindrances$next$a43, hindrances$next$a44, hindrances$next$a45, hindrances$next$a46, hindrances$next$a47, hindrances$next$a48, hindrances$next$a49, hindrances$next$a50, hindrances$next$a51, hindrances$next$a52, hindrances$next$a53, hindrances$next$a54, hindrances$next$a55, hindrances$next$a56, hindrances$next$a57, hindrances$next$a58, hindrances$next$a59, hindrances$next$a60, hindrances$next$a61, hindrances$next$a62, hindrances$next$a63, hindrances$next$a64, hindrances$next$a65, hindrances$next$a66, hindrances$next$a67, hindrances$next$a68, hindrances$next$a69, hindrances$next$a70, hindrances$next$a71, hindrances$next$a72, hindrances$next$a73, hindrances$next$a74, hindrances$next$a75, hindrances$next$a76, hindrances$next$a77, hindrances$next$a78, hindrances$next$a79, hindrances$next$a80, hindrances$next$a81, hindrances$next$a82, hindrances$next$a83, hindrances$next$a84, hindrances$next$a85, hindrances$next$a86, hindrances$next$a87, hindrances$next$a88, hindrances$next$a89, hindrances$next$a90, hindrances$next$a91, hindrances$next$a92, hindrances$next$a93, hindrances$next$a94, hindrances$next$a95, hindrances$next$a96, hindrances$next$a97, hindrances$next$a98, hindrances$next$a99, hindrances$next$a100, hindrances$next$a101, hindrances$next$a102, hindrances$next$a103, hindrances$next$a104, hindrances$next$a105, hindrances$next$a106, hindrances$next$a107, hindrances$next$a108, hindrances$next$a109, hindrances$next$a110, hindrances$next$a111, hindrances$next$a112, hindrances$next$a113, hindrances$next$a114, hindrances$next$a115, hindrances$next$a116, hindrances$next$a117, hindrances$next$a118, hindrances$next$a119, hindrances$next$a120, hindrances$next$a121, hindrances$next$a122, hindrances$next$a123, hindrances$next$a124, hindrances$next$a125, hindrances$next$a126, hindrances$next$a127, hindrances$next$a128, hindrances$next$a129, hindrances$next$a130, hindrances$next$a131, hindrances$next$a132, hindrances$next$a133, hindrances$next$a134, hindrances$next$a135, hindrances$next$a136, hindrances$next$a137, hindrances$next$a138, hindrances$next$a139, hindrances$next$a140, hindrances$next$a141, hindrances$next$a142, hindrances$next$a143, hindrances$next$a144, hindrances$next$a145, hindrances$next$a146, hindrances$next$a147, hindrances$next$a148, hindrances$next$a149, hindrances$next$a150, hindrances$next$a151, hindrances$next$a152, hindrances$next$a153, hindrances$next$a154, hindrances$next$a155, hindrances$next$a156, hindrances$next$a157, hindrances$next$a158, hindrances$next$a159, hindrances$next$a160, hindrances$next$a161, hindrances$next$a162, hindrances$next$a163, hindrances$next$a164, hindrances$next$a165, hindrances$next$a166, hindrances$next$a167, hindrances$next$a168, hindrances$next$a169, hindrances$next$a170, hindrances$next$a171, hindrances$next$a172, hindrances$next$a173, hindrances$next$a174, hindrances$next$a175, hindrances$next$a176, hindrances$next$a177, hindrances$next$a178, hindrances$next$a179, hindrances$next$a180, hindrances$next$a181, hindrances$next$a182, hindrances$next$a183, hindrances$next$a184, hindrances$next$a185, hindrances$next$a186, hindrances$next$a187, hindrances$next$a188, hindrances$next$a189, hindrances$next$a190, hindrances$next$a191, hindrances$next$a192, hindrances$next$a193, hindrances$next$a194, hindrances$next$a195, hindrances$next$a196, hindrances$next$a197, hindrances$next$a198, hindrances$next$a199, hindrances$next$a200, hindrances$next$a201, hindrances$next$a202, hindrances$next$a203, hindrances$next$a204, hindrances$next$a205, hindrances$next$a206, hindrances$next$a207, hindrances$next$a208, hindrances$next$a209, hindrances$next$a210, hindrances$next$a211, hindrances$next$a212, hindrances$next$a213, hindrances$next$a214, hindrances$next$a215, hindrances$next$a216, hindrances$next$a217, hindrances$next$a218, hindrances$next$a219, hindrances$next$a220, hindrances$next$a221, hindrances$next$a222, hindrances$next$a223, hindrances$next$a224, hindrances$next$a225, hindrances$next$a226, hindrances$next$a227, hindrances$next$a228, hindrances$next$a229, hindrances$next$a230, hindrances$next$a231, hindrances$next$a232, hindrances$next$a233, hindrances$next$a234, hindrances$next$a235, hindrances$next$a236, hindrances$next$a237, hindrances$next$a238, hindrances$next$a239, hindrances$next$a240, hindrances$next$a241, hindrances$next$a242, hindrances$next$a243, hindrances$next$a244, hindrances$next$a245, hindrances$next$a246, hindrances$next$a247, hindrances$next$a248, hindrances$next$a249, hindrances$next$a250, hindrances$next$a251, hindrances$next$a252, hindrances$next$a253, hindrances$next$a254, hindrances$next$a255, hindrances$next$a256, hindrances$next$a257, hindrances$next$a258, hindrances$next$a259, hindrances$next$a260, hindrances$next$a261, hindrances$next$a262, hindrances$next$a263, hindrances$next$a264, hindrances$next$a265, hindrances$next$a266, hindrances$next$a267, hindrances$next$a268, hindrances$next$a269, hindrances$next$a270, hindrances$next$a271, hindrances$next$a271$not, hindrances$next$a272, hindrances$next$a272$not, hindrances$next$a273, hindrances$next$a274, hindrances$next$a275, hindrances$next$a276, hindrances$next$a277, hindrances$next$a278, hindrances$next$a279, hindrances$next$a280, hindrances$when1$not, hindrances$next$a281, hindrances$next$a282, hindrances$next$a283, hindrances$next$a284, hindrances$next$a285, hindrances$next$a286, hindrances$q0, hindrances$q1;
  wire timer$0;
  wire timer$1;
  wire timer$2;
  wire timer$3;
  wire timer$4;
  wire timer$5;
  wire timer$0$not, bell$1, bell$2, AUdoux$not, bell$3;
  wire \KM%20down$1 ;
  wire \KM%20up$1 , \KM%20up$2 ;
  wire left$1;
  wire right$1;

  // inputs
  not Init$not$g (Init$not, Init);
  not AUdur$not$g (AUdur$not, AUdur);
  assign \$low  = 1'b0;

  // edges
  assign \$high  = 1'b1;
  grafwire_dff #(.INIT(1'b0)) edges$running$g (.d(\$high ), .c(clk), .q(edges$running));
  grafwire_dff #(.INIT(1'b0)) edge$0$memory$g (.d(approach), .c(clk), .q(edge$0$memory));
  not edge$0$memory$not$g (edge$0$memory$not, edge$0$memory);
  and edge$0$g (edge$0, approach, edge$0$memory$not, edges$running);
  grafwire_dff #(.INIT(1'b0)) edge$1$memory$g (.d(leave), .c(clk), .q(edge$1$memory));
  not edge$1$memory$not$g (edge$1$memory$not, edge$1$memory);
  and edge$1$g (edge$1, leave, edge$1$memory$not, edges$running);
  grafwire_dff #(.INIT(1'b0)) edge$2$memory$g (.d(test), .c(clk), .q(edge$2$memory));
  not edge$2$memory$not$g (edge$2$memory$not, edge$2$memory);
  and edge$2$g (edge$2, test, edge$2$memory$not, edges$running);

  // T0
  not edge$1$not$g (edge$1$not, edge$1);
  and T0$1$g (T0$1, edge$0, edge$1$not);
  and T0$clear$g (T0$clear, X0, T0$1, Init$not);

  // T1
  not edge$0$not$g (edge$0$not, edge$0);
  and T1$1$g (T1$1, edge$1, edge$0$not);
  and T1$clear$g (T1$clear, X0, T1$1, Init$not);

  // T10
  not trains$q0$not$g (trains$q0$not, trains$q0);
  or T10$1$a1$g (T10$1$a1, trains$q0, trains$q0$not);
  not trains$q1$not$g (trains$q1$not, trains$q1);
  xor T10$1$a2$g (T10$1$a2, trains$q1$not, T10$1$a1);
  and T10$1$a3$g (T10$1$a3, trains$q1$not, T10$1$a1);
  or T10$1$a4$g (T10$1$a4, trains$q1, T10$1$a3);
  not T10$1$a4$not$g (T10$1$a4$not, T10$1$a4);
  or T10$1$a5$g (T10$1$a5, trains$q0, T10$1$a2);
  or T10$1$a6$g (T10$1$a6, T10$1$a5, T10$1$a4$not);
  or T10$1$a7$g (T10$1$a7, T10$1$a6, T10$1$a4$not);
  or T10$1$a8$g (T10$1$a8, T10$1$a7, T10$1$a4$not);
  or T10$1$a9$g (T10$1$a9, T10$1$a8, T10$1$a4$not);
  not T10$1$a9$not$g (T10$1$a9$not, T10$1$a9);
  or T10$1$a10$g (T10$1$a10, T10$1$a4$not, T10$1$a9$not);
  not T10$1$a10$not$g (T10$1$a10$not, T10$1$a10);
  or T10$2$g (T10$2, T10$1$a10$not, edge$2);
  and T10$clear$g (T10$clear, X10, T10$2, Init$not);

  // T11
  and T11$clear$g (T11$clear, X11, timer$1, Init$not);

  // T12
  and T12$clear$g (T12$clear, X12, down, Init$not);

  // T13
  not down$not$g (down$not, down);
  and T13$1$g (T13$1, obstacle, down$not);
  and T13$clear$g (T13$clear, X12, T13$1, Init$not);

  // T14
  and T14$clear$g (T14$clear, X14, up, Init$not);

  // T15
  not obstacle$not$g (obstacle$not, obstacle);
  and T15$1$g (T15$1, timer$2, obstacle$not);
  and T15$clear$g (T15$clear, X15, T15$1, Init$not);

  // T16
  or T16$1$a1$g (T16$1$a1, trains$q0, trains$q0$not);
  xor T16$1$a2$g (T16$1$a2, trains$q1$not, T16$1$a1);
  and T16$1$a3$g (T16$1$a3, trains$q1$not, T16$1$a1);
  or T16$1$a4$g (T16$1$a4, trains$q1, T16$1$a3);
  not T16$1$a4$not$g (T16$1$a4$not, T16$1$a4);
  or T16$1$a5$g (T16$1$a5, trains$q0, T16$1$a2);
  or T16$1$a6$g (T16$1$a6, T16$1$a5, T16$1$a4$not);
  or T16$1$a7$g (T16$1$a7, T16$1$a6, T16$1$a4$not);
  or T16$1$a8$g (T16$1$a8, T16$1$a7, T16$1$a4$not);
  or T16$1$a9$g (T16$1$a9, T16$1$a8, T16$1$a4$not);
  not T16$1$a9$not$g (T16$1$a9$not, T16$1$a9);
  and T16$clear$g (T16$clear, X13, T16$1$a9$not, Init$not);

  // T17
  and T17$1$g (T17$1, up, T16$1$a9$not);
  and T17$clear$g (T17$clear, X16, T17$1, Init$not);

  // T18
  and T18$clear$g (T18$clear, X16, T10$1$a10$not, Init$not);

  // T20
  and T20$clear$g (T20$clear, X20, timer$3, Init$not);

  // T21
  and T21$clear$g (T21$clear, X21, timer$4, Init$not);

  // T22
  not X17$not$g (X17$not, X17);
  and T22$1$g (T22$1, timer$5, X17$not);
  and T22$clear$g (T22$clear, X22, T22$1, Init$not);

  // T23
  and T23$1$g (T23$1, timer$5, X17);
  and T23$clear$g (T23$clear, X22, T23$1, Init$not);

  // T24
  and T24$clear$g (T24$clear, X17, X23, Init$not);

  // T30
  and T30$clear$g (T30$clear, X30, X11, Init$not);

  // T31
  and T31$clear$g (T31$clear, X31, X17, Init$not);

  // T32
  and T32$clear$g (T32$clear, X32, X10, Init$not);

  // X0 = (X0.↑approach./↑leave + X0.↑leave./↑approach + /(X0.↑approach./↑leave + X0.↑leave./↑approach).X0 + Init)./AUdur
  not T0$clear$not$g (T0$clear$not, T0$clear);
  not T1$clear$not$g (T1$clear$not, T1$clear);
  and X0$hold$g (X0$hold, X0, T0$clear$not, T1$clear$not);
  or X0$evolved$g (X0$evolved, T0$clear, T1$clear, X0$hold, Init);
  and X0$next$g (X0$next, X0$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b1)) X0$g (.d(X0$next), .c(clk), .q(X0));

  // X10 = (X17.X23 + /(X10.([trains > 0] + ↑test)).X10 + Init)./AUdur
  not T10$clear$not$g (T10$clear$not, T10$clear);
  and X10$hold$g (X10$hold, X10, T10$clear$not);
  or X10$evolved$g (X10$evolved, T24$clear, X10$hold, Init);
  and X10$next$g (X10$next, X10$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b1)) X10$g (.d(X10$next), .c(clk), .q(X10));

  // X11 = (X10.([trains > 0] + ↑test) + /(X11 . 3s/X11).X11)./Init./AUdur
  not T11$clear$not$g (T11$clear$not, T11$clear);
  and X11$hold$g (X11$hold, X11, T11$clear$not, Init$not);
  or X11$evolved$g (X11$evolved, T10$clear, X11$hold);
  and X11$next$g (X11$next, X11$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X11$g (.d(X11$next), .c(clk), .q(X11));

  // X12 = (X11 . 3s/X11 + X15 . 2s/X15./obstacle + X16.[trains > 0] + /(X12.down + X12.obstacle./down).X12)./Init./AUdur
  not T12$clear$not$g (T12$clear$not, T12$clear);
  not T13$clear$not$g (T13$clear$not, T13$clear);
  and X12$hold$g (X12$hold, X12, T12$clear$not, T13$clear$not, Init$not);
  or X12$evolved$g (X12$evolved, T11$clear, T15$clear, T18$clear, X12$hold);
  and X12$next$g (X12$next, X12$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X12$g (.d(X12$next), .c(clk), .q(X12));

  // X13 = (X12.down + /(X13.[trains = 0]).X13)./Init./AUdur
  not T16$clear$not$g (T16$clear$not, T16$clear);
  and X13$hold$g (X13$hold, X13, T16$clear$not, Init$not);
  or X13$evolved$g (X13$evolved, T12$clear, X13$hold);
  and X13$next$g (X13$next, X13$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X13$g (.d(X13$next), .c(clk), .q(X13));

  // X14 = (X12.obstacle./down + /(X14.up).X14)./Init./AUdur
  not T14$clear$not$g (T14$clear$not, T14$clear);
  and X14$hold$g (X14$hold, X14, T14$clear$not, Init$not);
  or X14$evolved$g (X14$evolved, T13$clear, X14$hold);
  and X14$next$g (X14$next, X14$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X14$g (.d(X14$next), .c(clk), .q(X14));

  // X15 = (X14.up + /(X15 . 2s/X15./obstacle).X15)./Init./AUdur
  not T15$clear$not$g (T15$clear$not, T15$clear);
  and X15$hold$g (X15$hold, X15, T15$clear$not, Init$not);
  or X15$evolved$g (X15$evolved, T14$clear, X15$hold);
  and X15$next$g (X15$next, X15$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X15$g (.d(X15$next), .c(clk), .q(X15));

  // X16 = (X13.[trains = 0] + /(X16.up.[trains = 0] + X16.[trains > 0]).X16)./Init./AUdur
  not T17$clear$not$g (T17$clear$not, T17$clear);
  not T18$clear$not$g (T18$clear$not, T18$clear);
  and X16$hold$g (X16$hold, X16, T17$clear$not, T18$clear$not, Init$not);
  or X16$evolved$g (X16$evolved, T16$clear, X16$hold);
  and X16$next$g (X16$next, X16$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X16$g (.d(X16$next), .c(clk), .q(X16));

  // X17 = (X16.up.[trains = 0] + /(X17.X23).X17)./Init./AUdur
  not T24$clear$not$g (T24$clear$not, T24$clear);
  and X17$hold$g (X17$hold, X17, T24$clear$not, Init$not);
  or X17$evolved$g (X17$evolved, T17$clear, X17$hold);
  and X17$next$g (X17$next, X17$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X17$g (.d(X17$next), .c(clk), .q(X17));

  // X20 = (X10.([trains > 0] + ↑test) + X22 . 400ms/X22./X17 + /(X20 . 400ms/X20).X20)./Init./AUdur
  not T20$clear$not$g (T20$clear$not, T20$clear);
  and X20$hold$g (X20$hold, X20, T20$clear$not, Init$not);
  or X20$evolved$g (X20$evolved, T10$clear, T22$clear, X20$hold);
  and X20$next$g (X20$next, X20$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X20$g (.d(X20$next), .c(clk), .q(X20));

  // X21 = (X20 . 400ms/X20 + /(X21 . 400ms/X21).X21)./Init./AUdur
  not T21$clear$not$g (T21$clear$not, T21$clear);
  and X21$hold$g (X21$hold, X21, T21$clear$not, Init$not);
  or X21$evolved$g (X21$evolved, T20$clear, X21$hold);
  and X21$next$g (X21$next, X21$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X21$g (.d(X21$next), .c(clk), .q(X21));

  // X22 = (X21 . 400ms/X21 + /(X22 . 400ms/X22./X17 + X22 . 400ms/X22.X17).X22)./Init./AUdur
  not T22$clear$not$g (T22$clear$not, T22$clear);
  not T23$clear$not$g (T23$clear$not, T23$clear);
  and X22$hold$g (X22$hold, X22, T22$clear$not, T23$clear$not, Init$not);
  or X22$evolved$g (X22$evolved, T21$clear, X22$hold);
  and X22$next$g (X22$next, X22$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X22$g (.d(X22$next), .c(clk), .q(X22));

  // X23 = (X22 . 400ms/X22.X17 + /(X17.X23).X23)./Init./AUdur
  and X23$hold$g (X23$hold, X23, T24$clear$not, Init$not);
  or X23$evolved$g (X23$evolved, T23$clear, X23$hold);
  and X23$next$g (X23$next, X23$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X23$g (.d(X23$next), .c(clk), .q(X23));

  // X30 = (X32.X10 + /(X30.X11).X30 + Init)./AUdur
  not T30$clear$not$g (T30$clear$not, T30$clear);
  and X30$hold$g (X30$hold, X30, T30$clear$not);
  or X30$evolved$g (X30$evolved, T32$clear, X30$hold, Init);
  and X30$next$g (X30$next, X30$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b1)) X30$g (.d(X30$next), .c(clk), .q(X30));

  // X31 = (X30.X11 + /(X31.X17).X31)./Init./AUdur
  not T31$clear$not$g (T31$clear$not, T31$clear);
  and X31$hold$g (X31$hold, X31, T31$clear$not, Init$not);
  or X31$evolved$g (X31$evolved, T30$clear, X31$hold);
  and X31$next$g (X31$next, X31$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X31$g (.d(X31$next), .c(clk), .q(X31));

  // X32 = (X31.X17 + /(X32.X10).X32)./Init./AUdur
  not T32$clear$not$g (T32$clear$not, T32$clear);
  and X32$hold$g (X32$hold, X32, T32$clear$not, Init$not);
  or X32$evolved$g (X32$evolved, T31$clear, X32$hold);
  and X32$next$g (X32$next, X32$evolved, AUdur$not);
  grafwire_dff #(.INIT(1'b0)) X32$g (.d(X32$next), .c(clk), .q(X32));

  // red
  and red$next$a1$g (red$next$a1, T30$clear$not, red);
  or red$next$a2$g (red$next$a2, T30$clear, red$next$a1);
  and red$next$a3$g (red$next$a3, T32$clear$not, red$next$a2);
  grafwire_dff #(.INIT(1'b0)) red$g (.d(red$next$a3), .c(clk), .q(red));

  // trains
  xor trains$next$a1$g (trains$next$a1, trains$q1, trains$q0);
  and trains$next$a2$g (trains$next$a2, trains$q1, trains$q0);
  or trains$next$a3$g (trains$next$a3, trains$q0$not, trains$q0);
  not trains$next$a1$not$g (trains$next$a1$not, trains$next$a1);
  xor trains$next$a4$g (trains$next$a4, trains$next$a1$not, trains$next$a3);
  and trains$next$a5$g (trains$next$a5, trains$next$a1$not, trains$next$a3);
  or trains$next$a6$g (trains$next$a6, trains$next$a1, trains$next$a5);
  not trains$next$a2$not$g (trains$next$a2$not, trains$next$a2);
  xor trains$next$a7$g (trains$next$a7, trains$next$a2$not, trains$next$a6);
  and trains$next$a8$g (trains$next$a8, trains$next$a2$not, trains$next$a6);
  or trains$next$a9$g (trains$next$a9, trains$next$a2, trains$next$a8);
  not trains$next$a9$not$g (trains$next$a9$not, trains$next$a9);
  xor trains$next$a10$g (trains$next$a10, trains$next$a4, trains$q0$not);
  and trains$next$a11$g (trains$next$a11, trains$next$a4, trains$q0$not);
  not trains$next$a7$not$g (trains$next$a7$not, trains$next$a7);
  xor trains$next$a12$g (trains$next$a12, trains$next$a7$not, trains$next$a11);
  and trains$next$a13$g (trains$next$a13, trains$next$a7$not, trains$next$a11);
  or trains$next$a14$g (trains$next$a14, trains$next$a7, trains$next$a13);
  xor trains$next$a15$g (trains$next$a15, trains$next$a9, trains$next$a14);
  and trains$next$a16$g (trains$next$a16, trains$next$a9, trains$next$a14);
  or trains$next$a17$g (trains$next$a17, trains$next$a9$not, trains$next$a16);
  xor trains$next$a18$g (trains$next$a18, trains$next$a9, trains$next$a17);
  and trains$next$a19$g (trains$next$a19, trains$next$a9, trains$next$a17);
  or trains$next$a20$g (trains$next$a20, trains$next$a9$not, trains$next$a19);
  xor trains$next$a21$g (trains$next$a21, trains$next$a9, trains$next$a20);
  and trains$next$a22$g (trains$next$a22, trains$next$a9, trains$next$a20);
  or trains$next$a23$g (trains$next$a23, trains$next$a9$not, trains$next$a22);
  xor trains$next$a24$g (trains$next$a24, trains$next$a9, trains$next$a23);
  and trains$next$a25$g (trains$next$a25, trains$next$a9, trains$next$a23);
  or trains$next$a26$g (trains$next$a26, trains$next$a9$not, trains$next$a25);
  xor trains$next$a27$g (trains$next$a27, trains$next$a9, trains$next$a26);
  and trains$next$a28$g (trains$next$a28, trains$next$a9, trains$next$a26);
  or trains$next$a29$g (trains$next$a29, trains$next$a9$not, trains$next$a28);
  xor trains$next$a30$g (trains$next$a30, trains$next$a9, trains$next$a29);
  and trains$next$a31$g (trains$next$a31, trains$next$a9, trains$next$a29);
  or trains$next$a32$g (trains$next$a32, trains$next$a9$not, trains$next$a31);
  xor trains$next$a33$g (trains$next$a33, trains$next$a9, trains$next$a32);
  and trains$next$a34$g (trains$next$a34, trains$next$a9, trains$next$a32);
  or trains$next$a35$g (trains$next$a35, trains$next$a9$not, trains$next$a34);
  xor trains$next$a36$g (trains$next$a36, trains$next$a9, trains$next$a35);
  and trains$next$a37$g (trains$next$a37, trains$next$a9, trains$next$a35);
  or trains$next$a38$g (trains$next$a38, trains$next$a9$not, trains$next$a37);
  xor trains$next$a39$g (trains$next$a39, trains$next$a9, trains$next$a38);
  and trains$next$a40$g (trains$next$a40, trains$next$a9, trains$next$a38);
  or trains$next$a41$g (trains$next$a41, trains$next$a9$not, trains$next$a40);
  xor trains$next$a42$g (trains$next$a42, trains$next$a9, trains$next$a41);
  and trains$next$a43$g (trains$next$a43, trains$next$a9, trains$next$a41);
  or trains$next$a44$g (trains$next$a44, trains$next$a9$not, trains$next$a43);
  xor trains$next$a45$g (trains$next$a45, trains$next$a9, trains$next$a44);
  and trains$next$a46$g (trains$next$a46, trains$next$a9, trains$next$a44);
  or trains$next$a47$g (trains$next$a47, trains$next$a9$not, trains$next$a46);
  xor trains$next$a48$g (trains$next$a48, trains$next$a9, trains$next$a47);
  and trains$next$a49$g (trains$next$a49, trains$next$a9, trains$next$a47);
  or trains$next$a50$g (trains$next$a50, trains$next$a9$not, trains$next$a49);
  xor trains$next$a51$g (trains$next$a51, trains$next$a9, trains$next$a50);
  and trains$next$a52$g (trains$next$a52, trains$next$a9, trains$next$a50);
  or trains$next$a53$g (trains$next$a53, trains$next$a9$not, trains$next$a52);
  xor trains$next$a54$g (trains$next$a54, trains$next$a9, trains$next$a53);
  and trains$next$a55$g (trains$next$a55, trains$next$a9, trains$next$a53);
  or trains$next$a56$g (trains$next$a56, trains$next$a9$not, trains$next$a55);
  xor trains$next$a57$g (trains$next$a57, trains$next$a9, trains$next$a56);
  and trains$next$a58$g (trains$next$a58, trains$next$a9, trains$next$a56);
  or trains$next$a59$g (trains$next$a59, trains$next$a9$not, trains$next$a58);
  xor trains$next$a60$g (trains$next$a60, trains$next$a9, trains$next$a59);
  and trains$next$a61$g (trains$next$a61, trains$next$a9, trains$next$a59);
  or trains$next$a62$g (trains$next$a62, trains$next$a9$not, trains$next$a61);
  xor trains$next$a63$g (trains$next$a63, trains$next$a9, trains$next$a62);
  and trains$next$a64$g (trains$next$a64, trains$next$a9, trains$next$a62);
  or trains$next$a65$g (trains$next$a65, trains$next$a9$not, trains$next$a64);
  xor trains$next$a66$g (trains$next$a66, trains$next$a9, trains$next$a65);
  and trains$next$a67$g (trains$next$a67, trains$next$a9, trains$next$a65);
  or trains$next$a68$g (trains$next$a68, trains$next$a9$not, trains$next$a67);
  xor trains$next$a69$g (trains$next$a69, trains$next$a9, trains$next$a68);
  and trains$next$a70$g (trains$next$a70, trains$next$a9, trains$next$a68);
  or trains$next$a71$g (trains$next$a71, trains$next$a9$not, trains$next$a70);
  xor trains$next$a72$g (trains$next$a72, trains$next$a9, trains$next$a71);
  and trains$next$a73$g (trains$next$a73, trains$next$a9, trains$next$a71);
  or trains$next$a74$g (trains$next$a74, trains$next$a9$not, trains$next$a73);
  xor trains$next$a75$g (trains$next$a75, trains$next$a9, trains$next$a74);
  and trains$next$a76$g (trains$next$a76, trains$next$a9, trains$next$a74);
  or trains$next$a77$g (trains$next$a77, trains$next$a9$not, trains$next$a76);
  xor trains$next$a78$g (trains$next$a78, trains$next$a9, trains$next$a77);
  and trains$next$a79$g (trains$next$a79, trains$next$a9, trains$next$a77);
  or trains$next$a80$g (trains$next$a80, trains$next$a9$not, trains$next$a79);
  xor trains$next$a81$g (trains$next$a81, trains$next$a9, trains$next$a80);
  and trains$next$a82$g (trains$next$a82, trains$next$a9, trains$next$a80);
  or trains$next$a83$g (trains$next$a83, trains$next$a9$not, trains$next$a82);
  xor trains$next$a84$g (trains$next$a84, trains$next$a9, trains$next$a83);
  and trains$next$a85$g (trains$next$a85, trains$next$a9, trains$next$a83);
  or trains$next$a86$g (trains$next$a86, trains$next$a9$not, trains$next$a85);
  xor trains$next$a87$g (trains$next$a87, trains$next$a9, trains$next$a86);
  and trains$next$a88$g (trains$next$a88, trains$next$a9, trains$next$a86);
  or trains$next$a89$g (trains$next$a89, trains$next$a9$not, trains$next$a88);
  xor trains$next$a90$g (trains$next$a90, trains$next$a9, trains$next$a89);
  and trains$next$a91$g (trains$next$a91, trains$next$a9, trains$next$a89);
  or trains$next$a92$g (trains$next$a92, trains$next$a9$not, trains$next$a91);
  xor trains$next$a93$g (trains$next$a93, trains$next$a9, trains$next$a92);
  and trains$next$a94$g (trains$next$a94, trains$next$a9, trains$next$a92);
  or trains$next$a95$g (trains$next$a95, trains$next$a9$not, trains$next$a94);
  xor trains$next$a96$g (trains$next$a96, trains$next$a9, trains$next$a95);
  and trains$next$a97$g (trains$next$a97, trains$next$a9, trains$next$a95);
  or trains$next$a98$g (trains$next$a98, trains$next$a9$not, trains$next$a97);
  xor trains$next$a99$g (trains$next$a99, trains$next$a9, trains$next$a98);
  and trains$next$a100$g (trains$next$a100, trains$next$a9, trains$next$a98);
  or trains$next$a101$g (trains$next$a101, trains$next$a9$not, trains$next$a100);
  xor trains$next$a102$g (trains$next$a102, trains$next$a9, trains$next$a101);
  and trains$next$a103$g (trains$next$a103, trains$next$a9, trains$next$a101);
  or trains$next$a104$g (trains$next$a104, trains$next$a9$not, trains$next$a103);
  xor trains$next$a105$g (trains$next$a105, trains$next$a9, trains$next$a104);
  and trains$next$a106$g (trains$next$a106, trains$next$a9, trains$next$a104);
  or trains$next$a107$g (trains$next$a107, trains$next$a9$not, trains$next$a106);
  xor trains$next$a108$g (trains$next$a108, trains$next$a9, trains$next$a107);
  and trains$next$a109$g (trains$next$a109, trains$next$a9, trains$next$a107);
  or trains$next$a110$g (trains$next$a110, trains$next$a9$not, trains$next$a109);
  xor trains$next$a111$g (trains$next$a111, trains$next$a9, trains$next$a110);
  and trains$next$a112$g (trains$next$a112, trains$next$a9, trains$next$a110);
  or trains$next$a113$g (trains$next$a113, trains$next$a9$not, trains$next$a112);
  xor trains$next$a114$g (trains$next$a114, trains$next$a9, trains$next$a113);
  and trains$next$a115$g (trains$next$a115, trains$next$a9, trains$next$a113);
  or trains$next$a116$g (trains$next$a116, trains$next$a9$not, trains$next$a115);
  xor trains$next$a117$g (trains$next$a117, trains$next$a9, trains$next$a116);
  and trains$next$a118$g (trains$next$a118, trains$next$a9, trains$next$a116);
  or trains$next$a119$g (trains$next$a119, trains$next$a9$not, trains$next$a118);
  xor trains$next$a120$g (trains$next$a120, trains$next$a9, trains$next$a119);
  and trains$next$a121$g (trains$next$a121, trains$next$a9, trains$next$a119);
  or trains$next$a122$g (trains$next$a122, trains$next$a9$not, trains$next$a121);
  xor trains$next$a123$g (trains$next$a123, trains$next$a9, trains$next$a122);
  and trains$next$a124$g (trains$next$a124, trains$next$a9, trains$next$a122);
  or trains$next$a125$g (trains$next$a125, trains$next$a9$not, trains$next$a124);
  xor trains$next$a126$g (trains$next$a126, trains$next$a9, trains$next$a125);
  and trains$next$a127$g (trains$next$a127, trains$next$a9, trains$next$a125);
  or trains$next$a128$g (trains$next$a128, trains$next$a9$not, trains$next$a127);
  xor trains$next$a129$g (trains$next$a129, trains$next$a9, trains$next$a128);
  and trains$next$a130$g (trains$next$a130, trains$next$a9, trains$next$a128);
  or trains$next$a131$g (trains$next$a131, trains$next$a9$not, trains$next$a130);
  xor trains$next$a132$g (trains$next$a132, trains$next$a9, trains$next$a131);
  and trains$next$a133$g (trains$next$a133, trains$next$a9, trains$next$a131);
  or trains$next$a134$g (trains$next$a134, trains$next$a9$not, trains$next$a133);
  xor trains$next$a135$g (trains$next$a135, trains$next$a9, trains$next$a134);
  and trains$next$a136$g (trains$next$a136, trains$next$a9, trains$next$a134);
  or trains$next$a137$g (trains$next$a137, trains$next$a9$not, trains$next$a136);
  xor trains$next$a138$g (trains$next$a138, trains$next$a9, trains$next$a137);
  and trains$next$a139$g (trains$next$a139, trains$next$a9, trains$next$a137);
  or trains$next$a140$g (trains$next$a140, trains$next$a9$not, trains$next$a139);
  xor trains$next$a141$g (trains$next$a141, trains$next$a9, trains$next$a140);
  and trains$next$a142$g (trains$next$a142, trains$next$a9, trains$next$a140);
  or trains$next$a143$g (trains$next$a143, trains$next$a9$not, trains$next$a142);
  xor trains$next$a144$g (trains$next$a144, trains$next$a9, trains$next$a143);
  and trains$next$a145$g (trains$next$a145, trains$next$a9, trains$next$a143);
  or trains$next$a146$g (trains$next$a146, trains$next$a9$not, trains$next$a145);
  xor trains$next$a147$g (trains$next$a147, trains$next$a9, trains$next$a146);
  and trains$next$a148$g (trains$next$a148, trains$next$a9, trains$next$a146);
  or trains$next$a149$g (trains$next$a149, trains$next$a9$not, trains$next$a148);
  xor trains$next$a150$g (trains$next$a150, trains$next$a9, trains$next$a149);
  and trains$next$a151$g (trains$next$a151, trains$next$a9, trains$next$a149);
  or trains$next$a152$g (trains$next$a152, trains$next$a9$not, trains$next$a151);
  xor trains$next$a153$g (trains$next$a153, trains$next$a9, trains$next$a152);
  and trains$next$a154$g (trains$next$a154, trains$next$a9, trains$next$a152);
  or trains$next$a155$g (trains$next$a155, trains$next$a9$not, trains$next$a154);
  xor trains$next$a156$g (trains$next$a156, trains$next$a9, trains$next$a155);
  and trains$next$a157$g (trains$next$a157, trains$next$a9, trains$next$a155);
  or trains$next$a158$g (trains$next$a158, trains$next$a9$not, trains$next$a157);
  xor trains$next$a159$g (trains$next$a159, trains$next$a9, trains$next$a158);
  and trains$next$a160$g (trains$next$a160, trains$next$a9, trains$next$a158);
  or trains$next$a161$g (trains$next$a161, trains$next$a9$not, trains$next$a160);
  xor trains$next$a162$g (trains$next$a162, trains$next$a9, trains$next$a161);
  and trains$next$a163$g (trains$next$a163, trains$next$a9, trains$next$a161);
  or trains$next$a164$g (trains$next$a164, trains$next$a9$not, trains$next$a163);
  xor trains$next$a165$g (trains$next$a165, trains$next$a9, trains$next$a164);
  and trains$next$a166$g (trains$next$a166, trains$next$a9, trains$next$a164);
  or trains$next$a167$g (trains$next$a167, trains$next$a9$not, trains$next$a166);
  xor trains$next$a168$g (trains$next$a168, trains$next$a9, trains$next$a167);
  and trains$next$a169$g (trains$next$a169, trains$next$a9, trains$next$a167);
  or trains$next$a170$g (trains$next$a170, trains$next$a9$not, trains$next$a169);
  xor trains$next$a171$g (trains$next$a171, trains$next$a9, trains$next$a170);
  and trains$next$a172$g (trains$next$a172, trains$next$a9, trains$next$a170);
  or trains$next$a173$g (trains$next$a173, trains$next$a9$not, trains$next$a172);
  xor trains$next$a174$g (trains$next$a174, trains$next$a9, trains$next$a173);
  and trains$next$a175$g (trains$next$a175, trains$next$a9, trains$next$a173);
  or trains$next$a176$g (trains$next$a176, trains$next$a9$not, trains$next$a175);
  xor trains$next$a177$g (trains$next$a177, trains$next$a9, trains$next$a176);
  and trains$next$a178$g (trains$next$a178, trains$next$a9, trains$next$a176);
  or trains$next$a179$g (trains$next$a179, trains$next$a9$not, trains$next$a178);
  xor trains$next$a180$g (trains$next$a180, trains$next$a9, trains$next$a179);
  and trains$next$a181$g (trains$next$a181, trains$next$a9, trains$next$a179);
  or trains$next$a182$g (trains$next$a182, trains$next$a9$not, trains$next$a181);
  xor trains$next$a183$g (trains$next$a183, trains$next$a9, trains$next$a182);
  and trains$next$a184$g (trains$next$a184, trains$next$a9, trains$next$a182);
  or trains$next$a185$g (trains$next$a185, trains$next$a9$not, trains$next$a184);
  xor trains$next$a186$g (trains$next$a186, trains$next$a9, trains$next$a185);
  and trains$next$a187$g (trains$next$a187, trains$next$a9, trains$next$a185);
  or trains$next$a188$g (trains$next$a188, trains$next$a9$not, trains$next$a187);
  xor trains$next$a189$g (trains$next$a189, trains$next$a9, trains$next$a188);
  and trains$next$a190$g (trains$next$a190, trains$next$a9, trains$next$a188);
  or trains$next$a191$g (trains$next$a191, trains$next$a9$not, trains$next$a190);
  xor trains$next$a192$g (trains$next$a192, trains$next$a9, trains$next$a191);
  and trains$next$a193$g (trains$next$a193, trains$next$a9, trains$next$a191);
  or trains$next$a194$g (trains$next$a194, trains$next$a9$not, trains$next$a193);
  xor trains$next$a195$g (trains$next$a195, trains$next$a9, trains$next$a194);
  and trains$next$a196$g (trains$next$a196, trains$next$a9, trains$next$a194);
  or trains$next$a197$g (trains$next$a197, trains$next$a9$not, trains$next$a196);
  xor trains$next$a198$g (trains$next$a198, trains$next$a9, trains$next$a197);
  and trains$next$a199$g (trains$next$a199, trains$next$a9, trains$next$a197);
  or trains$next$a200$g (trains$next$a200, trains$next$a9$not, trains$next$a199);
  xor trains$next$a201$g (trains$next$a201, trains$next$a9, trains$next$a200);
  and trains$next$a202$g (trains$next$a202, trains$next$a9, trains$next$a200);
  or trains$next$a203$g (trains$next$a203, trains$next$a9$not, trains$next$a202);
  xor trains$next$a204$g (trains$next$a204, trains$next$a9, trains$next$a203);
  or trains$next$a205$g (trains$next$a205, trains$q0, trains$next$a10);
  or trains$next$a206$g (trains$next$a206, trains$next$a205, trains$next$a12);
  or trains$next$a207$g (trains$next$a207, trains$next$a206, trains$next$a15);
  or trains$next$a208$g (trains$next$a208, trains$next$a207, trains$next$a18);
  or trains$next$a209$g (trains$next$a209, trains$next$a208, trains$next$a21);
  or trains$next$a210$g (trains$next$a210, trains$next$a209, trains$next$a24);
  or trains$next$a211$g (trains$next$a211, trains$next$a210, trains$next$a27);
  or trains$next$a212$g (trains$next$a212, trains$next$a211, trains$next$a30);
  or trains$next$a213$g (trains$next$a213, trains$next$a212, trains$next$a33);
  or trains$next$a214$g (trains$next$a214, trains$next$a213, trains$next$a36);
  or trains$next$a215$g (trains$next$a215, trains$next$a214, trains$next$a39);
  or trains$next$a216$g (trains$next$a216, trains$next$a215, trains$next$a42);
  or trains$next$a217$g (trains$next$a217, trains$next$a216, trains$next$a45);
  or trains$next$a218$g (trains$next$a218, trains$next$a217, trains$next$a48);
  or trains$next$a219$g (trains$next$a219, trains$next$a218, trains$next$a51);
  or trains$next$a220$g (trains$next$a220, trains$next$a219, trains$next$a54);
  or trains$next$a221$g (trains$next$a221, trains$next$a220, trains$next$a57);
  or trains$next$a222$g (trains$next$a222, trains$next$a221, trains$next$a60);
  or trains$next$a223$g (trains$next$a223, trains$next$a222, trains$next$a63);
  or trains$next$a224$g (trains$next$a224, trains$next$a223, trains$next$a66);
  or trains$next$a225$g (trains$next$a225, trains$next$a224, trains$next$a69);
  or trains$next$a226$g (trains$next$a226, trains$next$a225, trains$next$a72);
  or trains$next$a227$g (trains$next$a227, trains$next$a226, trains$next$a75);
  or trains$next$a228$g (trains$next$a228, trains$next$a227, trains$next$a78);
  or trains$next$a229$g (trains$next$a229, trains$next$a228, trains$next$a81);
  or trains$next$a230$g (trains$next$a230, trains$next$a229, trains$next$a84);
  or trains$next$a231$g (trains$next$a231, trains$next$a230, trains$next$a87);
  or trains$next$a232$g (trains$next$a232, trains$next$a231, trains$next$a90);
  or trains$next$a233$g (trains$next$a233, trains$next$a232, trains$next$a93);
  or trains$next$a234$g (trains$next$a234, trains$next$a233, trains$next$a96);
  or trains$next$a235$g (trains$next$a235, trains$next$a234, trains$next$a99);
  or trains$next$a236$g (trains$next$a236, trains$next$a235, trains$next$a102);
  or trains$next$a237$g (trains$next$a237, trains$next$a236, trains$next$a105);
  or trains$next$a238$g (trains$next$a238, trains$next$a237, trains$next$a108);
  or trains$next$a239$g (trains$next$a239, trains$next$a238, trains$next$a111);
  or trains$next$a240$g (trains$next$a240, trains$next$a239, trains$next$a114);
  or trains$next$a241$g (trains$next$a241, trains$next$a240, trains$next$a117);
  or trains$next$a242$g (trains$next$a242, trains$next$a241, trains$next$a120);
  or trains$next$a243$g (trains$next$a243, trains$next$a242, trains$next$a123);
  or trains$next$a244$g (trains$next$a244, trains$next$a243, trains$next$a126);
  or trains$next$a245$g (trains$next$a245, trains$next$a244, trains$next$a129);
  or trains$next$a246$g (trains$next$a246, trains$next$a245, trains$next$a132);
  or trains$next$a247$g (trains$next$a247, trains$next$a246, trains$next$a135);
  or trains$next$a248$g (trains$next$a248, trains$next$a247, trains$next$a138);
  or trains$next$a249$g (trains$next$a249, trains$next$a248, trains$next$a141);
  or trains$next$a250$g (trains$next$a250, trains$next$a249, trains$next$a144);
  or trains$next$a251$g (trains$next$a251, trains$next$a250, trains$next$a147);
  or trains$next$a252$g (trains$next$a252, trains$next$a251, trains$next$a150);
  or trains$next$a253$g (trains$next$a253, trains$next$a252, trains$next$a153);
  or trains$next$a254$g (trains$next$a254, trains$next$a253, trains$next$a156);
  or trains$next$a255$g (trains$next$a255, trains$next$a254, trains$next$a159);
  or trains$next$a256$g (trains$next$a256, trains$next$a255, trains$next$a162);
  or trains$next$a257$g (trains$next$a257, trains$next$a256, trains$next$a165);
  or trains$next$a258$g (trains$next$a258, trains$next$a257, trains$next$a168);
  or trains$next$a259$g (trains$next$a259, trains$next$a258, trains$next$a171);
  or trains$next$a260$g (trains$next$a260, trains$next$a259, trains$next$a174);
  or trains$next$a261$g (trains$next$a261, trains$next$a260, trains$next$a177);
  or trains$next$a262$g (trains$next$a262, trains$next$a261, trains$next$a180);
  or trains$next$a263$g (trains$next$a263, trains$next$a262, trains$next$a183);
  or trains$next$a264$g (trains$next$a264, trains$next$a263, trains$next$a186);
  or trains$next$a265$g (trains$next$a265, trains$next$a264, trains$next$a189);
  or trains$next$a266$g (trains$next$a266, trains$next$a265, trains$next$a192);
  or trains$next$a267$g (trains$next$a267, trains$next$a266, trains$next$a195);
  or trains$next$a268$g (trains$next$a268, trains$next$a267, trains$next$a198);
  or trains$next$a269$g (trains$next$a269, trains$next$a268, trains$next$a201);
  or trains$next$a270$g (trains$next$a270, trains$next$a269, trains$next$a204);
  not trains$next$a270$not$g (trains$next$a270$not, trains$next$a270);
  or trains$next$a271$g (trains$next$a271, trains$next$a204, trains$next$a270$not);
  not trains$next$a271$not$g (trains$next$a271$not, trains$next$a271);
  and trains$next$a272$g (trains$next$a272, trains$next$a271, trains$q0$not);
  or trains$next$a273$g (trains$next$a273, trains$next$a271$not, trains$next$a272);
  and trains$next$a274$g (trains$next$a274, trains$next$a271, trains$next$a4);
  or trains$next$a275$g (trains$next$a275, trains$next$a271$not, trains$next$a274);
  and trains$next$a276$g (trains$next$a276, trains$next$a271, trains$next$a7);
  and trains$next$a277$g (trains$next$a277, trains$next$a9, trains$next$a273);
  and trains$next$a278$g (trains$next$a278, trains$next$a9, trains$next$a275);
  and trains$next$a279$g (trains$next$a279, trains$next$a9, trains$next$a276);
  and trains$next$a280$g (trains$next$a280, T0$clear, trains$next$a277);
  and trains$next$a281$g (trains$next$a281, T0$clear$not, trains$q0);
  or trains$next$a282$g (trains$next$a282, trains$next$a280, trains$next$a281);
  and trains$next$a283$g (trains$next$a283, T0$clear, trains$next$a278);
  and trains$next$a284$g (trains$next$a284, T0$clear$not, trains$q1);
  or trains$next$a285$g (trains$next$a285, trains$next$a283, trains$next$a284);
  and trains$next$a286$g (trains$next$a286, T0$clear, trains$next$a279);
  xor trains$next$a287$g (trains$next$a287, trains$q1$not, trains$q0);
  and trains$next$a288$g (trains$next$a288, trains$q1$not, trains$q0);
  or trains$next$a289$g (trains$next$a289, trains$q1, trains$next$a288);
  not trains$next$a289$not$g (trains$next$a289$not, trains$next$a289);
  or trains$next$a290$g (trains$next$a290, trains$q0$not, trains$q0);
  not trains$next$a287$not$g (trains$next$a287$not, trains$next$a287);
  xor trains$next$a291$g (trains$next$a291, trains$next$a287$not, trains$next$a290);
  and trains$next$a292$g (trains$next$a292, trains$next$a287$not, trains$next$a290);
  or trains$next$a293$g (trains$next$a293, trains$next$a287, trains$next$a292);
  xor trains$next$a294$g (trains$next$a294, trains$next$a289, trains$next$a293);
  and trains$next$a295$g (trains$next$a295, trains$next$a289, trains$next$a293);
  or trains$next$a296$g (trains$next$a296, trains$next$a289$not, trains$next$a295);
  xor trains$next$a297$g (trains$next$a297, trains$next$a289, trains$next$a296);
  and trains$next$a298$g (trains$next$a298, trains$next$a289, trains$next$a296);
  or trains$next$a299$g (trains$next$a299, trains$next$a289$not, trains$next$a298);
  xor trains$next$a300$g (trains$next$a300, trains$next$a289, trains$next$a299);
  and trains$next$a301$g (trains$next$a301, trains$next$a289, trains$next$a299);
  or trains$next$a302$g (trains$next$a302, trains$next$a289$not, trains$next$a301);
  xor trains$next$a303$g (trains$next$a303, trains$next$a289, trains$next$a302);
  and trains$next$a304$g (trains$next$a304, trains$next$a289, trains$next$a302);
  or trains$next$a305$g (trains$next$a305, trains$next$a289$not, trains$next$a304);
  xor trains$next$a306$g (trains$next$a306, trains$next$a289, trains$next$a305);
  and trains$next$a307$g (trains$next$a307, trains$next$a289, trains$next$a305);
  or trains$next$a308$g (trains$next$a308, trains$next$a289$not, trains$next$a307);
  xor trains$next$a309$g (trains$next$a309, trains$next$a289, trains$next$a308);
  and trains$next$a310$g (trains$next$a310, trains$next$a289, trains$next$a308);
  or trains$next$a311$g (trains$next$a311, trains$next$a289$not, trains$next$a310);
  xor trains$next$a312$g (trains$next$a312, trains$next$a289, trains$next$a311);
  and trains$next$a313$g (trains$next$a313, trains$next$a289, trains$next$a311);
  or trains$next$a314$g (trains$next$a314, trains$next$a289$not, trains$next$a313);
  xor trains$next$a315$g (trains$next$a315, trains$next$a289, trains$next$a314);
  and trains$next$a316$g (trains$next$a316, trains$next$a289, trains$next$a314);
  or trains$next$a317$g (trains$next$a317, trains$next$a289$not, trains$next$a316);
  xor trains$next$a318$g (trains$next$a318, trains$next$a289, trains$next$a317);
  and trains$next$a319$g (trains$next$a319, trains$next$a289, trains$next$a317);
  or trains$next$a320$g (trains$next$a320, trains$next$a289$not, trains$next$a319);
  xor trains$next$a321$g (trains$next$a321, trains$next$a289, trains$next$a320);
  and trains$next$a322$g (trains$next$a322, trains$next$a289, trains$next$a320);
  or trains$next$a323$g (trains$next$a323, trains$next$a289$not, trains$next$a322);
  xor trains$next$a324$g (trains$next$a324, trains$next$a289, trains$next$a323);
  and trains$next$a325$g (trains$next$a325, trains$next$a289, trains$next$a323);
  or trains$next$a326$g (trains$next$a326, trains$next$a289$not, trains$next$a325);
  xor trains$next$a327$g (trains$next$a327, trains$next$a289, trains$next$a326);
  and trains$next$a328$g (trains$next$a328, trains$next$a289, trains$next$a326);
  or trains$next$a329$g (trains$next$a329, trains$next$a289$not, trains$next$a328);
  xor trains$next$a330$g (trains$next$a330, trains$next$a289, trains$next$a329);
  and trains$next$a331$g (trains$next$a331, trains$next$a289, trains$next$a329);
  or trains$next$a332$g (trains$next$a332, trains$next$a289$not, trains$next$a331);
  xor trains$next$a333$g (trains$next$a333, trains$next$a289, trains$next$a332);
  and trains$next$a334$g (trains$next$a334, trains$next$a289, trains$next$a332);
  or trains$next$a335$g (trains$next$a335, trains$next$a289$not, trains$next$a334);
  xor trains$next$a336$g (trains$next$a336, trains$next$a289, trains$next$a335);
  and trains$next$a337$g (trains$next$a337, trains$next$a289, trains$next$a335);
  or trains$next$a338$g (trains$next$a338, trains$next$a289$not, trains$next$a337);
  xor trains$next$a339$g (trains$next$a339, trains$next$a289, trains$next$a338);
  and trains$next$a340$g (trains$next$a340, trains$next$a289, trains$next$a338);
  or trains$next$a341$g (trains$next$a341, trains$next$a289$not, trains$next$a340);
  xor trains$next$a342$g (trains$next$a342, trains$next$a289, trains$next$a341);
  and trains$next$a343$g (trains$next$a343, trains$next$a289, trains$next$a341);
  or trains$next$a344$g (trains$next$a344, trains$next$a289$not, trains$next$a343);
  xor trains$next$a345$g (trains$next$a345, trains$next$a289, trains$next$a344);
  and trains$next$a346$g (trains$next$a346, trains$next$a289, trains$next$a344);
  or trains$next$a347$g (trains$next$a347, trains$next$a289$not, trains$next$a346);
  xor trains$next$a348$g (trains$next$a348, trains$next$a289, trains$next$a347);
  and trains$next$a349$g (trains$next$a349, trains$next$a289, trains$next$a347);
  or trains$next$a350$g (trains$next$a350, trains$next$a289$not, trains$next$a349);
  xor trains$next$a351$g (trains$next$a351, trains$next$a289, trains$next$a350);
  and trains$next$a352$g (trains$next$a352, trains$next$a289, trains$next$a350);
  or trains$next$a353$g (trains$next$a353, trains$next$a289$not, trains$next$a352);
  xor trains$next$a354$g (trains$next$a354, trains$next$a289, trains$next$a353);
  and trains$next$a355$g (trains$next$a355, trains$next$a289, trains$next$a353);
  or trains$next$a356$g (trains$next$a356, trains$next$a289$not, trains$next$a355);
  xor trains$next$a357$g (trains$next$a357, trains$next$a289, trains$next$a356);
  and trains$next$a358$g (trains$next$a358, trains$next$a289, trains$next$a356);
  or trains$next$a359$g (trains$next$a359, trains$next$a289$not, trains$next$a358);
  xor trains$next$a360$g (trains$next$a360, trains$next$a289, trains$next$a359);
  and trains$next$a361$g (trains$next$a361, trains$next$a289, trains$next$a359);
  or trains$next$a362$g (trains$next$a362, trains$next$a289$not, trains$next$a361);
  xor trains$next$a363$g (trains$next$a363, trains$next$a289, trains$next$a362);
  and trains$next$a364$g (trains$next$a364, trains$next$a289, trains$next$a362);
  or trains$next$a365$g (trains$next$a365, trains$next$a289$not, trains$next$a364);
  xor trains$next$a366$g (trains$next$a366, trains$next$a289, trains$next$a365);
  and trains$next$a367$g (trains$next$a367, trains$next$a289, trains$next$a365);
  or trains$next$a368$g (trains$next$a368, trains$next$a289$not, trains$next$a367);
  xor trains$next$a369$g (trains$next$a369, trains$next$a289, trains$next$a368);
  and trains$next$a370$g (trains$next$a370, trains$next$a289, trains$next$a368);
  or trains$next$a371$g (trains$next$a371, trains$next$a289$not, trains$next$a370);
  xor trains$next$a372$g (trains$next$a372, trains$next$a289, trains$next$a371);
  and trains$next$a373$g (trains$next$a373, trains$next$a289, trains$next$a371);
  or trains$next$a374$g (trains$next$a374, trains$next$a289$not, trains$next$a373);
  xor trains$next$a375$g (trains$next$a375, trains$next$a289, trains$next$a374);
  and trains$next$a376$g (trains$next$a376, trains$next$a289, trains$next$a374);
  or trains$next$a377$g (trains$next$a377, trains$next$a289$not, trains$next$a376);
  xor trains$next$a378$g (trains$next$a378, trains$next$a289, trains$next$a377);
  and trains$next$a379$g (trains$next$a379, trains$next$a289, trains$next$a377);
  or trains$next$a380$g (trains$next$a380, trains$next$a289$not, trains$next$a379);
  xor trains$next$a381$g (trains$next$a381, trains$next$a289, trains$next$a380);
  and trains$next$a382$g (trains$next$a382, trains$next$a289, trains$next$a380);
  or trains$next$a383$g (trains$next$a383, trains$next$a289$not, trains$next$a382);
  xor trains$next$a384$g (trains$next$a384, trains$next$a289, trains$next$a383);
  and trains$next$a385$g (trains$next$a385, trains$next$a289, trains$next$a383);
  or trains$next$a386$g (trains$next$a386, trains$next$a289$not, trains$next$a385);
  xor trains$next$a387$g (trains$next$a387, trains$next$a289, trains$next$a386);
  and trains$next$a388$g (trains$next$a388, trains$next$a289, trains$next$a386);
  or trains$next$a389$g (trains$next$a389, trains$next$a289$not, trains$next$a388);
  xor trains$next$a390$g (trains$next$a390, trains$next$a289, trains$next$a389);
  and trains$next$a391$g (trains$next$a391, trains$next$a289, trains$next$a389);
  or trains$next$a392$g (trains$next$a392, trains$next$a289$not, trains$next$a391);
  xor trains$next$a393$g (trains$next$a393, trains$next$a289, trains$next$a392);
  and trains$next$a394$g (trains$next$a394, trains$next$a289, trains$next$a392);
  or trains$next$a395$g (trains$next$a395, trains$next$a289$not, trains$next$a394);
  xor trains$next$a396$g (trains$next$a396, trains$next$a289, trains$next$a395);
  and trains$next$a397$g (trains$next$a397, trains$next$a289, trains$next$a395);
  or trains$next$a398$g (trains$next$a398, trains$next$a289$not, trains$next$a397);
  xor trains$next$a399$g (trains$next$a399, trains$next$a289, trains$next$a398);
  and trains$next$a400$g (trains$next$a400, trains$next$a289, trains$next$a398);
  or trains$next$a401$g (trains$next$a401, trains$next$a289$not, trains$next$a400);
  xor trains$next$a402$g (trains$next$a402, trains$next$a289, trains$next$a401);
  and trains$next$a403$g (trains$next$a403, trains$next$a289, trains$next$a401);
  or trains$next$a404$g (trains$next$a404, trains$next$a289$not, trains$next$a403);
  xor trains$next$a405$g (trains$next$a405, trains$next$a289, trains$next$a404);
  and trains$next$a406$g (trains$next$a406, trains$next$a289, trains$next$a404);
  or trains$next$a407$g (trains$next$a407, trains$next$a289$not, trains$next$a406);
  xor trains$next$a408$g (trains$next$a408, trains$next$a289, trains$next$a407);
  and trains$next$a409$g (trains$next$a409, trains$next$a289, trains$next$a407);
  or trains$next$a410$g (trains$next$a410, trains$next$a289$not, trains$next$a409);
  xor trains$next$a411$g (trains$next$a411, trains$next$a289, trains$next$a410);
  and trains$next$a412$g (trains$next$a412, trains$next$a289, trains$next$a410);
  or trains$next$a413$g (trains$next$a413, trains$next$a289$not, trains$next$a412);
  xor trains$next$a414$g (trains$next$a414, trains$next$a289, trains$next$a413);
  and trains$next$a415$g (trains$next$a415, trains$next$a289, trains$next$a413);
  or trains$next$a416$g (trains$next$a416, trains$next$a289$not, trains$next$a415);
  xor trains$next$a417$g (trains$next$a417, trains$next$a289, trains$next$a416);
  and trains$next$a418$g (trains$next$a418, trains$next$a289, trains$next$a416);
  or trains$next$a419$g (trains$next$a419, trains$next$a289$not, trains$next$a418);
  xor trains$next$a420$g (trains$next$a420, trains$next$a289, trains$next$a419);
  and trains$next$a421$g (trains$next$a421, trains$next$a289, trains$next$a419);
  or trains$next$a422$g (trains$next$a422, trains$next$a289$not, trains$next$a421);
  xor trains$next$a423$g (trains$next$a423, trains$next$a289, trains$next$a422);
  and trains$next$a424$g (trains$next$a424, trains$next$a289, trains$next$a422);
  or trains$next$a425$g (trains$next$a425, trains$next$a289$not, trains$next$a424);
  xor trains$next$a426$g (trains$next$a426, trains$next$a289, trains$next$a425);
  and trains$next$a427$g (trains$next$a427, trains$next$a289, trains$next$a425);
  or trains$next$a428$g (trains$next$a428, trains$next$a289$not, trains$next$a427);
  xor trains$next$a429$g (trains$next$a429, trains$next$a289, trains$next$a428);
  and trains$next$a430$g (trains$next$a430, trains$next$a289, trains$next$a428);
  or trains$next$a431$g (trains$next$a431, trains$next$a289$not, trains$next$a430);
  xor trains$next$a432$g (trains$next$a432, trains$next$a289, trains$next$a431);
  and trains$next$a433$g (trains$next$a433, trains$next$a289, trains$next$a431);
  or trains$next$a434$g (trains$next$a434, trains$next$a289$not, trains$next$a433);
  xor trains$next$a435$g (trains$next$a435, trains$next$a289, trains$next$a434);
  and trains$next$a436$g (trains$next$a436, trains$next$a289, trains$next$a434);
  or trains$next$a437$g (trains$next$a437, trains$next$a289$not, trains$next$a436);
  xor trains$next$a438$g (trains$next$a438, trains$next$a289, trains$next$a437);
  and trains$next$a439$g (trains$next$a439, trains$next$a289, trains$next$a437);
  or trains$next$a440$g (trains$next$a440, trains$next$a289$not, trains$next$a439);
  xor trains$next$a441$g (trains$next$a441, trains$next$a289, trains$next$a440);
  and trains$next$a442$g (trains$next$a442, trains$next$a289, trains$next$a440);
  or trains$next$a443$g (trains$next$a443, trains$next$a289$not, trains$next$a442);
  xor trains$next$a444$g (trains$next$a444, trains$next$a289, trains$next$a443);
  and trains$next$a445$g (trains$next$a445, trains$next$a289, trains$next$a443);
  or trains$next$a446$g (trains$next$a446, trains$next$a289$not, trains$next$a445);
  xor trains$next$a447$g (trains$next$a447, trains$next$a289, trains$next$a446);
  and trains$next$a448$g (trains$next$a448, trains$next$a289, trains$next$a446);
  or trains$next$a449$g (trains$next$a449, trains$next$a289$not, trains$next$a448);
  xor trains$next$a450$g (trains$next$a450, trains$next$a289, trains$next$a449);
  and trains$next$a451$g (trains$next$a451, trains$next$a289, trains$next$a449);
  or trains$next$a452$g (trains$next$a452, trains$next$a289$not, trains$next$a451);
  xor trains$next$a453$g (trains$next$a453, trains$next$a289, trains$next$a452);
  and trains$next$a454$g (trains$next$a454, trains$next$a289, trains$next$a452);
  or trains$next$a455$g (trains$next$a455, trains$next$a289$not, trains$next$a454);
  xor trains$next$a456$g (trains$next$a456, trains$next$a289, trains$next$a455);
  and trains$next$a457$g (trains$next$a457, trains$next$a289, trains$next$a455);
  or trains$next$a458$g (trains$next$a458, trains$next$a289$not, trains$next$a457);
  xor trains$next$a459$g (trains$next$a459, trains$next$a289, trains$next$a458);
  and trains$next$a460$g (trains$next$a460, trains$next$a289, trains$next$a458);
  or trains$next$a461$g (trains$next$a461, trains$next$a289$not, trains$next$a460);
  xor trains$next$a462$g (trains$next$a462, trains$next$a289, trains$next$a461);
  and trains$next$a463$g (trains$next$a463, trains$next$a289, trains$next$a461);
  or trains$next$a464$g (trains$next$a464, trains$next$a289$not, trains$next$a463);
  xor trains$next$a465$g (trains$next$a465, trains$next$a289, trains$next$a464);
  and trains$next$a466$g (trains$next$a466, trains$next$a289, trains$next$a464);
  or trains$next$a467$g (trains$next$a467, trains$next$a289$not, trains$next$a466);
  xor trains$next$a468$g (trains$next$a468, trains$next$a289, trains$next$a467);
  and trains$next$a469$g (trains$next$a469, trains$next$a289, trains$next$a467);
  or trains$next$a470$g (trains$next$a470, trains$next$a289$not, trains$next$a469);
  xor trains$next$a471$g (trains$next$a471, trains$next$a289, trains$next$a470);
  and trains$next$a472$g (trains$next$a472, trains$next$a289, trains$next$a470);
  or trains$next$a473$g (trains$next$a473, trains$next$a289$not, trains$next$a472);
  xor trains$next$a474$g (trains$next$a474, trains$next$a289, trains$next$a473);
  and trains$next$a475$g (trains$next$a475, trains$next$a289, trains$next$a473);
  or trains$next$a476$g (trains$next$a476, trains$next$a289$not, trains$next$a475);
  xor trains$next$a477$g (trains$next$a477, trains$next$a289, trains$next$a476);
  and trains$next$a478$g (trains$next$a478, trains$next$a289, trains$next$a476);
  or trains$next$a479$g (trains$next$a479, trains$next$a289$not, trains$next$a478);
  xor trains$next$a480$g (trains$next$a480, trains$next$a289, trains$next$a479);
  and trains$next$a481$g (trains$next$a481, trains$next$a289, trains$next$a479);
  or trains$next$a482$g (trains$next$a482, trains$next$a289$not, trains$next$a481);
  xor trains$next$a483$g (trains$next$a483, trains$next$a289, trains$next$a482);
  xor trains$next$a484$g (trains$next$a484, trains$next$a291, trains$q0$not);
  and trains$next$a485$g (trains$next$a485, trains$next$a291, trains$q0$not);
  not trains$next$a294$not$g (trains$next$a294$not, trains$next$a294);
  xor trains$next$a486$g (trains$next$a486, trains$next$a294$not, trains$next$a485);
  and trains$next$a487$g (trains$next$a487, trains$next$a294$not, trains$next$a485);
  or trains$next$a488$g (trains$next$a488, trains$next$a294, trains$next$a487);
  not trains$next$a297$not$g (trains$next$a297$not, trains$next$a297);
  xor trains$next$a489$g (trains$next$a489, trains$next$a297$not, trains$next$a488);
  and trains$next$a490$g (trains$next$a490, trains$next$a297$not, trains$next$a488);
  or trains$next$a491$g (trains$next$a491, trains$next$a297, trains$next$a490);
  not trains$next$a300$not$g (trains$next$a300$not, trains$next$a300);
  xor trains$next$a492$g (trains$next$a492, trains$next$a300$not, trains$next$a491);
  and trains$next$a493$g (trains$next$a493, trains$next$a300$not, trains$next$a491);
  or trains$next$a494$g (trains$next$a494, trains$next$a300, trains$next$a493);
  not trains$next$a303$not$g (trains$next$a303$not, trains$next$a303);
  xor trains$next$a495$g (trains$next$a495, trains$next$a303$not, trains$next$a494);
  and trains$next$a496$g (trains$next$a496, trains$next$a303$not, trains$next$a494);
  or trains$next$a497$g (trains$next$a497, trains$next$a303, trains$next$a496);
  not trains$next$a306$not$g (trains$next$a306$not, trains$next$a306);
  xor trains$next$a498$g (trains$next$a498, trains$next$a306$not, trains$next$a497);
  and trains$next$a499$g (trains$next$a499, trains$next$a306$not, trains$next$a497);
  or trains$next$a500$g (trains$next$a500, trains$next$a306, trains$next$a499);
  not trains$next$a309$not$g (trains$next$a309$not, trains$next$a309);
  xor trains$next$a501$g (trains$next$a501, trains$next$a309$not, trains$next$a500);
  and trains$next$a502$g (trains$next$a502, trains$next$a309$not, trains$next$a500);
  or trains$next$a503$g (trains$next$a503, trains$next$a309, trains$next$a502);
  not trains$next$a312$not$g (trains$next$a312$not, trains$next$a312);
  xor trains$next$a504$g (trains$next$a504, trains$next$a312$not, trains$next$a503);
  and trains$next$a505$g (trains$next$a505, trains$next$a312$not, trains$next$a503);
  or trains$next$a506$g (trains$next$a506, trains$next$a312, trains$next$a505);
  not trains$next$a315$not$g (trains$next$a315$not, trains$next$a315);
  xor trains$next$a507$g (trains$next$a507, trains$next$a315$not, trains$next$a506);
  and trains$next$a508$g (trains$next$a508, trains$next$a315$not, trains$next$a506);
  or trains$next$a509$g (trains$next$a509, trains$next$a315, trains$next$a508);
  not trains$next$a318$not$g (trains$next$a318$not, trains$next$a318);
  xor trains$next$a510$g (trains$next$a510, trains$next$a318$not, trains$next$a509);
  and trains$next$a511$g (trains$next$a511, trains$next$a318$not, trains$next$a509);
  or trains$next$a512$g (trains$next$a512, trains$next$a318, trains$next$a511);
  not trains$next$a321$not$g (trains$next$a321$not, trains$next$a321);
  xor trains$next$a513$g (trains$next$a513, trains$next$a321$not, trains$next$a512);
  and trains$next$a514$g (trains$next$a514, trains$next$a321$not, trains$next$a512);
  or trains$next$a515$g (trains$next$a515, trains$next$a321, trains$next$a514);
  not trains$next$a324$not$g (trains$next$a324$not, trains$next$a324);
  xor trains$next$a516$g (trains$next$a516, trains$next$a324$not, trains$next$a515);
  and trains$next$a517$g (trains$next$a517, trains$next$a324$not, trains$next$a515);
  or trains$next$a518$g (trains$next$a518, trains$next$a324, trains$next$a517);
  not trains$next$a327$not$g (trains$next$a327$not, trains$next$a327);
  xor trains$next$a519$g (trains$next$a519, trains$next$a327$not, trains$next$a518);
  and trains$next$a520$g (trains$next$a520, trains$next$a327$not, trains$next$a518);
  or trains$next$a521$g (trains$next$a521, trains$next$a327, trains$next$a520);
  not trains$next$a330$not$g (trains$next$a330$not, trains$next$a330);
  xor trains$next$a522$g (trains$next$a522, trains$next$a330$not, trains$next$a521);
  and trains$next$a523$g (trains$next$a523, trains$next$a330$not, trains$next$a521);
  or trains$next$a524$g (trains$next$a524, trains$next$a330, trains$next$a523);
  not trains$next$a333$not$g (trains$next$a333$not, trains$next$a333);
  xor trains$next$a525$g (trains$next$a525, trains$next$a333$not, trains$next$a524);
  and trains$next$a526$g (trains$next$a526, trains$next$a333$not, trains$next$a524);
  or trains$next$a527$g (trains$next$a527, trains$next$a333, trains$next$a526);
  not trains$next$a336$not$g (trains$next$a336$not, trains$next$a336);
  xor trains$next$a528$g (trains$next$a528, trains$next$a336$not, trains$next$a527);
  and trains$next$a529$g (trains$next$a529, trains$next$a336$not, trains$next$a527);
  or trains$next$a530$g (trains$next$a530, trains$next$a336, trains$next$a529);
  not trains$next$a339$not$g (trains$next$a339$not, trains$next$a339);
  xor trains$next$a531$g (trains$next$a531, trains$next$a339$not, trains$next$a530);
  and trains$next$a532$g (trains$next$a532, trains$next$a339$not, trains$next$a530);
  or trains$next$a533$g (trains$next$a533, trains$next$a339, trains$next$a532);
  not trains$next$a342$not$g (trains$next$a342$not, trains$next$a342);
  xor trains$next$a534$g (trains$next$a534, trains$next$a342$not, trains$next$a533);
  and trains$next$a535$g (trains$next$a535, trains$next$a342$not, trains$next$a533);
  or trains$next$a536$g (trains$next$a536, trains$next$a342, trains$next$a535);
  not trains$next$a345$not$g (trains$next$a345$not, trains$next$a345);
  xor trains$next$a537$g (trains$next$a537, trains$next$a345$not, trains$next$a536);
  and trains$next$a538$g (trains$next$a538, trains$next$a345$not, trains$next$a536);
  or trains$next$a539$g (trains$next$a539, trains$next$a345, trains$next$a538);
  not trains$next$a348$not$g (trains$next$a348$not, trains$next$a348);
  xor trains$next$a540$g (trains$next$a540, trains$next$a348$not, trains$next$a539);
  and trains$next$a541$g (trains$next$a541, trains$next$a348$not, trains$next$a539);
  or trains$next$a542$g (trains$next$a542, trains$next$a348, trains$next$a541);
  not trains$next$a351$not$g (trains$next$a351$not, trains$next$a351);
  xor trains$next$a543$g (trains$next$a543, trains$next$a351$not, trains$next$a542);
  and trains$next$a544$g (trains$next$a544, trains$next$a351$not, trains$next$a542);
  or trains$next$a545$g (trains$next$a545, trains$next$a351, trains$next$a544);
  not trains$next$a354$not$g (trains$next$a354$not, trains$next$a354);
  xor trains$next$a546$g (trains$next$a546, trains$next$a354$not, trains$next$a545);
  and trains$next$a547$g (trains$next$a547, trains$next$a354$not, trains$next$a545);
  or trains$next$a548$g (trains$next$a548, trains$next$a354, trains$next$a547);
  not trains$next$a357$not$g (trains$next$a357$not, trains$next$a357);
  xor trains$next$a549$g (trains$next$a549, trains$next$a357$not, trains$next$a548);
  and trains$next$a550$g (trains$next$a550, trains$next$a357$not, trains$next$a548);
  or trains$next$a551$g (trains$next$a551, trains$next$a357, trains$next$a550);
  not trains$next$a360$not$g (trains$next$a360$not, trains$next$a360);
  xor trains$next$a552$g (trains$next$a552, trains$next$a360$not, trains$next$a551);
  and trains$next$a553$g (trains$next$a553, trains$next$a360$not, trains$next$a551);
  or trains$next$a554$g (trains$next$a554, trains$next$a360, trains$next$a553);
  not trains$next$a363$not$g (trains$next$a363$not, trains$next$a363);
  xor trains$next$a555$g (trains$next$a555, trains$next$a363$not, trains$next$a554);
  and trains$next$a556$g (trains$next$a556, trains$next$a363$not, trains$next$a554);
  or trains$next$a557$g (trains$next$a557, trains$next$a363, trains$next$a556);
  not trains$next$a366$not$g (trains$next$a366$not, trains$next$a366);
  xor trains$next$a558$g (trains$next$a558, trains$next$a366$not, trains$next$a557);
  and trains$next$a559$g (trains$next$a559, trains$next$a366$not, trains$next$a557);
  or trains$next$a560$g (trains$next$a560, trains$next$a366, trains$next$a559);
  not trains$next$a369$not$g (trains$next$a369$not, trains$next$a369);
  xor trains$next$a561$g (trains$next$a561, trains$next$a369$not, trains$next$a560);
  and trains$next$a562$g (trains$next$a562, trains$next$a369$not, trains$next$a560);
  or trains$next$a563$g (trains$next$a563, trains$next$a369, trains$next$a562);
  not trains$next$a372$not$g (trains$next$a372$not, trains$next$a372);
  xor trains$next$a564$g (trains$next$a564, trains$next$a372$not, trains$next$a563);
  and trains$next$a565$g (trains$next$a565, trains$next$a372$not, trains$next$a563);
  or trains$next$a566$g (trains$next$a566, trains$next$a372, trains$next$a565);
  not trains$next$a375$not$g (trains$next$a375$not, trains$next$a375);
  xor trains$next$a567$g (trains$next$a567, trains$next$a375$not, trains$next$a566);
  and trains$next$a568$g (trains$next$a568, trains$next$a375$not, trains$next$a566);
  or trains$next$a569$g (trains$next$a569, trains$next$a375, trains$next$a568);
  not trains$next$a378$not$g (trains$next$a378$not, trains$next$a378);
  xor trains$next$a570$g (trains$next$a570, trains$next$a378$not, trains$next$a569);
  and trains$next$a571$g (trains$next$a571, trains$next$a378$not, trains$next$a569);
  or trains$next$a572$g (trains$next$a572, trains$next$a378, trains$next$a571);
  not trains$next$a381$not$g (trains$next$a381$not, trains$next$a381);
  xor trains$next$a573$g (trains$next$a573, trains$next$a381$not, trains$next$a572);
  and trains$next$a574$g (trains$next$a574, trains$next$a381$not, trains$next$a572);
  or trains$next$a575$g (trains$next$a575, trains$next$a381, trains$next$a574);
  not trains$next$a384$not$g (trains$next$a384$not, trains$next$a384);
  xor trains$next$a576$g (trains$next$a576, trains$next$a384$not, trains$next$a575);
  and trains$next$a577$g (trains$next$a577, trains$next$a384$not, trains$next$a575);
  or trains$next$a578$g (trains$next$a578, trains$next$a384, trains$next$a577);
  not trains$next$a387$not$g (trains$next$a387$not, trains$next$a387);
  xor trains$next$a579$g (trains$next$a579, trains$next$a387$not, trains$next$a578);
  and trains$next$a580$g (trains$next$a580, trains$next$a387$not, trains$next$a578);
  or trains$next$a581$g (trains$next$a581, trains$next$a387, trains$next$a580);
  not trains$next$a390$not$g (trains$next$a390$not, trains$next$a390);
  xor trains$next$a582$g (trains$next$a582, trains$next$a390$not, trains$next$a581);
  and trains$next$a583$g (trains$next$a583, trains$next$a390$not, trains$next$a581);
  or trains$next$a584$g (trains$next$a584, trains$next$a390, trains$next$a583);
  not trains$next$a393$not$g (trains$next$a393$not, trains$next$a393);
  xor trains$next$a585$g (trains$next$a585, trains$next$a393$not, trains$next$a584);
  and trains$next$a586$g (trains$next$a586, trains$next$a393$not, trains$next$a584);
  or trains$next$a587$g (trains$next$a587, trains$next$a393, trains$next$a586);
  not trains$next$a396$not$g (trains$next$a396$not, trains$next$a396);
  xor trains$next$a588$g (trains$next$a588, trains$next$a396$not, trains$next$a587);
  and trains$next$a589$g (trains$next$a589, trains$next$a396$not, trains$next$a587);
  or trains$next$a590$g (trains$next$a590, trains$next$a396, trains$next$a589);
  not trains$next$a399$not$g (trains$next$a399$not, trains$next$a399);
  xor trains$next$a591$g (trains$next$a591, trains$next$a399$not, trains$next$a590);
  and trains$next$a592$g (trains$next$a592, trains$next$a399$not, trains$next$a590);
  or trains$next$a593$g (trains$next$a593, trains$next$a399, trains$next$a592);
  not trains$next$a402$not$g (trains$next$a402$not, trains$next$a402);
  xor trains$next$a594$g (trains$next$a594, trains$next$a402$not, trains$next$a593);
  and trains$next$a595$g (trains$next$a595, trains$next$a402$not, trains$next$a593);
  or trains$next$a596$g (trains$next$a596, trains$next$a402, trains$next$a595);
  not trains$next$a405$not$g (trains$next$a405$not, trains$next$a405);
  xor trains$next$a597$g (trains$next$a597, trains$next$a405$not, trains$next$a596);
  and trains$next$a598$g (trains$next$a598, trains$next$a405$not, trains$next$a596);
  or trains$next$a599$g (trains$next$a599, trains$next$a405, trains$next$a598);
  not trains$next$a408$not$g (trains$next$a408$not, trains$next$a408);
  xor trains$next$a600$g (trains$next$a600, trains$next$a408$not, trains$next$a599);
  and trains$next$a601$g (trains$next$a601, trains$next$a408$not, trains$next$a599);
  or trains$next$a602$g (trains$next$a602, trains$next$a408, trains$next$a601);
  not trains$next$a411$not$g (trains$next$a411$not, trains$next$a411);
  xor trains$next$a603$g (trains$next$a603, trains$next$a411$not, trains$next$a602);
  and trains$next$a604$g (trains$next$a604, trains$next$a411$not, trains$next$a602);
  or trains$next$a605$g (trains$next$a605, trains$next$a411, trains$next$a604);
  not trains$next$a414$not$g (trains$next$a414$not, trains$next$a414);
  xor trains$next$a606$g (trains$next$a606, trains$next$a414$not, trains$next$a605);
  and trains$next$a607$g (trains$next$a607, trains$next$a414$not, trains$next$a605);
  or trains$next$a608$g (trains$next$a608, trains$next$a414, trains$next$a607);
  not trains$next$a417$not$g (trains$next$a417$not, trains$next$a417);
  xor trains$next$a609$g (trains$next$a609, trains$next$a417$not, trains$next$a608);
  and trains$next$a610$g (trains$next$a610, trains$next$a417$not, trains$next$a608);
  or trains$next$a611$g (trains$next$a611, trains$next$a417, trains$next$a610);
  not trains$next$a420$not$g (trains$next$a420$not, trains$next$a420);
  xor trains$next$a612$g (trains$next$a612, trains$next$a420$not, trains$next$a611);
  and trains$next$a613$g (trains$next$a613, trains$next$a420$not, trains$next$a611);
  or trains$next$a614$g (trains$next$a614, trains$next$a420, trains$next$a613);
  not trains$next$a423$not$g (trains$next$a423$not, trains$next$a423);
  xor trains$next$a615$g (trains$next$a615, trains$next$a423$not, trains$next$a614);
  and trains$next$a616$g (trains$next$a616, trains$next$a423$not, trains$next$a614);
  or trains$next$a617$g (trains$next$a617, trains$next$a423, trains$next$a616);
  not trains$next$a426$not$g (trains$next$a426$not, trains$next$a426);
  xor trains$next$a618$g (trains$next$a618, trains$next$a426$not, trains$next$a617);
  and trains$next$a619$g (trains$next$a619, trains$next$a426$not, trains$next$a617);
  or trains$next$a620$g (trains$next$a620, trains$next$a426, trains$next$a619);
  not trains$next$a429$not$g (trains$next$a429$not, trains$next$a429);
  xor trains$next$a621$g (trains$next$a621, trains$next$a429$not, trains$next$a620);
  and trains$next$a622$g (trains$next$a622, trains$next$a429$not, trains$next$a620);
  or trains$next$a623$g (trains$next$a623, trains$next$a429, trains$next$a622);
  not trains$next$a432$not$g (trains$next$a432$not, trains$next$a432);
  xor trains$next$a624$g (trains$next$a624, trains$next$a432$not, trains$next$a623);
  and trains$next$a625$g (trains$next$a625, trains$next$a432$not, trains$next$a623);
  or trains$next$a626$g (trains$next$a626, trains$next$a432, trains$next$a625);
  not trains$next$a435$not$g (trains$next$a435$not, trains$next$a435);
  xor trains$next$a627$g (trains$next$a627, trains$next$a435$not, trains$next$a626);
  and trains$next$a628$g (trains$next$a628, trains$next$a435$not, trains$next$a626);
  or trains$next$a629$g (trains$next$a629, trains$next$a435, trains$next$a628);
  not trains$next$a438$not$g (trains$next$a438$not, trains$next$a438);
  xor trains$next$a630$g (trains$next$a630, trains$next$a438$not, trains$next$a629);
  and trains$next$a631$g (trains$next$a631, trains$next$a438$not, trains$next$a629);
  or trains$next$a632$g (trains$next$a632, trains$next$a438, trains$next$a631);
  not trains$next$a441$not$g (trains$next$a441$not, trains$next$a441);
  xor trains$next$a633$g (trains$next$a633, trains$next$a441$not, trains$next$a632);
  and trains$next$a634$g (trains$next$a634, trains$next$a441$not, trains$next$a632);
  or trains$next$a635$g (trains$next$a635, trains$next$a441, trains$next$a634);
  not trains$next$a444$not$g (trains$next$a444$not, trains$next$a444);
  xor trains$next$a636$g (trains$next$a636, trains$next$a444$not, trains$next$a635);
  and trains$next$a637$g (trains$next$a637, trains$next$a444$not, trains$next$a635);
  or trains$next$a638$g (trains$next$a638, trains$next$a444, trains$next$a637);
  not trains$next$a447$not$g (trains$next$a447$not, trains$next$a447);
  xor trains$next$a639$g (trains$next$a639, trains$next$a447$not, trains$next$a638);
  and trains$next$a640$g (trains$next$a640, trains$next$a447$not, trains$next$a638);
  or trains$next$a641$g (trains$next$a641, trains$next$a447, trains$next$a640);
  not trains$next$a450$not$g (trains$next$a450$not, trains$next$a450);
  xor trains$next$a642$g (trains$next$a642, trains$next$a450$not, trains$next$a641);
  and trains$next$a643$g (trains$next$a643, trains$next$a450$not, trains$next$a641);
  or trains$next$a644$g (trains$next$a644, trains$next$a450, trains$next$a643);
  not trains$next$a453$not$g (trains$next$a453$not, trains$next$a453);
  xor trains$next$a645$g (trains$next$a645, trains$next$a453$not, trains$next$a644);
  and trains$next$a646$g (trains$next$a646, trains$next$a453$not, trains$next$a644);
  or trains$next$a647$g (trains$next$a647, trains$next$a453, trains$next$a646);
  not trains$next$a456$not$g (trains$next$a456$not, trains$next$a456);
  xor trains$next$a648$g (trains$next$a648, trains$next$a456$not, trains$next$a647);
  and trains$next$a649$g (trains$next$a649, trains$next$a456$not, trains$next$a647);
  or trains$next$a650$g (trains$next$a650, trains$next$a456, trains$next$a649);
  not trains$next$a459$not$g (trains$next$a459$not, trains$next$a459);
  xor trains$next$a651$g (trains$next$a651, trains$next$a459$not, trains$next$a650);
  and trains$next$a652$g (trains$next$a652, trains$next$a459$not, trains$next$a650);
  or trains$next$a653$g (trains$next$a653, trains$next$a459, trains$next$a652);
  not trains$next$a462$not$g (trains$next$a462$not, trains$next$a462);
  xor trains$next$a654$g (trains$next$a654, trains$next$a462$not, trains$next$a653);
  and trains$next$a655$g (trains$next$a655, trains$next$a462$not, trains$next$a653);
  or trains$next$a656$g (trains$next$a656, trains$next$a462, trains$next$a655);
  not trains$next$a465$not$g (trains$next$a465$not, trains$next$a465);
  xor trains$next$a657$g (trains$next$a657, trains$next$a465$not, trains$next$a656);
  and trains$next$a658$g (trains$next$a658, trains$next$a465$not, trains$next$a656);
  or trains$next$a659$g (trains$next$a659, trains$next$a465, trains$next$a658);
  not trains$next$a468$not$g (trains$next$a468$not, trains$next$a468);
  xor trains$next$a660$g (trains$next$a660, trains$next$a468$not, trains$next$a659);
  and trains$next$a661$g (trains$next$a661, trains$next$a468$not, trains$next$a659);
  or trains$next$a662$g (trains$next$a662, trains$next$a468, trains$next$a661);
  not trains$next$a471$not$g (trains$next$a471$not, trains$next$a471);
  xor trains$next$a663$g (trains$next$a663, trains$next$a471$not, trains$next$a662);
  and trains$next$a664$g (trains$next$a664, trains$next$a471$not, trains$next$a662);
  or trains$next$a665$g (trains$next$a665, trains$next$a471, trains$next$a664);
  not trains$next$a474$not$g (trains$next$a474$not, trains$next$a474);
  xor trains$next$a666$g (trains$next$a666, trains$next$a474$not, trains$next$a665);
  and trains$next$a667$g (trains$next$a667, trains$next$a474$not, trains$next$a665);
  or trains$next$a668$g (trains$next$a668, trains$next$a474, trains$next$a667);
  not trains$next$a477$not$g (trains$next$a477$not, trains$next$a477);
  xor trains$next$a669$g (trains$next$a669, trains$next$a477$not, trains$next$a668);
  and trains$next$a670$g (trains$next$a670, trains$next$a477$not, trains$next$a668);
  or trains$next$a671$g (trains$next$a671, trains$next$a477, trains$next$a670);
  not trains$next$a480$not$g (trains$next$a480$not, trains$next$a480);
  xor trains$next$a672$g (trains$next$a672, trains$next$a480$not, trains$next$a671);
  and trains$next$a673$g (trains$next$a673, trains$next$a480$not, trains$next$a671);
  or trains$next$a674$g (trains$next$a674, trains$next$a480, trains$next$a673);
  not trains$next$a483$not$g (trains$next$a483$not, trains$next$a483);
  xor trains$next$a675$g (trains$next$a675, trains$next$a483$not, trains$next$a674);
  and trains$next$a676$g (trains$next$a676, trains$next$a483$not, trains$next$a674);
  or trains$next$a677$g (trains$next$a677, trains$next$a483, trains$next$a676);
  xor trains$next$a678$g (trains$next$a678, trains$next$a483$not, trains$next$a677);
  or trains$next$a679$g (trains$next$a679, trains$q0, trains$next$a484);
  or trains$next$a680$g (trains$next$a680, trains$next$a679, trains$next$a486);
  or trains$next$a681$g (trains$next$a681, trains$next$a680, trains$next$a489);
  or trains$next$a682$g (trains$next$a682, trains$next$a681, trains$next$a492);
  or trains$next$a683$g (trains$next$a683, trains$next$a682, trains$next$a495);
  or trains$next$a684$g (trains$next$a684, trains$next$a683, trains$next$a498);
  or trains$next$a685$g (trains$next$a685, trains$next$a684, trains$next$a501);
  or trains$next$a686$g (trains$next$a686, trains$next$a685, trains$next$a504);
  or trains$next$a687$g (trains$next$a687, trains$next$a686, trains$next$a507);
  or trains$next$a688$g (trains$next$a688, trains$next$a687, trains$next$a510);
  or trains$next$a689$g (trains$next$a689, trains$next$a688, trains$next$a513);
  or trains$next$a690$g (trains$next$a690, trains$next$a689, trains$next$a516);
  or trains$next$a691$g (trains$next$a691, trains$next$a690, trains$next$a519);
  or trains$next$a692$g (trains$next$a692, trains$next$a691, trains$next$a522);
  or trains$next$a693$g (trains$next$a693, trains$next$a692, trains$next$a525);
  or trains$next$a694$g (trains$next$a694, trains$next$a693, trains$next$a528);
  or trains$next$a695$g (trains$next$a695, trains$next$a694, trains$next$a531);
  or trains$next$a696$g (trains$next$a696, trains$next$a695, trains$next$a534);
  or trains$next$a697$g (trains$next$a697, trains$next$a696, trains$next$a537);
  or trains$next$a698$g (trains$next$a698, trains$next$a697, trains$next$a540);
  or trains$next$a699$g (trains$next$a699, trains$next$a698, trains$next$a543);
  or trains$next$a700$g (trains$next$a700, trains$next$a699, trains$next$a546);
  or trains$next$a701$g (trains$next$a701, trains$next$a700, trains$next$a549);
  or trains$next$a702$g (trains$next$a702, trains$next$a701, trains$next$a552);
  or trains$next$a703$g (trains$next$a703, trains$next$a702, trains$next$a555);
  or trains$next$a704$g (trains$next$a704, trains$next$a703, trains$next$a558);
  or trains$next$a705$g (trains$next$a705, trains$next$a704, trains$next$a561);
  or trains$next$a706$g (trains$next$a706, trains$next$a705, trains$next$a564);
  or trains$next$a707$g (trains$next$a707, trains$next$a706, trains$next$a567);
  or trains$next$a708$g (trains$next$a708, trains$next$a707, trains$next$a570);
  or trains$next$a709$g (trains$next$a709, trains$next$a708, trains$next$a573);
  or trains$next$a710$g (trains$next$a710, trains$next$a709, trains$next$a576);
  or trains$next$a711$g (trains$next$a711, trains$next$a710, trains$next$a579);
  or trains$next$a712$g (trains$next$a712, trains$next$a711, trains$next$a582);
  or trains$next$a713$g (trains$next$a713, trains$next$a712, trains$next$a585);
  or trains$next$a714$g (trains$next$a714, trains$next$a713, trains$next$a588);
  or trains$next$a715$g (trains$next$a715, trains$next$a714, trains$next$a591);
  or trains$next$a716$g (trains$next$a716, trains$next$a715, trains$next$a594);
  or trains$next$a717$g (trains$next$a717, trains$next$a716, trains$next$a597);
  or trains$next$a718$g (trains$next$a718, trains$next$a717, trains$next$a600);
  or trains$next$a719$g (trains$next$a719, trains$next$a718, trains$next$a603);
  or trains$next$a720$g (trains$next$a720, trains$next$a719, trains$next$a606);
  or trains$next$a721$g (trains$next$a721, trains$next$a720, trains$next$a609);
  or trains$next$a722$g (trains$next$a722, trains$next$a721, trains$next$a612);
  or trains$next$a723$g (trains$next$a723, trains$next$a722, trains$next$a615);
  or trains$next$a724$g (trains$next$a724, trains$next$a723, trains$next$a618);
  or trains$next$a725$g (trains$next$a725, trains$next$a724, trains$next$a621);
  or trains$next$a726$g (trains$next$a726, trains$next$a725, trains$next$a624);
  or trains$next$a727$g (trains$next$a727, trains$next$a726, trains$next$a627);
  or trains$next$a728$g (trains$next$a728, trains$next$a727, trains$next$a630);
  or trains$next$a729$g (trains$next$a729, trains$next$a728, trains$next$a633);
  or trains$next$a730$g (trains$next$a730, trains$next$a729, trains$next$a636);
  or trains$next$a731$g (trains$next$a731, trains$next$a730, trains$next$a639);
  or trains$next$a732$g (trains$next$a732, trains$next$a731, trains$next$a642);
  or trains$next$a733$g (trains$next$a733, trains$next$a732, trains$next$a645);
  or trains$next$a734$g (trains$next$a734, trains$next$a733, trains$next$a648);
  or trains$next$a735$g (trains$next$a735, trains$next$a734, trains$next$a651);
  or trains$next$a736$g (trains$next$a736, trains$next$a735, trains$next$a654);
  or trains$next$a737$g (trains$next$a737, trains$next$a736, trains$next$a657);
  or trains$next$a738$g (trains$next$a738, trains$next$a737, trains$next$a660);
  or trains$next$a739$g (trains$next$a739, trains$next$a738, trains$next$a663);
  or trains$next$a740$g (trains$next$a740, trains$next$a739, trains$next$a666);
  or trains$next$a741$g (trains$next$a741, trains$next$a740, trains$next$a669);
  or trains$next$a742$g (trains$next$a742, trains$next$a741, trains$next$a672);
  or trains$next$a743$g (trains$next$a743, trains$next$a742, trains$next$a675);
  or trains$next$a744$g (trains$next$a744, trains$next$a743, trains$next$a678);
  not trains$next$a744$not$g (trains$next$a744$not, trains$next$a744);
  or trains$next$a745$g (trains$next$a745, trains$next$a678, trains$next$a744$not);
  not trains$next$a745$not$g (trains$next$a745$not, trains$next$a745);
  and trains$next$a746$g (trains$next$a746, trains$next$a745, trains$q0$not);
  or trains$next$a747$g (trains$next$a747, trains$next$a745$not, trains$next$a746);
  and trains$next$a748$g (trains$next$a748, trains$next$a745, trains$next$a291);
  or trains$next$a749$g (trains$next$a749, trains$next$a745$not, trains$next$a748);
  and trains$next$a750$g (trains$next$a750, trains$next$a745, trains$next$a294);
  and trains$next$a751$g (trains$next$a751, trains$next$a483$not, trains$next$a747);
  and trains$next$a752$g (trains$next$a752, trains$next$a483$not, trains$next$a749);
  and trains$next$a753$g (trains$next$a753, trains$next$a483$not, trains$next$a750);
  and trains$next$a754$g (trains$next$a754, T1$clear, trains$next$a751);
  and trains$next$a755$g (trains$next$a755, T1$clear$not, trains$next$a282);
  or trains$next$a756$g (trains$next$a756, trains$next$a754, trains$next$a755);
  and trains$next$a757$g (trains$next$a757, T1$clear, trains$next$a752);
  and trains$next$a758$g (trains$next$a758, T1$clear$not, trains$next$a285);
  or trains$next$a759$g (trains$next$a759, trains$next$a757, trains$next$a758);
  and trains$next$a760$g (trains$next$a760, T1$clear, trains$next$a753);
  and trains$next$a761$g (trains$next$a761, T1$clear$not, trains$next$a286);
  or trains$next$a762$g (trains$next$a762, trains$next$a760, trains$next$a761);
  grafwire_dff #(.INIT(1'b0)) trains$q0$g (.d(trains$next$a756), .c(clk), .q(trains$q0));
  grafwire_dff #(.INIT(1'b0)) trains$q1$g (.d(trains$next$a759), .c(clk), .q(trains$q1));

  // hindrances
  not X14$not$g (X14$not, X14);
  and hindrances$when1$g (hindrances$when1, X14$not, X14$next);
  not hindrances$q0$not$g (hindrances$q0$not, hindrances$q0);
  xor hindrances$next$a1$g (hindrances$next$a1, hindrances$q1, hindrances$q0);
  and hindrances$next$a2$g (hindrances$next$a2, hindrances$q1, hindrances$q0);
  or hindrances$next$a3$g (hindrances$next$a3, hindrances$q0$not, hindrances$q0);
  not hindrances$next$a1$not$g (hindrances$next$a1$not, hindrances$next$a1);
  xor hindrances$next$a4$g (hindrances$next$a4, hindrances$next$a1$not, hindrances$next$a3);
  and hindrances$next$a5$g (hindrances$next$a5, hindrances$next$a1$not, hindrances$next$a3);
  or hindrances$next$a6$g (hindrances$next$a6, hindrances$next$a1, hindrances$next$a5);
  not hindrances$next$a2$not$g (hindrances$next$a2$not, hindrances$next$a2);
  xor hindrances$next$a7$g (hindrances$next$a7, hindrances$next$a2$not, hindrances$next$a6);
  and hindrances$next$a8$g (hindrances$next$a8, hindrances$next$a2$not, hindrances$next$a6);
  or hindrances$next$a9$g (hindrances$next$a9, hindrances$next$a2, hindrances$next$a8);
  not hindrances$next$a9$not$g (hindrances$next$a9$not, hindrances$next$a9);
  or hindrances$next$a10$g (hindrances$next$a10, hindrances$q0$not, hindrances$q0);
  xor hindrances$next$a11$g (hindrances$next$a11, hindrances$next$a4, hindrances$next$a10);
  and hindrances$next$a12$g (hindrances$next$a12, hindrances$next$a4, hindrances$next$a10);
  not hindrances$next$a7$not$g (hindrances$next$a7$not, hindrances$next$a7);
  xor hindrances$next$a13$g (hindrances$next$a13, hindrances$next$a7$not, hindrances$next$a12);
  and hindrances$next$a14$g (hindrances$next$a14, hindrances$next$a7$not, hindrances$next$a12);
  or hindrances$next$a15$g (hindrances$next$a15, hindrances$next$a7, hindrances$next$a14);
  xor hindrances$next$a16$g (hindrances$next$a16, hindrances$next$a9, hindrances$next$a15);
  and hindrances$next$a17$g (hindrances$next$a17, hindrances$next$a9, hindrances$next$a15);
  or hindrances$next$a18$g (hindrances$next$a18, hindrances$next$a9$not, hindrances$next$a17);
  xor hindrances$next$a19$g (hindrances$next$a19, hindrances$next$a9, hindrances$next$a18);
  and hindrances$next$a20$g (hindrances$next$a20, hindrances$next$a9, hindrances$next$a18);
  or hindrances$next$a21$g (hindrances$next$a21, hindrances$next$a9$not, hindrances$next$a20);
  xor hindrances$next$a22$g (hindrances$next$a22, hindrances$next$a9, hindrances$next$a21);
  and hindrances$next$a23$g (hindrances$next$a23, hindrances$next$a9, hindrances$next$a21);
  or hindrances$next$a24$g (hindrances$next$a24, hindrances$next$a9$not, hindrances$next$a23);
  xor hindrances$next$a25$g (hindrances$next$a25, hindrances$next$a9, hindrances$next$a24);
  and hindrances$next$a26$g (hindrances$next$a26, hindrances$next$a9, hindrances$next$a24);
  or hindrances$next$a27$g (hindrances$next$a27, hindrances$next$a9$not, hindrances$next$a26);
  xor hindrances$next$a28$g (hindrances$next$a28, hindrances$next$a9, hindrances$next$a27);
  and hindrances$next$a29$g (hindrances$next$a29, hindrances$next$a9, hindrances$next$a27);
  or hindrances$next$a30$g (hindrances$next$a30, hindrances$next$a9$not, hindrances$next$a29);
  xor hindrances$next$a31$g (hindrances$next$a31, hindrances$next$a9, hindrances$next$a30);
  and hindrances$next$a32$g (hindrances$next$a32, hindrances$next$a9, hindrances$next$a30);
  or hindrances$next$a33$g (hindrances$next$a33, hindrances$next$a9$not, hindrances$next$a32);
  xor hindrances$next$a34$g (hindrances$next$a34, hindrances$next$a9, hindrances$next$a33);
  and hindrances$next$a35$g (hindrances$next$a35, hindrances$next$a9, hindrances$next$a33);
  or hindrances$next$a36$g (hindrances$next$a36, hindrances$next$a9$not, hindrances$next$a35);
  xor hindrances$next$a37$g (hindrances$next$a37, hindrances$next$a9, hindrances$next$a36);
  and hindrances$next$a38$g (hindrances$next$a38, hindrances$next$a9, hindrances$next$a36);
  or hindrances$next$a39$g (hindrances$next$a39, hindrances$next$a9$not, hindrances$next$a38);
  xor hindrances$next$a40$g (hindrances$next$a40, hindrances$next$a9, hindrances$next$a39);
  and hindrances$next$a41$g (hindrances$next$a41, hindrances$next$a9, hindrances$next$a39);
  or hindrances$next$a42$g (hindrances$next$a42, hindrances$next$a9$not, hindrances$next$a41);
  xor hindrances$next$a43$g (hindrances$next$a43, hindrances$next$a9, hindrances$next$a42);
  and hindrances$next$a44$g (hindrances$next$a44, hindrances$next$a9, hindrances$next$a42);
  or hindrances$next$a45$g (hindrances$next$a45, hindrances$next$a9$not, hindrances$next$a44);
  xor hindrances$next$a46$g (hindrances$next$a46, hindrances$next$a9, hindrances$next$a45);
  and hindrances$next$a47$g (hindrances$next$a47, hindrances$next$a9, hindrances$next$a45);
  or hindrances$next$a48$g (hindrances$next$a48, hindrances$next$a9$not, hindrances$next$a47);
  xor hindrances$next$a49$g (hindrances$next$a49, hindrances$next$a9, hindrances$next$a48);
  and hindrances$next$a50$g (hindrances$next$a50, hindrances$next$a9, hindrances$next$a48);
  or hindrances$next$a51$g (hindrances$next$a51, hindrances$next$a9$not, hindrances$next$a50);
  xor hindrances$next$a52$g (hindrances$next$a52, hindrances$next$a9, hindrances$next$a51);
  and hindrances$next$a53$g (hindrances$next$a53, hindrances$next$a9, hindrances$next$a51);
  or hindrances$next$a54$g (hindrances$next$a54, hindrances$next$a9$not, hindrances$next$a53);
  xor hindrances$next$a55$g (hindrances$next$a55, hindrances$next$a9, hindrances$next$a54);
  and hindrances$next$a56$g (hindrances$next$a56, hindrances$next$a9, hindrances$next$a54);
  or hindrances$next$a57$g (hindrances$next$a57, hindrances$next$a9$not, hindrances$next$a56);
  xor hindrances$next$a58$g (hindrances$next$a58, hindrances$next$a9, hindrances$next$a57);
  and hindrances$next$a59$g (hindrances$next$a59, hindrances$next$a9, hindrances$next$a57);
  or hindrances$next$a60$g (hindrances$next$a60, hindrances$next$a9$not, hindrances$next$a59);
  xor hindrances$next$a61$g (hindrances$next$a61, hindrances$next$a9, hindrances$next$a60);
  and hindrances$next$a62$g (hindrances$next$a62, hindrances$next$a9, hindrances$next$a60);
  or hindrances$next$a63$g (hindrances$next$a63, hindrances$next$a9$not, hindrances$next$a62);
  xor hindrances$next$a64$g (hindrances$next$a64, hindrances$next$a9, hindrances$next$a63);
  and hindrances$next$a65$g (hindrances$next$a65, hindrances$next$a9, hindrances$next$a63);
  or hindrances$next$a66$g (hindrances$next$a66, hindrances$next$a9$not, hindrances$next$a65);
  xor hindrances$next$a67$g (hindrances$next$a67, hindrances$next$a9, hindrances$next$a66);
  and hindrances$next$a68$g (hindrances$next$a68, hindrances$next$a9, hindrances$next$a66);
  or hindrances$next$a69$g (hindrances$next$a69, hindrances$next$a9$not, hindrances$next$a68);
  xor hindrances$next$a70$g (hindrances$next$a70, hindrances$next$a9, hindrances$next$a69);
  and hindrances$next$a71$g (hindrances$next$a71, hindrances$next$a9, hindrances$next$a69);
  or hindrances$next$a72$g (hindrances$next$a72, hindrances$next$a9$not, hindrances$next$a71);
  xor hindrances$next$a73$g (hindrances$next$a73, hindrances$next$a9, hindrances$next$a72);
  and hindrances$next$a74$g (hindrances$next$a74, hindrances$next$a9, hindrances$next$a72);
  or hindrances$next$a75$g (hindrances$next$a75, hindrances$next$a9$not, hindrances$next$a74);
  xor hindrances$next$a76$g (hindrances$next$a76, hindrances$next$a9, hindrances$next$a75);
  and hindrances$next$a77$g (hindrances$next$a77, hindrances$next$a9, hindrances$next$a75);
  or hindrances$next$a78$g (hindrances$next$a78, hindrances$next$a9$not, hindrances$next$a77);
  xor hindrances$next$a79$g (hindrances$next$a79, hindrances$next$a9, hindrances$next$a78);
  and hindrances$next$a80$g (hindrances$next$a80, hindrances$next$a9, hindrances$next$a78);
  or hindrances$next$a81$g (hindrances$next$a81, hindrances$next$a9$not, hindrances$next$a80);
  xor hindrances$next$a82$g (hindrances$next$a82, hindrances$next$a9, hindrances$next$a81);
  and hindrances$next$a83$g (hindrances$next$a83, hindrances$next$a9, hindrances$next$a81);
  or hindrances$next$a84$g (hindrances$next$a84, hindrances$next$a9$not, hindrances$next$a83);
  xor hindrances$next$a85$g (hindrances$next$a85, hindrances$next$a9, hindrances$next$a84);
  and hindrances$next$a86$g (hindrances$next$a86, hindrances$next$a9, hindrances$next$a84);
  or hindrances$next$a87$g (hindrances$next$a87, hindrances$next$a9$not, hindrances$next$a86);
  xor hindrances$next$a88$g (hindrances$next$a88, hindrances$next$a9, hindrances$next$a87);
  and hindrances$next$a89$g (hindrances$next$a89, hindrances$next$a9, hindrances$next$a87);
  or hindrances$next$a90$g (hindrances$next$a90, hindrances$next$a9$not, hindrances$next$a89);
  xor hindrances$next$a91$g (hindrances$next$a91, hindrances$next$a9, hindrances$next$a90);
  and hindrances$next$a92$g (hindrances$next$a92, hindrances$next$a9, hindrances$next$a90);
  or hindrances$next$a93$g (hindrances$next$a93, hindrances$next$a9$not, hindrances$next$a92);
  xor hindrances$next$a94$g (hindrances$next$a94, hindrances$next$a9, hindrances$next$a93);
  and hindrances$next$a95$g (hindrances$next$a95, hindrances$next$a9, hindrances$next$a93);
  or hindrances$next$a96$g (hindrances$next$a96, hindrances$next$a9$not, hindrances$next$a95);
  xor hindrances$next$a97$g (hindrances$next$a97, hindrances$next$a9, hindrances$next$a96);
  and hindrances$next$a98$g (hindrances$next$a98, hindrances$next$a9, hindrances$next$a96);
  or hindrances$next$a99$g (hindrances$next$a99, hindrances$next$a9$not, hindrances$next$a98);
  xor hindrances$next$a100$g (hindrances$next$a100, hindrances$next$a9, hindrances$next$a99);
  and hindrances$next$a101$g (hindrances$next$a101, hindrances$next$a9, hindrances$next$a99);
  or hindrances$next$a102$g (hindrances$next$a102, hindrances$next$a9$not, hindrances$next$a101);
  xor hindrances$next$a103$g (hindrances$next$a103, hindrances$next$a9, hindrances$next$a102);
  and hindrances$next$a104$g (hindrances$next$a104, hindrances$next$a9, hindrances$next$a102);
  or hindrances$next$a105$g (hindrances$next$a105, hindrances$next$a9$not, hindrances$next$a104);
  xor hindrances$next$a106$g (hindrances$next$a106, hindrances$next$a9, hindrances$next$a105);
  and hindrances$next$a107$g (hindrances$next$a107, hindrances$next$a9, hindrances$next$a105);
  or hindrances$next$a108$g (hindrances$next$a108, hindrances$next$a9$not, hindrances$next$a107);
  xor hindrances$next$a109$g (hindrances$next$a109, hindrances$next$a9, hindrances$next$a108);
  and hindrances$next$a110$g (hindrances$next$a110, hindrances$next$a9, hindrances$next$a108);
  or hindrances$next$a111$g (hindrances$next$a111, hindrances$next$a9$not, hindrances$next$a110);
  xor hindrances$next$a112$g (hindrances$next$a112, hindrances$next$a9, hindrances$next$a111);
  and hindrances$next$a113$g (hindrances$next$a113, hindrances$next$a9, hindrances$next$a111);
  or hindrances$next$a114$g (hindrances$next$a114, hindrances$next$a9$not, hindrances$next$a113);
  xor hindrances$next$a115$g (hindrances$next$a115, hindrances$next$a9, hindrances$next$a114);
  and hindrances$next$a116$g (hindrances$next$a116, hindrances$next$a9, hindrances$next$a114);
  or hindrances$next$a117$g (hindrances$next$a117, hindrances$next$a9$not, hindrances$next$a116);
  xor hindrances$next$a118$g (hindrances$next$a118, hindrances$next$a9, hindrances$next$a117);
  and hindrances$next$a119$g (hindrances$next$a119, hindrances$next$a9, hindrances$next$a117);
  or hindrances$next$a120$g (hindrances$next$a120, hindrances$next$a9$not, hindrances$next$a119);
  xor hindrances$next$a121$g (hindrances$next$a121, hindrances$next$a9, hindrances$next$a120);
  and hindrances$next$a122$g (hindrances$next$a122, hindrances$next$a9, hindrances$next$a120);
  or hindrances$next$a123$g (hindrances$next$a123, hindrances$next$a9$not, hindrances$next$a122);
  xor hindrances$next$a124$g (hindrances$next$a124, hindrances$next$a9, hindrances$next$a123);
  and hindrances$next$a125$g (hindrances$next$a125, hindrances$next$a9, hindrances$next$a123);
  or hindrances$next$a126$g (hindrances$next$a126, hindrances$next$a9$not, hindrances$next$a125);
  xor hindrances$next$a127$g (hindrances$next$a127, hindrances$next$a9, hindrances$next$a126);
  and hindrances$next$a128$g (hindrances$next$a128, hindrances$next$a9, hindrances$next$a126);
  or hindrances$next$a129$g (hindrances$next$a129, hindrances$next$a9$not, hindrances$next$a128);
  xor hindrances$next$a130$g (hindrances$next$a130, hindrances$next$a9, hindrances$next$a129);
  and hindrances$next$a131$g (hindrances$next$a131, hindrances$next$a9, hindrances$next$a129);
  or hindrances$next$a132$g (hindrances$next$a132, hindrances$next$a9$not, hindrances$next$a131);
  xor hindrances$next$a133$g (hindrances$next$a133, hindrances$next$a9, hindrances$next$a132);
  and hindrances$next$a134$g (hindrances$next$a134, hindrances$next$a9, hindrances$next$a132);
  or hindrances$next$a135$g (hindrances$next$a135, hindrances$next$a9$not, hindrances$next$a134);
  xor hindrances$next$a136$g (hindrances$next$a136, hindrances$next$a9, hindrances$next$a135);
  and hindrances$next$a137$g (hindrances$next$a137, hindrances$next$a9, hindrances$next$a135);
  or hindrances$next$a138$g (hindrances$next$a138, hindrances$next$a9$not, hindrances$next$a137);
  xor hindrances$next$a139$g (hindrances$next$a139, hindrances$next$a9, hindrances$next$a138);
  and hindrances$next$a140$g (hindrances$next$a140, hindrances$next$a9, hindrances$next$a138);
  or hindrances$next$a141$g (hindrances$next$a141, hindrances$next$a9$not, hindrances$next$a140);
  xor hindrances$next$a142$g (hindrances$next$a142, hindrances$next$a9, hindrances$next$a141);
  and hindrances$next$a143$g (hindrances$next$a143, hindrances$next$a9, hindrances$next$a141);
  or hindrances$next$a144$g (hindrances$next$a144, hindrances$next$a9$not, hindrances$next$a143);
  xor hindrances$next$a145$g (hindrances$next$a145, hindrances$next$a9, hindrances$next$a144);
  and hindrances$next$a146$g (hindrances$next$a146, hindrances$next$a9, hindrances$next$a144);
  or hindrances$next$a147$g (hindrances$next$a147, hindrances$next$a9$not, hindrances$next$a146);
  xor hindrances$next$a148$g (hindrances$next$a148, hindrances$next$a9, hindrances$next$a147);
  and hindrances$next$a149$g (hindrances$next$a149, hindrances$next$a9, hindrances$next$a147);
  or hindrances$next$a150$g (hindrances$next$a150, hindrances$next$a9$not, hindrances$next$a149);
  xor hindrances$next$a151$g (hindrances$next$a151, hindrances$next$a9, hindrances$next$a150);
  and hindrances$next$a152$g (hindrances$next$a152, hindrances$next$a9, hindrances$next$a150);
  or hindrances$next$a153$g (hindrances$next$a153, hindrances$next$a9$not, hindrances$next$a152);
  xor hindrances$next$a154$g (hindrances$next$a154, hindrances$next$a9, hindrances$next$a153);
  and hindrances$next$a155$g (hindrances$next$a155, hindrances$next$a9, hindrances$next$a153);
  or hindrances$next$a156$g (hindrances$next$a156, hindrances$next$a9$not, hindrances$next$a155);
  xor hindrances$next$a157$g (hindrances$next$a157, hindrances$next$a9, hindrances$next$a156);
  and hindrances$next$a158$g (hindrances$next$a158, hindrances$next$a9, hindrances$next$a156);
  or hindrances$next$a159$g (hindrances$next$a159, hindrances$next$a9$not, hindrances$next$a158);
  xor hindrances$next$a160$g (hindrances$next$a160, hindrances$next$a9, hindrances$next$a159);
  and hindrances$next$a161$g (hindrances$next$a161, hindrances$next$a9, hindrances$next$a159);
  or hindrances$next$a162$g (hindrances$next$a162, hindrances$next$a9$not, hindrances$next$a161);
  xor hindrances$next$a163$g (hindrances$next$a163, hindrances$next$a9, hindrances$next$a162);
  and hindrances$next$a164$g (hindrances$next$a164, hindrances$next$a9, hindrances$next$a162);
  or hindrances$next$a165$g (hindrances$next$a165, hindrances$next$a9$not, hindrances$next$a164);
  xor hindrances$next$a166$g (hindrances$next$a166, hindrances$next$a9, hindrances$next$a165);
  and hindrances$next$a167$g (hindrances$next$a167, hindrances$next$a9, hindrances$next$a165);
  or hindrances$next$a168$g (hindrances$next$a168, hindrances$next$a9$not, hindrances$next$a167);
  xor hindrances$next$a169$g (hindrances$next$a169, hindrances$next$a9, hindrances$next$a168);
  and hindrances$next$a170$g (hindrances$next$a170, hindrances$next$a9, hindrances$next$a168);
  or hindrances$next$a171$g (hindrances$next$a171, hindrances$next$a9$not, hindrances$next$a170);
  xor hindrances$next$a172$g (hindrances$next$a172, hindrances$next$a9, hindrances$next$a171);
  and hindrances$next$a173$g (hindrances$next$a173, hindrances$next$a9, hindrances$next$a171);
  or hindrances$next$a174$g (hindrances$next$a174, hindrances$next$a9$not, hindrances$next$a173);
  xor hindrances$next$a175$g (hindrances$next$a175, hindrances$next$a9, hindrances$next$a174);
  and hindrances$next$a176$g (hindrances$next$a176, hindrances$next$a9, hindrances$next$a174);
  or hindrances$next$a177$g (hindrances$next$a177, hindrances$next$a9$not, hindrances$next$a176);
  xor hindrances$next$a178$g (hindrances$next$a178, hindrances$next$a9, hindrances$next$a177);
  and hindrances$next$a179$g (hindrances$next$a179, hindrances$next$a9, hindrances$next$a177);
  or hindrances$next$a180$g (hindrances$next$a180, hindrances$next$a9$not, hindrances$next$a179);
  xor hindrances$next$a181$g (hindrances$next$a181, hindrances$next$a9, hindrances$next$a180);
  and hindrances$next$a182$g (hindrances$next$a182, hindrances$next$a9, hindrances$next$a180);
  or hindrances$next$a183$g (hindrances$next$a183, hindrances$next$a9$not, hindrances$next$a182);
  xor hindrances$next$a184$g (hindrances$next$a184, hindrances$next$a9, hindrances$next$a183);
  and hindrances$next$a185$g (hindrances$next$a185, hindrances$next$a9, hindrances$next$a183);
  or hindrances$next$a186$g (hindrances$next$a186, hindrances$next$a9$not, hindrances$next$a185);
  xor hindrances$next$a187$g (hindrances$next$a187, hindrances$next$a9, hindrances$next$a186);
  and hindrances$next$a188$g (hindrances$next$a188, hindrances$next$a9, hindrances$next$a186);
  or hindrances$next$a189$g (hindrances$next$a189, hindrances$next$a9$not, hindrances$next$a188);
  xor hindrances$next$a190$g (hindrances$next$a190, hindrances$next$a9, hindrances$next$a189);
  and hindrances$next$a191$g (hindrances$next$a191, hindrances$next$a9, hindrances$next$a189);
  or hindrances$next$a192$g (hindrances$next$a192, hindrances$next$a9$not, hindrances$next$a191);
  xor hindrances$next$a193$g (hindrances$next$a193, hindrances$next$a9, hindrances$next$a192);
  and hindrances$next$a194$g (hindrances$next$a194, hindrances$next$a9, hindrances$next$a192);
  or hindrances$next$a195$g (hindrances$next$a195, hindrances$next$a9$not, hindrances$next$a194);
  xor hindrances$next$a196$g (hindrances$next$a196, hindrances$next$a9, hindrances$next$a195);
  and hindrances$next$a197$g (hindrances$next$a197, hindrances$next$a9, hindrances$next$a195);
  or hindrances$next$a198$g (hindrances$next$a198, hindrances$next$a9$not, hindrances$next$a197);
  xor hindrances$next$a199$g (hindrances$next$a199, hindrances$next$a9, hindrances$next$a198);
  and hindrances$next$a200$g (hindrances$next$a200, hindrances$next$a9, hindrances$next$a198);
  or hindrances$next$a201$g (hindrances$next$a201, hindrances$next$a9$not, hindrances$next$a200);
  xor hindrances$next$a202$g (hindrances$next$a202, hindrances$next$a9, hindrances$next$a201);
  and hindrances$next$a203$g (hindrances$next$a203, hindrances$next$a9, hindrances$next$a201);
  or hindrances$next$a204$g (hindrances$next$a204, hindrances$next$a9$not, hindrances$next$a203);
  xor hindrances$next$a205$g (hindrances$next$a205, hindrances$next$a9, hindrances$next$a204);
  or hindrances$next$a206$g (hindrances$next$a206, hindrances$q0$not, hindrances$next$a11);
  or hindrances$next$a207$g (hindrances$next$a207, hindrances$next$a206, hindrances$next$a13);
  or hindrances$next$a208$g (hindrances$next$a208, hindrances$next$a207, hindrances$next$a16);
  or hindrances$next$a209$g (hindrances$next$a209, hindrances$next$a208, hindrances$next$a19);
  or hindrances$next$a210$g (hindrances$next$a210, hindrances$next$a209, hindrances$next$a22);
  or hindrances$next$a211$g (hindrances$next$a211, hindrances$next$a210, hindrances$next$a25);
  or hindrances$next$a212$g (hindrances$next$a212, hindrances$next$a211, hindrances$next$a28);
  or hindrances$next$a213$g (hindrances$next$a213, hindrances$next$a212, hindrances$next$a31);
  or hindrances$next$a214$g (hindrances$next$a214, hindrances$next$a213, hindrances$next$a34);
  or hindrances$next$a215$g (hindrances$next$a215, hindrances$next$a214, hindrances$next$a37);
  or hindrances$next$a216$g (hindrances$next$a216, hindrances$next$a215, hindrances$next$a40);
  or hindrances$next$a217$g (hindrances$next$a217, hindrances$next$a216, hindrances$next$a43);
  or hindrances$next$a218$g (hindrances$next$a218, hindrances$next$a217, hindrances$next$a46);
  or hindrances$next$a219$g (hindrances$next$a219, hindrances$next$a218, hindrances$next$a49);
  or hindrances$next$a220$g (hindrances$next$a220, hindrances$next$a219, hindrances$next$a52);
  or hindrances$next$a221$g (hindrances$next$a221, hindrances$next$a220, hindrances$next$a55);
  or hindrances$next$a222$g (hindrances$next$a222, hindrances$next$a221, hindrances$next$a58);
  or hindrances$next$a223$g (hindrances$next$a223, hindrances$next$a222, hindrances$next$a61);
  or hindrances$next$a224$g (hindrances$next$a224, hindrances$next$a223, hindrances$next$a64);
  or hindrances$next$a225$g (hindrances$next$a225, hindrances$next$a224, hindrances$next$a67);
  or hindrances$next$a226$g (hindrances$next$a226, hindrances$next$a225, hindrances$next$a70);
  or hindrances$next$a227$g (hindrances$next$a227, hindrances$next$a226, hindrances$next$a73);
  or hindrances$next$a228$g (hindrances$next$a228, hindrances$next$a227, hindrances$next$a76);
  or hindrances$next$a229$g (hindrances$next$a229, hindrances$next$a228, hindrances$next$a79);
  or hindrances$next$a230$g (hindrances$next$a230, hindrances$next$a229, hindrances$next$a82);
  or hindrances$next$a231$g (hindrances$next$a231, hindrances$next$a230, hindrances$next$a85);
  or hindrances$next$a232$g (hindrances$next$a232, hindrances$next$a231, hindrances$next$a88);
  or hindrances$next$a233$g (hindrances$next$a233, hindrances$next$a232, hindrances$next$a91);
  or hindrances$next$a234$g (hindrances$next$a234, hindrances$next$a233, hindrances$next$a94);
  or hindrances$next$a235$g (hindrances$next$a235, hindrances$next$a234, hindrances$next$a97);
  or hindrances$next$a236$g (hindrances$next$a236, hindrances$next$a235, hindrances$next$a100);
  or hindrances$next$a237$g (hindrances$next$a237, hindrances$next$a236, hindrances$next$a103);
  or hindrances$next$a238$g (hindrances$next$a238, hindrances$next$a237, hindrances$next$a106);
  or hindrances$next$a239$g (hindrances$next$a239, hindrances$next$a238, hindrances$next$a109);
  or hindrances$next$a240$g (hindrances$next$a240, hindrances$next$a239, hindrances$next$a112);
  or hindrances$next$a241$g (hindrances$next$a241, hindrances$next$a240, hindrances$next$a115);
  or hindrances$next$a242$g (hindrances$next$a242, hindrances$next$a241, hindrances$next$a118);
  or hindrances$next$a243$g (hindrances$next$a243, hindrances$next$a242, hindrances$next$a121);
  or hindrances$next$a244$g (hindrances$next$a244, hindrances$next$a243, hindrances$next$a124);
  or hindrances$next$a245$g (hindrances$next$a245, hindrances$next$a244, hindrances$next$a127);
  or hindrances$next$a246$g (hindrances$next$a246, hindrances$next$a245, hindrances$next$a130);
  or hindrances$next$a247$g (hindrances$next$a247, hindrances$next$a246, hindrances$next$a133);
  or hindrances$next$a248$g (hindrances$next$a248, hindrances$next$a247, hindrances$next$a136);
  or hindrances$next$a249$g (hindrances$next$a249, hindrances$next$a248, hindrances$next$a139);
  or hindrances$next$a250$g (hindrances$next$a250, hindrances$next$a249, hindrances$next$a142);
  or hindrances$next$a251$g (hindrances$next$a251, hindrances$next$a250, hindrances$next$a145);
  or hindrances$next$a252$g (hindrances$next$a252, hindrances$next$a251, hindrances$next$a148);
  or hindrances$next$a253$g (hindrances$next$a253, hindrances$next$a252, hindrances$next$a151);
  or hindrances$next$a254$g (hindrances$next$a254, hindrances$next$a253, hindrances$next$a154);
  or hindrances$next$a255$g (hindrances$next$a255, hindrances$next$a254, hindrances$next$a157);
  or hindrances$next$a256$g (hindrances$next$a256, hindrances$next$a255, hindrances$next$a160);
  or hindrances$next$a257$g (hindrances$next$a257, hindrances$next$a256, hindrances$next$a163);
  or hindrances$next$a258$g (hindrances$next$a258, hindrances$next$a257, hindrances$next$a166);
  or hindrances$next$a259$g (hindrances$next$a259, hindrances$next$a258, hindrances$next$a169);
  or hindrances$next$a260$g (hindrances$next$a260, hindrances$next$a259, hindrances$next$a172);
  or hindrances$next$a261$g (hindrances$next$a261, hindrances$next$a260, hindrances$next$a175);
  or hindrances$next$a262$g (hindrances$next$a262, hindrances$next$a261, hindrances$next$a178);
  or hindrances$next$a263$g (hindrances$next$a263, hindrances$next$a262, hindrances$next$a181);
  or hindrances$next$a264$g (hindrances$next$a264, hindrances$next$a263, hindrances$next$a184);
  or hindrances$next$a265$g (hindrances$next$a265, hindrances$next$a264, hindrances$next$a187);
  or hindrances$next$a266$g (hindrances$next$a266, hindrances$next$a265, hindrances$next$a190);
  or hindrances$next$a267$g (hindrances$next$a267, hindrances$next$a266, hindrances$next$a193);
  or hindrances$next$a268$g (hindrances$next$a268, hindrances$next$a267, hindrances$next$a196);
  or hindrances$next$a269$g (hindrances$next$a269, hindrances$next$a268, hindrances$next$a199);
  or hindrances$next$a270$g (hindrances$next$a270, hindrances$next$a269, hindrances$next$a202);
  or hindrances$next$a271$g (hindrances$next$a271, hindrances$next$a270, hindrances$next$a205);
  not hindrances$next$a271$not$g (hindrances$next$a271$not, hindrances$next$a271);
  or hindrances$next$a272$g (hindrances$next$a272, hindrances$next$a205, hindrances$next$a271$not);
  not hindrances$next$a272$not$g (hindrances$next$a272$not, hindrances$next$a272);
  and hindrances$next$a273$g (hindrances$next$a273, hindrances$next$a272, hindrances$q0$not);
  and hindrances$next$a274$g (hindrances$next$a274, hindrances$next$a272, hindrances$next$a4);
  or hindrances$next$a275$g (hindrances$next$a275, hindrances$next$a272$not, hindrances$next$a274);
  and hindrances$next$a276$g (hindrances$next$a276, hindrances$next$a272, hindrances$next$a7);
  and hindrances$next$a277$g (hindrances$next$a277, hindrances$next$a9, hindrances$next$a273);
  and hindrances$next$a278$g (hindrances$next$a278, hindrances$next$a9, hindrances$next$a275);
  and hindrances$next$a279$g (hindrances$next$a279, hindrances$next$a9, hindrances$next$a276);
  and hindrances$next$a280$g (hindrances$next$a280, hindrances$when1, hindrances$next$a277);
  not hindrances$when1$not$g (hindrances$when1$not, hindrances$when1);
  and hindrances$next$a281$g (hindrances$next$a281, hindrances$when1$not, hindrances$q0);
  or hindrances$next$a282$g (hindrances$next$a282, hindrances$next$a280, hindrances$next$a281);
  and hindrances$next$a283$g (hindrances$next$a283, hindrances$when1, hindrances$next$a278);
  and hindrances$next$a284$g (hindrances$next$a284, hindrances$when1$not, hindrances$q1);
  or hindrances$next$a285$g (hindrances$next$a285, hindrances$next$a283, hindrances$next$a284);
  and hindrances$next$a286$g (hindrances$next$a286, hindrances$when1, hindrances$next$a279);
  grafwire_dff #(.INIT(1'b0)) hindrances$q0$g (.d(hindrances$next$a282), .c(clk), .q(hindrances$q0));
  grafwire_dff #(.INIT(1'b0)) hindrances$q1$g (.d(hindrances$next$a285), .c(clk), .q(hindrances$q1));

  // timer$0
  grafwire_scan_timer #(.RISE_PS(64'd2000000000000), .FALL_PS(64'd0), .SCAN_PS(SCAN_PS), .INIT(1'b0)) timer$0$g (.a(X12$next), .c(clk), .q(timer$0));  // 2s, 0s

  // timer$1
  grafwire_scan_timer #(.RISE_PS(64'd3000000000000), .FALL_PS(64'd0), .SCAN_PS(SCAN_PS), .INIT(1'b0)) timer$1$g (.a(X11$next), .c(clk), .q(timer$1));  // 3s, 0s

  // timer$2
  grafwire_scan_timer #(.RISE_PS(64'd2000000000000), .FALL_PS(64'd0), .SCAN_PS(SCAN_PS), .INIT(1'b0)) timer$2$g (.a(X15$next), .c(clk), .q(timer$2));  // 2s, 0s

  // timer$3
  grafwire_scan_timer #(.RISE_PS(64'd400000000000), .FALL_PS(64'd0), .SCAN_PS(SCAN_PS), .INIT(1'b0)) timer$3$g (.a(X20$next), .c(clk), .q(timer$3));  // 400ms, 0s

  // timer$4
  grafwire_scan_timer #(.RISE_PS(64'd400000000000), .FALL_PS(64'd0), .SCAN_PS(SCAN_PS), .INIT(1'b0)) timer$4$g (.a(X21$next), .c(clk), .q(timer$4));  // 400ms, 0s

  // timer$5
  grafwire_scan_timer #(.RISE_PS(64'd400000000000), .FALL_PS(64'd0), .SCAN_PS(SCAN_PS), .INIT(1'b0)) timer$5$g (.a(X22$next), .c(clk), .q(timer$5));  // 400ms, 0s

  // bell = (X11 + X12./2s/X12)./AUdoux
  not timer$0$not$g (timer$0$not, timer$0);
  and bell$1$g (bell$1, X12, timer$0$not);
  or bell$2$g (bell$2, X11, bell$1);
  not AUdoux$not$g (AUdoux$not, AUdoux);
  and bell$3$g (bell$3, bell$2, AUdoux$not);
  buf bell$g (bell, bell$3);

  // KM down = X12./AUdoux
  and \KM%20down$1$g  (\KM%20down$1 , X12, AUdoux$not);
  buf \KM%20down$g  (\KM%20down , \KM%20down$1 );

  // KM up = (X14 + X16)./AUdoux
  or \KM%20up$1$g  (\KM%20up$1 , X14, X16);
  and \KM%20up$2$g  (\KM%20up$2 , \KM%20up$1 , AUdoux$not);
  buf \KM%20up$g  (\KM%20up , \KM%20up$2 );

  // left = X20./AUdoux
  and left$1$g (left$1, X20, AUdoux$not);
  buf left$g (left, left$1);

  // right = X21./AUdoux
  and right$1$g (right$1, X21, AUdoux$not);
  buf right$g (right, right$1);
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
