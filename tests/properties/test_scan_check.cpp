// The check scan by scan on random charts: the plain evolution as a device is never different; with
// a fault in a situation that a random run has reached it always is, and the witness shows it.

#include <doctest/doctest.h>

#include "check/scan_check.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "support/naive_device.h"
#include "trace/input_values.h"
#include "trace/stimuli.h"

namespace grafwire::testing {

namespace {

constexpr Time period = 500 * microsecond;  // divides all durations of random charts

struct Decided {
    std::size_t decided = 0;
    std::size_t undecided = 0;
    void count(const CheckResult& result) {
        ++(result.verdict == Verdict::undecided ? undecided : decided);
    }
};

CheckResult check(const Grafcet& grafcet, const ScannedDevice& device, std::uint64_t max_cases) {
    CheckOptions options;
    options.max_cases = max_cases;
    return check_scans(grafcet, device, period, options);
}

std::string right_is_never_different(const RandomCase& item, Decided& tally) {
    const auto grafcet = read_grafcet(item.chart);
    const CheckResult result = check(*grafcet, NaiveDevice(*grafcet), 3000);
    tally.count(result);
    if (result.verdict != Verdict::different) return {};
    return "different\n" + write_stimuli(result.witness->stimuli, *grafcet);
}

/// Where some scans under the stimuli lead; nothing where they break an assumption.
std::optional<NaiveState> reached(const Grafcet& grafcet, const Stimuli& stimuli) {
    const NaiveEvolution evolution(grafcet);
    InputValues inputs(grafcet.all_input_count(), 0);
    NaiveState state = evolution.start(inputs);
    Time now = 0;
    for (const Stimuli::Change& change : stimuli.changes) {
        for (const Stimuli::Assignment& set : change.assignments) inputs[set.input] = set.value;
        if (broken_assumption(grafcet, inputs) != grafcet.assumptions.size()) return std::nullopt;
        if (now == 0) state = evolution.start(inputs);
        for (int scan = 0; scan < 3; ++scan, now += period) evolution.scan(state, inputs, now);
    }
    return state;
}

std::string wrong_is_different(const RandomCase& item, Decided& tally) {
    const auto grafcet = read_grafcet(item.chart);
    const auto stimuli = read_stimuli(item.stimuli, *grafcet);
    const auto target = reached(*grafcet, *stimuli);
    if (!target || grafcet->steps.empty()) return {};
    const NaiveDevice device(*grafcet, [&](const NaiveState& state, const InputValues&,
                                           ScannedDevice::Outcome& shown, std::string&) {
        const bool is_there = state.ts == target->ts && state.times == target->times &&
                              state.counters == target->counters && state.vars == target->vars;
        if (!is_there) return;
        shown.steps[0] = shown.steps[0] == Logic::one ? Logic::zero : Logic::one;
    });
    const CheckResult result = check(*grafcet, device, 10'000);
    tally.count(result);
    if (result.verdict == Verdict::undecided) return {};
    if (result.verdict == Verdict::equivalent) return "equivalent";
    const auto again = replay_scans(*grafcet, device, result.witness->stimuli, period);
    if (!again) return "does not replay";
    if (again->kind != DifferenceKind::situation) return "replays as another difference";
    if (result.witness->stimuli.end != again->stimuli.end) return "replays at another moment";
    if (!read_stimuli(write_stimuli(result.witness->stimuli, *grafcet), *grafcet)) {
        return "the stimuli of the witness cannot be read";
    }
    return {};
}

Features with_two_times() {
    Features features = Features::small();
    features.time_conditions = 2;
    features.edges = 1;
    return features;
}

}  // namespace

TEST_CASE("scan by scan, the plain evolution is never different") {
    Decided tally;
    const Property property = [&](const RandomCase& item) {
        return right_is_never_different(item, tally);
    };
    check_property(property, with_two_times(), 1'300'000, 150, 1);
    MESSAGE(tally.decided << " equivalent, " << tally.undecided << " undecided within the bound");
    CHECK(tally.decided > tally.undecided);
}

TEST_CASE("scan by scan, a fault in a situation that can be reached is found") {
    Decided tally;
    const Property property = [&](const RandomCase& item) {
        return wrong_is_different(item, tally);
    };
    check_property(property, with_two_times(), 1'400'000, 150, 12);
    MESSAGE(tally.decided << " different, " << tally.undecided << " undecided within the bound");
    CHECK(tally.decided > tally.undecided);
}

}  // namespace grafwire::testing
