// clocked: 5 cells.
`timescale 1ns/1ps

module clocked #(parameter [63:0] SCAN_PS = 64'd10000000000) (
  input a,
  input Init,
  input clk,
  output X1,
  output late,
  output later
);
  wire X1$next;
  wire late$next;

  // X1 toggles while a
  xor X1$next$g (X1$next, X1, a);
  grafwire_dff #(.INIT(1'b1)) X1$g (.d(X1$next), .c(clk), .q(X1));

  // late = 30ms/a/10ms
  grafwire_scan_timer #(.RISE_PS(64'd30000000000), .FALL_PS(64'd10000000000), .SCAN_PS(SCAN_PS), .INIT(1'b0)) late$g (.a(a), .c(clk), .q(late));  // 30ms, 10ms

  // later = 20ms/late
  grafwire_scan_timer_next #(.RISE_PS(64'd30000000000), .FALL_PS(64'd10000000000), .SCAN_PS(SCAN_PS)) late$next$g (.a(a), .h(late), .c(clk), .q(late$next));  // 30ms, 10ms
  grafwire_scan_timer #(.RISE_PS(64'd20000000000), .FALL_PS(64'd0), .SCAN_PS(SCAN_PS), .INIT(1'b0)) later$g (.a(late$next), .c(clk), .q(later));  // 20ms, 0s
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

// Look-ahead of a clocked timer of operand a and output h: what it is to show after this cycle.
module grafwire_scan_timer_next #(parameter [63:0] RISE_PS = 0, FALL_PS = 0, SCAN_PS = 1)
    (input a, input h, input c, output q);
  localparam [63:0] RISE = (RISE_PS + SCAN_PS - 1) / SCAN_PS;
  localparam [63:0] FALL = (FALL_PS + SCAN_PS - 1) / SCAN_PS;
  localparam [63:0] LONGEST = RISE > FALL ? RISE : FALL;
  localparam WIDTH = $clog2(LONGEST + 1) + 1;
  reg [WIDTH-1:0] elapsed;
  initial elapsed = 0;
  assign q = elapsed >= (a ? RISE[WIDTH-1:0] : FALL[WIDTH-1:0]) ? a : h;
  always @(posedge c)
    if (a == h || q == a) elapsed <= 0;
    else elapsed <= elapsed + 1'b1;
endmodule
