// Scans a second of the programs that grafwire writes, and of the reference evolution on the same
// chart and inputs: a ring of 80 steps in which every token moves at each scan. The program in C is
// compiled with -O2, the S7-200 listing is interpreted; each must end in the situation of the
// reference.

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
#include "s7/generate/listing_from.h"
#include "s7/machine/machine.h"
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
    write_file(folder / "ring.c", plc_format_named("c")->write(grafcet, program, {}, diagnostics));
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

Measured measure_listing(const Grafcet& grafcet, long scans) {
    Diagnostics diagnostics;
    const auto assigned = s7::listing_from(grafcet, program_from(grafcet, {}), {}, diagnostics);
    if (!assigned) std::abort();
    s7::Machine machine(assigned->listing, s7::Cpu::cpu_214);
    s7::MachineState state = machine.start();
    s7::InputImage inputs;
    inputs.value[0] = 1;  // E0.0 is a, E0.1 is b
    Measured measured;
    const double began = cpu_seconds();
    for (long scan = 0; scan < scans; ++scan) {
        if (!machine.scan(state, inputs, scan * millisecond).is_done()) std::abort();
        inputs.value[0] ^= 3;
    }
    measured.seconds = cpu_seconds() - began;
    for (const Step& step : grafcet.steps) {
        const s7::Operand* operand = assigned->assignment.operand_of("X" + step.name);
        measured.situation += machine.bit(state, *operand).value == Logic::one ? '1' : '0';
    }
    return measured;
}

void expect_same(const Measured& reference, const Measured& other, const char* name) {
    if (other.situation == reference.situation) return;
    fmt::print("{} differs from the reference\n", name);
    std::exit(1);
}

void print_row(const char* name, long scans, double seconds) {
    fmt::print("{:<40}{:>18.2f}{:>10.2f}\n", name, static_cast<double>(scans) / seconds / 1e6,
               seconds);
}

}  // namespace

void measure_programs() {
    // Odd numbers, so that the tokens do not stand where they began.
    constexpr long scans = 4'000'001;
    constexpr long interpreted_scans = 200'001;
    Diagnostics diagnostics;
    const auto grafcet = parse_grafcet({"ring", ring_chart(steps)}, diagnostics);
    if (!grafcet) std::abort();
    const Measured reference = measure_reference(*grafcet, scans);
    const Measured c = measure_c(*grafcet, scans);
    expect_same(reference, c, "the program in C");
    const Measured listing = measure_listing(*grafcet, interpreted_scans);
    expect_same(measure_reference(*grafcet, interpreted_scans), listing, "the S7-200 listing");
    fmt::print("{:<40}{:>18}{:>10}\n", fmt::format("Scans of {} steps, every token moving", steps),
               "millions a second", "seconds");
    print_row("reference evolution", scans, reference.seconds);
    print_row("program in C, -O2", scans, c.seconds);
    print_row("S7-200 listing, interpreted", interpreted_scans, listing.seconds);
    fmt::print("\n");
}

}  // namespace bench
