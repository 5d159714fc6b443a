#include "random/random_cases.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>

#include "random/random_grafcet.h"
#include "random/random_stimuli.h"
#include "random/read_text.h"
#include "support/slow_build.h"

namespace grafwire::testing {

std::size_t case_count(std::size_t usual) {
    if (const char* wanted = std::getenv("GRAFWIRE_RANDOM_CASES")) {
        const std::size_t count = std::strtoull(wanted, nullptr, 10);
        if (count != 0) return count;
    }
    return is_slow_build ? std::max<std::size_t>(usual / 3, 1) : usual;
}

RandomCase random_case(std::uint64_t seed, const Features& features, std::size_t stimuli_lines) {
    RandomSource random(seed);
    RandomCase result;
    result.chart = random_grafcet(random, features);
    std::string messages;
    const auto grafcet = read_grafcet(result.chart, &messages);
    if (!grafcet)
        FAIL("seed " << seed << " gives a chart with errors\n" << messages << result.chart);
    result.stimuli = random_stimuli(random, *grafcet, stimuli_lines);
    if (!read_stimuli(result.stimuli, *grafcet, &messages)) {
        FAIL("seed " << seed << " gives stimuli with errors\n" << messages << result.stimuli);
    }
    return result;
}

void check_property(const Property& property, const Features& features, std::uint64_t first_seed,
                    std::size_t usual_count, std::size_t stimuli_lines) {
    const std::size_t count = case_count(usual_count);
    for (std::uint64_t seed = first_seed; seed < first_seed + count; ++seed) {
        const RandomCase found = random_case(seed, features, stimuli_lines);
        if (property(found).empty()) continue;
        const RandomCase small = shrunk(found, property);
        FAIL("seed " << seed << ": " << property(small) << "\n--- chart\n"
                     << small.chart << "--- stimuli\n"
                     << small.stimuli << "--- end");
    }
    CHECK(count != 0);
}

}  // namespace grafwire::testing
