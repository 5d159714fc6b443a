// Scans a second of the programs that grafwire writes, and of the reference evolution on the same
// chart and inputs: a ring of 80 steps in which every token moves at each scan. The program in C is
// compiled with -O2 and must end in the situation of the reference.

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "charts.h"
#include "child.h"
#include "evolution/evolution.h"
#include "grafcet/parse_grafcet.h"
#include "plc/formats.h"
#include "program/program.h"
#include "sections.h"

namespace bench {

namespace {

using namespace grafwire;
namespace fs = std::filesystem;

constexpr std::size_t steps = 80;

struct Measured {
    double seconds = 0;
    std::string situation;  ///< the steps in their order, 0 and 1
};

void write_file(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

/// The inputs take turns.
constexpr const char* main_text = R"(
#include "ring.c"
#include <stdio.h>

int main(void) {
    ring_grafcet g;
    ring_inputs in;
    memset(&in, 0, sizeof in);
    in.a = true;
    ring_start(&g, &in);
    for (int64_t scan = 0; scan < SCANS; ++scan) {
        ring_scan(&g, &in, 1000 * scan);
        in.a = !in.a;
        in.b = !in.b;
    }
    for (int step = 0; step < STEPS; ++step) putchar(is(g.Ts, step) ? '1' : '0');
    return 0;
}
)";

Measured measure_c(const Grafcet& grafcet, long scans) {
    const fs::path folder =
        fs::temp_directory_path() / fmt::format("grafwire-programs-{}", getpid());
    fs::create_directories(folder);
    Diagnostics diagnostics;
    const ScanProgram program = program_from(grafcet, {});
    write_file(folder / "ring.c", plc_format_named("c")->write(program, {}, diagnostics));
    write_file(folder / "main.c", main_text);
    const std::string binary = folder / "main";
    const std::string output = folder / "output";
    const ProgramResult compiled =
        run_program({"cc", "-std=c99", "-O2", fmt::format("-DSCANS={}", scans), folder / "main.c",
                     "-o", binary},
                    output);
    if (!compiled.succeeded) std::abort();
    const ProgramResult ran = run_program({binary}, output);
    if (!ran.succeeded) std::abort();
    std::ostringstream situation;
    situation << std::ifstream(output).rdbuf();
    fs::remove_all(folder);
    return {ran.seconds, situation.str()};
}

Measured measure_reference(const Grafcet& grafcet, long scans) {
    const Evolution evolution(grafcet);
    InputValues inputs{1, 0, 0, 0, 0};
    EvolutionState state = evolution.start({inputs});
    Measured measured;
    const double began = cpu_seconds();
    for (long scan = 0; scan < scans; ++scan) {
        evolution.scan(state, {inputs}, scan * millisecond);
        std::swap(inputs[0], inputs[1]);
    }
    measured.seconds = cpu_seconds() - began;
    for (std::size_t s = 0; s < grafcet.steps.size(); ++s) {
        measured.situation += state.situation.test(s) ? '1' : '0';
    }
    return measured;
}

void print_row(const char* name, long scans, double seconds) {
    fmt::print("{:<40}{:>18.1f}{:>10.2f}\n", name, static_cast<double>(scans) / seconds / 1e6,
               seconds);
}

}  // namespace

void measure_programs() {
    // An odd number, so that the tokens do not stand where they began.
    constexpr long scans = 4'000'001;
    Diagnostics diagnostics;
    const auto grafcet = parse_grafcet({"ring", ring_chart(steps)}, diagnostics);
    if (!grafcet) std::abort();
    const Measured reference = measure_reference(*grafcet, scans);
    const Measured c = measure_c(*grafcet, scans);
    if (c.situation != reference.situation) {
        fmt::print("the program in C differs from the reference\n");
        std::exit(1);
    }
    fmt::print("{:<40}{:>18}{:>10}\n", fmt::format("Scans of {} steps, every token moving", steps),
               "millions a second", "seconds");
    print_row("reference evolution", scans, reference.seconds);
    print_row("program in C, -O2", scans, c.seconds);
    fmt::print("\n");
}

}  // namespace bench
