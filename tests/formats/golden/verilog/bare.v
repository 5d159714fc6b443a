// bare: 4 cells.
// GATE_NS is how long a gate takes, in ns. Pulses last several gate delays and grow with it.
`timescale 1ns/1ps

// When the netlist is let go after power-up, in ns, and the moment, in ps, from which a delay that
// begins now counts. A test bench may set these before.
`ifndef GRAFWIRE_START
`define GRAFWIRE_START (100 * GATE_NS)
`endif
`ifndef GRAFWIRE_INSTANT
`define GRAFWIRE_INSTANT $time
`endif

module bare #(parameter GATE_NS = 1) (
  input set,
  input reset,
  output X1
);
  wire set$not, reset$not, X1$q;

  // all
  not #GATE_NS set$not$g (set$not, set);
  not #GATE_NS reset$not$g (reset$not, reset);
  nand #GATE_NS X1$g (X1, set$not, X1$q);
  nand #GATE_NS X1$q$g (X1$q, X1, reset$not);

`ifndef SYNTHESIS
  initial begin
    force X1 = 1'b1;
    #(`GRAFWIRE_START);
    release X1;
  end
`endif
endmodule
