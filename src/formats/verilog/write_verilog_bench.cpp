// The test bench counts in picoseconds. Before the moments of the stimuli lies the start: Init at
// 1, the other inputs as at instant 0, until a gate delay for every cell has passed; that is more
// than any netlist without oscillation takes.
//
// Of a netlist with delays the bench has the parameter GATE_NS as well and hands it on: the start
// and the time after which a row is taken grow with it.
//
// A bench that knows what the reference gives compares every row with it: it ends with PASS, or
// with the first difference and the status 1.

#include <algorithm>

#include "formats/shared/append.h"
#include "formats/shared/gate_delays.h"
#include "formats/shared/helper_cells.h"
#include "formats/verilog/verilog_cells.h"
#include "formats/verilog/verilog_names.h"
#include "formats/verilog/write_verilog.h"
#include "netlist/passes/counted_timers.h"
#include "text/escape.h"

namespace grafwire {

namespace {

/// The file, from front to back; time is what the stimuli count, `start_` later in the simulation.
class BenchWriter {
  public:
    BenchWriter(const Netlist& netlist, const Bench& bench, Time scan_period,
                const DelayModel& delays)
        : netlist_(netlist),
          bench_(bench),
          scan_period_(scan_period),
          delays_(delays),
          has_delays_(has_verilog_delays(netlist)),
          module_(helper_prefix(netlist) + "bench"),
          start_(delays.of_settling(netlist.cells.size())) {
        for (std::size_t i = 0; i < netlist.inputs.size(); ++i) {
            if (netlist.inputs[i].net == netlist.clock) clock_ = i;
        }
    }

    std::string write();

  private:
    std::string scaled(Time time, std::string_view gate_parameter) const;
    void write_head();
    void write_parameters();
    void write_inputs();
    void write_instance();
    void write_time_tasks();
    void write_row_task();
    void write_compare_task();
    void write_header_row();
    void write_event(const BenchEvent& event);
    void write_comparison(std::size_t row);
    bool compares() const { return !bench_.expected.empty(); }
    void write_cycles(Time half_period);
    void write_settling(std::size_t row, Time rest);

    const Netlist& netlist_;
    const Bench& bench_;
    Time scan_period_;
    const DelayModel& delays_;
    bool has_delays_;
    std::string module_;
    Time start_;
    std::size_t clock_ = 0;
    std::string out_;
};

std::string BenchWriter::write() {
    write_head();
    write_inputs();
    write_instance();
    write_time_tasks();
    write_row_task();
    if (compares()) write_compare_task();
    out_ += "\n  initial begin\n";
    write_header_row();
    for (const BenchEvent& event : bench_events(netlist_, bench_)) write_event(event);
    if (compares()) out_ += "    if (!failed) $display(\"PASS\");\n";
    out_ += "    $finish;\n  end\nendmodule\n";
    return std::move(out_);
}

/// The macros must be set before the netlist is compiled, so the bench says if it comes too late.
void BenchWriter::write_head() {
    out_ += "// To be given to the simulator before the netlist:\n";
    out_ += "//   iverilog -o run bench.v netlist.v && vvp -n run\n";
    if (needs_verilog_start(netlist_)) {
        append(out_, "`ifdef GRAFWIRE_START\n`define GRAFWIRE_WRONG_ORDER\n`endif\n",
               "`define GRAFWIRE_START (", scaled(start_, verilog_gate_parameter(netlist_)), ")\n");
    }
    append(out_, "`define GRAFWIRE_INSTANT ", module_, ".instant\n");
    if (compares()) {
        // What ends the simulation with the status 1.
        out_ +=
            "`ifdef __ICARUS__\n`define GRAFWIRE_FAIL $finish_and_return(1)\n"
            "`else\n`define GRAFWIRE_FAIL $fatal(1)\n`endif\n";
    }
    append(out_, "`timescale 1ps/1ps\n\nmodule ", module_);
    write_parameters();
}

/// A time in ns as the netlist has it: in gate delays, where it has such.
std::string BenchWriter::scaled(Time time, std::string_view gate_parameter) const {
    return has_delays_ ? in_gate_delays(time, delays_, gate_parameter) : format_nanoseconds(time);
}

/// What the simulator may be told, and the same in picoseconds.
void BenchWriter::write_parameters() {
    if (has_delays_) {
        append(out_, " #(parameter GATE_NS = ", format_nanoseconds(delays_.gate.max),
               ",\n    parameter [63:0] SETTLE_NS = ", scaled(bench_.settling, "GATE_NS"), ")");
    }
    append(out_, ";\n  localparam [63:0] START = 64'd1000 * ", scaled(start_, "GATE_NS"), ";\n");
    if (has_delays_) out_ += "  localparam [63:0] SETTLE = 64'd1000 * SETTLE_NS;\n";
}

/// Inputs and outputs as two words, so that names need not be spelled in the tasks.
void BenchWriter::write_inputs() {
    const std::vector<bool> values = starting_inputs(netlist_, bench_);
    append(out_, "  reg [", std::max<std::size_t>(values.size(), 1) - 1, ":0] in;\n");
    append(out_, "  wire [", std::max<std::size_t>(netlist_.outputs.size(), 1) - 1, ":0] out;\n");
    append(out_, "  reg [63:0] instant;\n  integer i, changes;\n\n  initial begin\n");
    out_ += "    instant = START;\n    changes = 0;\n";
    for (std::size_t i = 0; i < values.size(); ++i) {
        append(out_, "    in[", i, "] = ", values[i] ? '1' : '0', ";  ");
        append_verilog_comment(out_, netlist_.inputs[i].name);
    }
    out_ += "  end\n";
}

void BenchWriter::write_instance() {
    out_ += "\n  ";
    spell_verilog(out_, netlist_.name);
    std::string_view before = " #(.";
    if (has_delays_) {
        append(out_, before, verilog_gate_parameter(netlist_), "(GATE_NS)");
        before = ", .";
    }
    if (has_scan_timers(netlist_)) {
        append(out_, before, verilog_scan_parameter(netlist_), "(64'd", scan_period_, ")");
    }
    if (has_delays_ || has_scan_timers(netlist_)) out_ += ')';
    out_ += " netlist (";
    std::string_view separator = "\n    .";
    for (std::size_t i = 0; i < netlist_.inputs.size(); ++i) {
        out_ += separator;
        spell_verilog(out_, netlist_.inputs[i].name);
        append(out_, "(in[", i, "])");
        separator = ",\n    .";
    }
    for (std::size_t i = 0; i < netlist_.outputs.size(); ++i) {
        out_ += separator;
        spell_verilog(out_, netlist_.outputs[i].name);
        append(out_, "(out[", i, "])");
        separator = ",\n    .";
    }
    out_ += ");\n";
}

/// The moment of an instant, and after it the time that the netlist is given: never beyond `most`,
/// which lies before the next instant.
void BenchWriter::write_time_tasks() {
    out_ += R"(
  task begin_at(input [63:0] moment);
    begin
      #(START + moment - $time) instant = START + moment;
      changes = 0;
    end
  endtask
)";
    if (!has_delays_) return;
    out_ += R"(
  task settle(input [63:0] most);
    #(SETTLE < most ? SETTLE : most);
  endtask
)";
}

/// Prints a row, and stops a simulation that does not come to rest.
void BenchWriter::write_row_task() {
    append(out_, "\n  task row;\n    begin\n      for (i = 0; i < ", netlist_.outputs.size(),
           "; i = i + 1) $write(\",%b\", out[i]);\n      $write(\"\\n\");\n    end\n  endtask\n");
    // More changes within an instant than any evolution makes; without this an oscillation would go
    // on until the next instant, gate delay by gate delay.
    append(out_, "\n  always @(out) begin\n    changes = changes + 1;\n    if (changes > ",
           10'000 + 10 * netlist_.outputs.size(),
           ") begin\n      $fdisplay(32'h8000_0002, \"The netlist does not settle.\");\n      ",
           compares() ? "failed = 1;\n      `GRAFWIRE_FAIL" : "$finish", ";\n    end\n  end\n");
}

/// Ends the simulation with the first output that is not what the reference gives.
void BenchWriter::write_compare_task() {
    const std::size_t last = std::max<std::size_t>(netlist_.outputs.size(), 1) - 1;
    append(out_, "\n  reg failed = 0;\n\n  task compare(input [", last, ":0] expected, input [",
           last, ":0] known);\n    for (i = 0; i < ", netlist_.outputs.size(),
           "; i = i + 1) begin\n      if (!failed && known[i] && out[i] !== expected[i]) begin\n"
           "        failed = 1;\n        case (i)\n");
    for (std::size_t i = 0; i < netlist_.outputs.size(); ++i) {
        append(out_, "          ", i, ": $write(\"");
        append_verilog_text(out_, netlist_.outputs[i].name);
        out_ += "\");\n";
    }
    out_ +=
        "        endcase\n        $display(\" is %b, the reference gives %b\", out[i], "
        "expected[i]);\n        `GRAFWIRE_FAIL;\n      end\n    end\n  endtask\n";
}

/// Of a row: what it shall hold, the last output first.
void BenchWriter::write_comparison(std::size_t row) {
    const std::size_t width = netlist_.outputs.size();
    std::string expected;
    std::string known;
    for (std::size_t i = width; i-- > 0;) {
        const Logic value = bench_.expected[row * width + i];
        expected += value == Logic::one ? '1' : '0';
        known += value == Logic::unknown ? '0' : '1';
    }
    append(out_, "    compare(", width, "'b", expected, ", ", width, "'b", known, ");\n");
}

/// `time_ms,X0,X1`: a CSV within texts of Verilog, so a name is quoted twice.
void BenchWriter::write_header_row() {
    if (needs_verilog_start(netlist_)) {
        out_ +=
            "`ifdef GRAFWIRE_WRONG_ORDER\n"
            "    $display(\"The test bench must stand before the netlist.\");\n"
            "    $finish;\n`endif\n";
    }
    out_ += "    $write(\"time_ms\");\n";
    for (const Port& port : netlist_.outputs) {
        std::string name;
        append_csv_field(name, port.name);
        out_ += "    $write(\",";
        append_verilog_text(out_, name);
        out_ += "\");\n";
    }
    out_ += "    $write(\"\\n\");\n";
}

void BenchWriter::write_cycles(Time half_period) {
    append(out_, "    repeat (", bench_.clock_cycles, ") begin #(64'd", half_period, ") in[",
           clock_, "] = 1; #(64'd", half_period, ") in[", clock_, "] = 0; end\n");
}

/// A clocked netlist without delays is given what is left of its time.
void BenchWriter::write_settling(std::size_t row, Time rest) {
    if (!has_delays_) {
        append(out_, "    #(64'd", rest, ");\n");
    } else if (row + 1 == bench_.instants.size()) {
        out_ += "    settle(SETTLE);\n";
    } else {
        append(out_, "    settle(64'd", longest_sampling_delay(bench_, row), ");\n");
    }
}

/// Inputs change, the clock ticks if there is one, and after the settling time a row is taken.
void BenchWriter::write_event(const BenchEvent& event) {
    append(out_, "    // ", format_milliseconds(event.at), " ms\n    begin_at(64'd", event.at,
           ");\n");
    for (const Stimuli::Assignment& assignment : event.assignments) {
        append(out_, "    in[", assignment.input, "] = ", assignment.value ? '1' : '0', ";\n");
    }
    if (event.row == BenchEvent::no_row) return;
    Time delay = sampling_delay(bench_, event.row);
    if (netlist_.is_clocked()) {
        const Time half_period = std::max<Time>(1, delay / (2 * Time{bench_.clock_cycles} + 2));
        write_cycles(half_period);
        delay = std::max<Time>(0, delay - half_period * 2 * bench_.clock_cycles);
    }
    write_settling(event.row, delay);
    append(out_, "    $write(\"", format_milliseconds(event.at), "\"); row;\n");
    if (compares()) write_comparison(event.row);
}

}  // namespace

std::string write_verilog_bench(const Netlist& netlist, const Bench& bench, Time scan_period,
                                const DelayModel& delays) {
    return BenchWriter(netlist, bench, scan_period, delays).write();
}

}  // namespace grafwire
