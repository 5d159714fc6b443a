#include "evolution/evolution.h"

#include <fmt/format.h>

#include <cstdlib>

#include "charts.h"
#include "child.h"
#include "grafcet/parse_grafcet.h"
#include "sections.h"

namespace bench {

void measure_evolution() {
    using namespace grafwire;
    constexpr std::size_t steps = 80;
    constexpr int scans = 1'000'000;
    Diagnostics diagnostics;
    const auto grafcet = parse_grafcet({"ring", ring_chart(steps)}, diagnostics);
    if (!grafcet) std::abort();
    const Evolution evolution(*grafcet);
    // The inputs take turns, so that every token moves at every scan.
    InputValues inputs{1, 0, 0, 0, 0};
    EvolutionState state = evolution.start({inputs});
    const double seconds = time_of([&] {
        for (int i = 0; i < scans; ++i) {
            evolution.scan(state, {inputs}, i * millisecond);
            std::swap(inputs[0], inputs[1]);
        }
    });
    fmt::print("Reference: {} scans of {} steps, every token moving at each: {:.2f} s\n\n", scans,
               steps, seconds);
}

}  // namespace bench
