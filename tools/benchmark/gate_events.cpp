// Gate events a second. The netlist is a ring of phase modules of AND, OR and NOT gates without
// modes, a nanosecond each; the stimuli are pulses of `a` and `b` by turns, each of which moves
// every token one step on. Icarus Verilog gets the same netlist from the Verilog exporter and the
// same pulses from a test bench without any output but the final situation, which must be ours. The
// time of vvp is that of a run with the moves less that of one without.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include "charts.h"
#include "child.h"
#include "equations/equations.h"
#include "formats/verilog/write_verilog.h"
#include "grafcet/parse_grafcet.h"
#include "netlist/styles/styles.h"
#include "sections.h"
#include "simulate/simulate.h"

namespace bench {

namespace {

using namespace grafwire;
namespace fs = std::filesystem;

constexpr Time between_changes = 20 * nanosecond;

/// What one size yields, as figures that pass from a child process to its parent.
struct Measured {
    double cells = 0;
    double moves = 0;
    double events = 0;
    double seconds = 0;
};

std::string situation_of(const Simulator& simulator, const PortMap& ports, std::size_t shown) {
    std::string text;
    for (std::size_t i = 0; i < shown; ++i) {
        text += simulator.value(ports.steps[i]) == Logic::one ? '1' : '0';
    }
    return text + '\n';
}

std::string read_file(const fs::path& path) {
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

void write_file(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

/// Pulses of `a` and `b` by turns; the events of all gates and inputs.
std::uint64_t run_moves(Simulator& simulator, const PortMap& ports, std::size_t moves) {
    std::uint64_t events = 0;
    Time at = 0;
    const auto set = [&](NetId input, Logic value) {
        at += between_changes;
        simulator.begin_instant(at);
        simulator.set_input(input, value);
        const Settling settling = simulator.settle();
        if (!settling.settled) std::abort();
        events += settling.events + 1;
    };
    for (std::size_t move = 0; move < moves; ++move) {
        const NetId input = ports.inputs[move % 2];
        set(input, Logic::one);
        set(input, Logic::zero);
    }
    return events;
}

/// Without a path to the outputs: nothing but the clock, a and b, and at the end the situation.
std::string test_bench(std::size_t shown) {
    std::string text = fmt::format(R"(`timescale 1ns/1ps
module moves_bench;
  reg a, b;
  integer moves, i;
  ring ring (.a(a), .b(b));
  initial begin
    a = 0; b = 0;
    if (!$value$plusargs("moves=%d", moves)) moves = 0;
    #200;
    for (i = 0; i < moves; i = i + 1) begin
      #{0} if (i % 2 == 0) a = 1; else b = 1;
      #{0} if (i % 2 == 0) a = 0; else b = 0;
    end
    #200;
)",
                                   between_changes / nanosecond);
    for (std::size_t i = 0; i < shown; ++i)
        text += fmt::format("    $write(\"%b\", ring.X{});\n", i);
    return text + "    $write(\"\\n\");\n    $finish;\n  end\nendmodule\n";
}

Measured measure_ours(std::size_t steps, const fs::path& folder, std::size_t shown) {
    Diagnostics diagnostics;
    const auto grafcet = parse_grafcet({"ring", ring_chart(steps)}, diagnostics);
    if (!grafcet) std::abort();
    const Equations equations =
        equations_from(*grafcet, {.cdx = CdxForm::successor, .modes = false});
    const auto netlist = netlist_from(*grafcet, equations, Style::gates, diagnostics);
    if (!netlist) std::abort();
    if (!folder.empty()) {
        write_file(folder / "ring.v", write_verilog(*netlist));
        write_file(folder / "bench.v", test_bench(shown));
    }

    NetlistMachine machine(*grafcet, *netlist, cell_delays(*netlist, {}));
    Simulator& simulator = machine.simulator();
    const PortMap& ports = machine.ports();
    machine.start(std::vector<Logic>(5, Logic::zero));
    simulator.begin_instant(0);
    simulator.settle();
    const SimulatorState start = simulator.save();

    Measured measured;
    measured.cells = static_cast<double>(netlist->cells.size());
    // About six million events, an even number of moves.
    const std::size_t moves = std::max<std::size_t>(2, 4'000'000 / steps) / 2 * 2;
    measured.moves = static_cast<double>(moves);
    measured.seconds = time_of([&] {
        simulator.restore(start);
        measured.events = static_cast<double>(run_moves(simulator, ports, moves));
    });
    if (!folder.empty()) write_file(folder / "expected", situation_of(simulator, ports, shown));
    return measured;
}

std::string in_mebibytes(double bytes) {
    return fmt::format("{:.0f}", bytes / (1 << 20));
}

/// The columns of Icarus Verilog in the row of one size.
void measure_icarus(const fs::path& folder, const Measured& ours) {
    const std::string program = folder / "run.vvp";
    const ProgramResult compiled =
        run_program({"iverilog", "-g2005", "-o", program, folder / "bench.v", folder / "ring.v"},
                    folder / "log");
    if (!compiled.succeeded) {
        fmt::print("  iverilog failed: {}\n", read_file(folder / "log"));
        return;
    }
    const ProgramResult idle = run_program({"vvp", "-n", program, "+moves=0"}, folder / "log");
    const std::string moves = fmt::format("+moves={:.0f}", ours.moves);
    const ProgramResult busy = run_program({"vvp", "-n", program, moves}, folder / "result");
    const double seconds = std::max(busy.seconds - idle.seconds, 1e-3);
    const bool same = idle.succeeded && busy.succeeded &&
                      read_file(folder / "result") == read_file(folder / "expected");
    fmt::print("  {:>8.2f} {:>6}  {:>8.2f} {:>7.2f}x  {}\n", compiled.seconds,
               in_mebibytes(std::max(compiled.peak_bytes, busy.peak_bytes)),
               ours.events / seconds / 1e6, ours.events / ours.seconds / (ours.events / seconds),
               same ? "same" : "DIFFERENT");
}

}  // namespace

void measure_gate_events(const Options& options) {
    const fs::path scratch = fs::temp_directory_path() / fmt::format("grafwire-bench-{}", getpid());
    fmt::print(
        "Gate events in millions a second: a ring of phase modules, a token every eight steps.\n"
        "Icarus Verilog on the same netlist and stimuli; seconds of iverilog, memory in MiB.\n\n"
        "{:>9} {:>9} {:>10} {:>8}  {:>8} {:>6}  {:>8} {:>8}  {}\n",
        "steps", "cells", "events", "ours", "iverilog", "MiB", "vvp", "ratio", "situation");
    for (const std::size_t steps : options.event_sizes) {
        const bool with_icarus = steps <= options.largest_for_icarus;
        const std::size_t shown = std::min<std::size_t>(steps, 1'000);
        if (with_icarus) fs::create_directories(scratch);
        const ChildResult result = in_child([&] {
            const Measured ours = measure_ours(steps, with_icarus ? scratch : fs::path(), shown);
            return std::vector<double>{ours.cells, ours.moves, ours.events, ours.seconds};
        });
        if (result.figures.size() != 4) {
            fmt::print("{:>9}  failed\n", steps);
            continue;
        }
        const Measured ours{result.figures[0], result.figures[1], result.figures[2],
                            result.figures[3]};
        fmt::print("{:>9} {:>9.0f} {:>10.0f} {:>8.1f}", steps, ours.cells, ours.events,
                   ours.events / ours.seconds / 1e6);
        std::fflush(stdout);
        if (with_icarus) {
            measure_icarus(scratch, ours);
        } else {
            fmt::print("\n");
        }
        std::fflush(stdout);
    }
    std::error_code ignored;
    fs::remove_all(scratch, ignored);
    fmt::print("\n");
}

}  // namespace bench
