// tools/bench [--quick] [--steps N] [--no-icarus] [SECTION…]: measures what the product is to be
// fast at. Sections: pipeline, evolution, programs, cases, delays, events; all where none is named.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <set>
#include <string>

#include "sections.h"

int main(int argc, char** argv) {
    bench::Options options;
    std::set<std::string> sections;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--quick") {
            options.sizes = {1'000, 10'000, 100'000};
            options.largest_for_icarus = 10'000;
            options.has_largest = false;
        } else if (word == "--steps" && i + 1 < argc) {
            // A multiple of eight, for the ring.
            const std::size_t steps = std::max<std::size_t>(16, std::stoul(argv[++i]) / 8 * 8);
            options.sizes = options.event_sizes = {steps};
        } else if (word == "--no-icarus") {
            options.largest_for_icarus = 0;
        } else if (word == "pipeline" || word == "evolution" || word == "programs" ||
                   word == "cases" || word == "delays" || word == "events") {
            sections.insert(word);
        } else {
            fmt::print(stderr,
                       "usage: bench [--quick] [--steps N] [--no-icarus] "
                       "[pipeline|evolution|programs|cases|delays|events]…\n");
            return 2;
        }
    }
    const auto wanted = [&](const char* name) { return sections.empty() || sections.count(name); };
    if (wanted("pipeline")) bench::measure_pipeline(options);
    if (wanted("evolution")) bench::measure_evolution();
    if (wanted("programs")) bench::measure_programs();
    if (wanted("cases")) bench::measure_cases();
    if (wanted("delays")) bench::measure_delays(options);
    if (wanted("events")) bench::measure_gate_events(options);
}
