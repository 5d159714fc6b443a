#pragma once

#include <cstddef>
#include <vector>

namespace bench {

struct Options {
    std::vector<std::size_t> sizes{1'000, 10'000, 100'000, 1'000'000};
    std::vector<std::size_t> event_sizes{1'000, 10'000, 100'000};
    std::size_t largest_for_icarus = 100'000;  ///< 0: leave Icarus Verilog out
    bool has_largest = true;                   ///< and not only what is soon done
};

/// From a file to Verilog: processor time per step and peak memory of each part.
void measure_pipeline(const Options& options);

/// Scans of the reference evolution.
void measure_evolution();

/// Scans a second of the programs written, against the reference evolution.
void measure_programs();

/// Cases checked a second.
void measure_cases();

/// Checks under open delays: states of gates a second, and growth.
void measure_delays(const Options& options);

/// Gate events a second of the simulator, and of Icarus Verilog on the same netlist and stimuli.
void measure_gate_events(const Options& options);

}  // namespace bench
