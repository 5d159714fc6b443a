// A ladder diagram made from a GRAFCET, executed rung by rung, is the reference.

#include <doctest/doctest.h>

#include "evolution/run.h"
#include "ladder/ladder_from.h"
#include "ladder/run_ladder.h"
#include "random/random_cases.h"
#include "random/read_text.h"

namespace grafwire::testing {

namespace {

std::string compare(const RandomCase& item) {
    const auto grafcet = read_grafcet(item.chart);
    const auto stimuli = read_stimuli(item.stimuli, *grafcet);
    const ScanProgram program = program_from(*grafcet, {});
    Diagnostics diagnostics;
    const ladder::Ladder ladder = ladder::ladder_from(*grafcet, program, diagnostics);
    if (diagnostics.has_errors()) return "refused: " + diagnostics.items().front().message.english;
    for (const Time period : {millisecond, 1500 * microsecond}) {
        const std::string expected = write_csv(run_scans(*grafcet, *stimuli, period).trace);
        const std::string got = write_csv(run_ladder(*grafcet, ladder, *stimuli, period));
        if (expected != got) return "reference\n" + expected + "ladder\n" + got;
    }
    return {};
}

}  // namespace

TEST_CASE("a ladder diagram is the reference") {
    check_property(compare, Features(), 930'000, 2000, 15);
}

}  // namespace grafwire::testing
