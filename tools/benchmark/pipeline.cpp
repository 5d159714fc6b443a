#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "charts.h"
#include "child.h"
#include "equations/equations.h"
#include "formats/netlist_formats.h"
#include "grafcet/parse_grafcet.h"
#include "netlist/styles/styles.h"
#include "sections.h"

namespace bench {

namespace {

using namespace grafwire;

enum Part { reading, parsing, deriving, wiring, writing, part_count };

SourceFile read_source(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    SourceFile source{path, {}};
    source.text.resize(std::filesystem::file_size(path));
    in.read(source.text.data(), static_cast<std::streamsize>(source.text.size()));
    return source;
}

/// The way of a chart to Verilog once; adds to the times what each part takes. Things die in the
/// order in which the program lets them.
void go(const std::string& path, std::vector<double>& times) {
    double before = cpu_seconds();
    const auto lap = [&](Part part) {
        const double now = cpu_seconds();
        times[part] += now - before;
        before = now;
    };
    const SourceFile source = read_source(path);
    lap(reading);
    Diagnostics diagnostics;
    const std::optional<Grafcet> grafcet = parse_grafcet(source, diagnostics);
    if (!grafcet) std::abort();
    lap(parsing);
    std::optional<Equations> equations = equations_from(*grafcet, EquationOptions{});
    lap(deriving);
    const std::optional<Netlist> netlist =
        netlist_from(*grafcet, *equations, Style::nand, diagnostics);
    if (!netlist) std::abort();
    lap(wiring);
    const std::string text = write_netlist(*netlist_format_named("verilog"), *netlist);
    std::ofstream(path + ".v", std::ios::binary)
        .write(text.data(), static_cast<std::streamsize>(text.size()));
    lap(writing);
}

/// Seconds of each part, then of all together with what is freed at the end.
std::vector<double> measure(const std::string& path, std::size_t steps) {
    const int runs = static_cast<int>(std::max<std::size_t>(1, 200'000 / steps));
    std::vector<double> times(part_count, 0.0);
    const double began = cpu_seconds();
    for (int i = 0; i < runs; ++i) go(path, times);
    times.push_back(cpu_seconds() - began);
    for (double& time : times) time /= runs;
    return times;
}

/// The quickest of some runs, each in a process of its own: what other work on the machine and cold
/// memory add varies, what the program takes does not.
ChildResult best_of_runs(const std::string& path, std::size_t steps) {
    constexpr int attempts = 5;
    ChildResult best;
    for (int i = 0; i < attempts; ++i) {
        ChildResult result = in_child([&] { return measure(path, steps); });
        if (result.figures.empty()) return result;
        if (best.figures.empty() || result.figures.back() < best.figures.back())
            best = std::move(result);
    }
    return best;
}

void measure_shape(const char* shape, std::string (*chart)(std::size_t), const Options& options) {
    const std::string path = (std::filesystem::temp_directory_path() /
                              fmt::format("grafwire-bench-{}.grafcet", getpid()))
                                 .string();
    fmt::print("{:<6} {:>9}  {:>6} {:>6} {:>6} {:>6} {:>6} {:>6}  {:>9}  {:>8} {:>8}\n", shape,
               "steps", "read", "parse", "equat.", "nand", "verilog", "total", "per 1 000",
               "seconds", "MiB");
    std::optional<double> reference;
    for (const std::size_t steps : options.sizes) {
        in_child([&] {
            const std::string text = chart(steps);
            std::ofstream(path, std::ios::binary) << text;
            return std::vector<double>{};
        });
        const ChildResult result = best_of_runs(path, steps);
        if (result.figures.empty()) {
            fmt::print("{:<6} {:>9}  failed\n", "", steps);
            continue;
        }
        const auto per_step = [&](double seconds) {
            return seconds * 1e9 / static_cast<double>(steps);
        };
        const double total = result.figures.back();
        if (!reference) reference = per_step(total);
        fmt::print("{:<6} {:>9}", "", steps);
        for (int part = 0; part <= part_count; ++part) {
            fmt::print(" {:>6.0f}", per_step(result.figures[static_cast<std::size_t>(part)]));
        }
        fmt::print("  {:>8.2f}x  {:>8.2f} {:>8.0f}\n", per_step(total) / *reference, total,
                   result.peak_bytes / (1 << 20));
        std::fflush(stdout);
    }
    std::filesystem::remove(path);
    std::filesystem::remove(path + ".v");
}

}  // namespace

void measure_pipeline(const Options& options) {
    fmt::print(
        "From a chart to Verilog (nand, with modes): processor time in ns a step, the total "
        "against\n"
        "that of the smallest chart, seconds and peak memory in all; the best of five runs.\n\n");
    measure_shape("ring", ring_chart, options);
    fmt::print("\n");
    measure_shape("tree", tree_chart, options);
    fmt::print("\n");
}

}  // namespace bench
