// Writing a GRAFCET and reading it back: nothing changes.

#include <doctest/doctest.h>

#include "grafcet/describe_grafcet.h"
#include "grafcet/write_grafcet.h"
#include "properties/same_model.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "trace/stimuli.h"

namespace grafwire::testing {

namespace {

std::string round_trip(const RandomCase& item) {
    const auto grafcet = read_grafcet(item.chart);
    const std::string written = write_grafcet(*grafcet);
    std::string messages;
    const auto again = read_grafcet(written, &messages);
    if (!again) return "what is written cannot be read back:\n" + messages + written;
    const std::string difference = model_difference(*grafcet, *again);
    if (!difference.empty()) return "not the same model in " + difference + ":\n" + written;
    if (write_grafcet(*again) != written) return "written differently the second time:\n" + written;
    if (describe_grafcet(*grafcet, Language::english) !=
        describe_grafcet(*again, Language::english)) {
        return "described differently:\n" + written;
    }
    return {};
}

std::string stimuli_round_trip(const RandomCase& item) {
    const auto grafcet = read_grafcet(item.chart);
    const auto stimuli = read_stimuli(item.stimuli, *grafcet);
    const std::string written = write_stimuli(*stimuli, *grafcet);
    std::string messages;
    const auto again = read_stimuli(written, *grafcet, &messages);
    if (!again) return "stimuli as written cannot be read back:\n" + messages + written;
    if (write_stimuli(*again, *grafcet) != written) return "stimuli written differently";
    if (again->end != stimuli->end) return "the end has moved";
    if (again->changes.size() != stimuli->changes.size()) return "not the same number of changes";
    for (std::size_t i = 0; i < stimuli->changes.size(); ++i) {
        const Stimuli::Change& a = stimuli->changes[i];
        const Stimuli::Change& b = again->changes[i];
        bool same = a.at == b.at && a.assignments.size() == b.assignments.size();
        for (std::size_t j = 0; same && j < a.assignments.size(); ++j) {
            same = a.assignments[j].input == b.assignments[j].input &&
                   a.assignments[j].value == b.assignments[j].value;
        }
        if (!same) return "another change " + std::to_string(i) + ":\n" + written;
    }
    return {};
}

}  // namespace

TEST_CASE("a random GRAFCET that is written and read back is the same") {
    check_property(round_trip, Features(), 0, 5000, 1);
    Features large;
    large.steps = 60;
    large.graphs = 8;
    large.expression_depth = 5;
    check_property(round_trip, large, 100'000, 200, 1);
}

TEST_CASE("random stimuli that are written and read back are the same") {
    check_property(stimuli_round_trip, Features(), 200'000, 500);
}

}  // namespace grafwire::testing
