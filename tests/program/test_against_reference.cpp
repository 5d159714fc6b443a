// A scan program, executed as it stands, is the reference: on random charts over the whole
// language, word by word and bit by bit.

#include <doctest/doctest.h>

#include "evolution/run.h"
#include "program/run_program.h"
#include "random/random_cases.h"
#include "random/read_text.h"

namespace grafwire::testing {

namespace {

std::string compare(const RandomCase& item, bool bit_by_bit) {
    const auto grafcet = read_grafcet(item.chart);
    const auto stimuli = read_stimuli(item.stimuli, *grafcet);
    const ScanProgram program = program_from(*grafcet, {});
    for (const Time period : {millisecond, 1500 * microsecond}) {
        const std::string expected = write_csv(run_scans(*grafcet, *stimuli, period).trace);
        const std::string got =
            write_csv(run_program(*grafcet, program, *stimuli, period, bit_by_bit));
        if (expected != got) {
            return "reference\n" + expected + "program\n" + got +
                   write_program_text(*grafcet, program);
        }
    }
    return {};
}

}  // namespace

TEST_CASE("a scan program is the reference") {
    check_property([](const RandomCase& item) { return compare(item, false); }, Features(), 910'000,
                   2000, 15);
}

TEST_CASE("a scan program with its tables written out is the reference") {
    check_property([](const RandomCase& item) { return compare(item, true); }, Features(), 920'000,
                   1000, 15);
}

}  // namespace grafwire::testing
