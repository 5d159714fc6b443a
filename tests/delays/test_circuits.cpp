// Verdicts under open delays against circuits that could be built: where a netlist is proven, no
// circuit with delays at random may go wrong, and the handshake style is proven wherever it is not
// refused.

#include <doctest/doctest.h>

#include <algorithm>
#include <string_view>

#include "evolution/run.h"
#include "netlist/styles/styles.h"
#include "random/plain_chart.h"
#include "random/random_cases.h"
#include "random/random_source.h"
#include "simulate/simulate.h"
#include "support/chart_files.h"
#include "support/delay_checks.h"
#include "support/small_netlists.h"
#include "support/styles.h"

namespace grafwire::testing {

namespace {

constexpr std::size_t instants_of_a_walk = 30;

Grafcet example(std::string_view name) {
    for (const ChartFiles& files : example_charts()) {
        if (files.name == name) return grafcet_of(files.chart);
    }
    FAIL("there is no example " << name);
    return grafcet_of("");
}

/// Nothing where the style cannot hold the chart.
std::optional<Netlist> netlist_for(const Grafcet& grafcet, Style style, const DelayModel& delays) {
    const CdxForm cdx = style_table[static_cast<std::size_t>(style)].default_cdx;
    Diagnostics diagnostics;
    return netlist_from(grafcet, equations_from(grafcet, {cdx, true}), style, diagnostics, delays);
}

/// Random single changes of the inputs, at times at which delays of the chart hardly ever end.
Stimuli random_walk(const Grafcet& grafcet, bool has_modes, RandomSource& random) {
    const std::size_t inputs = has_modes ? grafcet.all_input_count() : grafcet.inputs.size();
    InputValues values(grafcet.all_input_count(), 0);
    Stimuli stimuli;
    Time at = 0;
    for (std::size_t tried = 0; tried < 4 * instants_of_a_walk; ++tried) {
        if (inputs == 0 || stimuli.changes.size() == instants_of_a_walk) break;
        // Init, AUdur and AUdoux rarely, or nothing else is ever seen.
        const std::size_t input = random.below(
            random.one_in(6) ? inputs : std::max<std::size_t>(1, grafcet.inputs.size()));
        if (input >= inputs) continue;
        values[input] ^= 1U;
        if (broken_assumption(grafcet, values) != grafcet.assumptions.size()) {
            values[input] ^= 1U;
            continue;
        }
        at +=
            static_cast<Time>(100 + random.below(random.flip() ? 10'000 : 8'000'000)) * microsecond;
        stimuli.changes.push_back(
            {at, {{static_cast<std::uint32_t>(input), values[input] != 0}}, {}});
        stimuli.end = at;
    }
    return stimuli;
}

/// A circuit: a time for each edge of each gate, between bounds, as often near the shorter as near
/// the longer one.
CellDelays random_circuit(const Netlist& netlist, DelayBand band, RandomSource& random) {
    CellDelays circuit = cell_delays(netlist, {});
    const auto some_time = [&] {
        Time time = band.min;
        while (time < band.max && random.flip()) time = std::min(band.max, time * 2);
        const Time rest = std::min(time, band.max - time);
        return time + static_cast<Time>(random.below(static_cast<std::size_t>(rest) + 1));
    };
    for (Time& time : circuit.rise) time = some_time();
    for (Time& time : circuit.fall) time = some_time();
    return circuit;
}

/// Whether a circuit does over a walk what the reference does; true where that has no stable
/// situation.
bool is_right(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& circuit,
              const Stimuli& walk) {
    const RunResult expected = run_until_stable(grafcet, walk);
    if (expected.unstable_at) return true;
    const SimulateResult got = simulate(grafcet, netlist, circuit, walk, {});
    return !got.unsettled_at && got.trace.times == expected.trace.times &&
           got.trace.values == expected.trace.values;
}

/// Simulates so many circuits of a netlist, each over a walk of its own; how many are wrong.
std::size_t wrong_circuits(const Grafcet& grafcet, const Netlist& netlist, DelayBand band,
                           std::size_t count) {
    std::size_t wrong = 0;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        RandomSource random(seed);
        const Stimuli walk = random_walk(grafcet, netlist.has_modes, random);
        const CellDelays circuit = random_circuit(netlist, band, random);
        wrong += is_right(grafcet, netlist, circuit, walk) ? 0 : 1;
    }
    return wrong;
}

/// Any delay, as far as a simulation can go: the pulses of the netlist last longer.
constexpr DelayBand wide{nanosecond / 10, 30 * nanosecond};

}  // namespace

TEST_CASE("no circuit contradicts a proof, in any style of the small examples") {
    std::size_t proven = 0;
    std::size_t shown = 0;
    for (const char* name : {"single-sequence", "selection-divergence", "selection-convergence",
                             "parallel-divergence", "parallel-convergence", "rule-5"}) {
        CAPTURE(name);
        const Grafcet grafcet = example(name);
        for (const Style style : asynchronous_styles()) {
            CAPTURE(style_table[static_cast<std::size_t>(style)].name);
            for (const std::string_view delays : {"any", "1..4", "1..2"}) {
                CAPTURE(delays);
                const DelayModel model = *delay_model_of(delays);
                const auto netlist = netlist_for(grafcet, style, model);
                if (!netlist) break;
                const DelayBand band = model.kind == DelayModel::Kind::any ? wide : model.gate;
                const Verdict verdict = checked(grafcet, *netlist, delays, 3000).verdict;
                if (verdict == Verdict::undecided) continue;
                const std::size_t wrong = wrong_circuits(grafcet, *netlist, band, case_count(100));
                if (verdict == Verdict::different) {
                    shown += wrong == 0 ? 0 : 1;
                    continue;
                }
                CHECK(wrong == 0);
                ++proven;
                break;
            }
        }
    }
    MESSAGE(proven << " proofs without an exception; of the differences " << shown
                   << " show by chance");
    CHECK(proven > 6);
    CHECK(shown > 6);
}

TEST_CASE("handshake is proven under any delay on random plain charts") {
    std::size_t proven = 0;
    std::size_t open = 0;
    const std::size_t count = case_count(40);
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        CAPTURE(seed);
        RandomSource random(seed);
        Features features = Features::plain_chart();
        features.steps = 4 + random.below(7);
        features.inputs = 3;
        features.outputs = 2;
        const Grafcet grafcet = grafcet_of(plain_chart(random, features));
        const auto netlist = netlist_for(grafcet, Style::handshake, *delay_model_of("any"));
        REQUIRE(netlist);
        const CheckResult result = checked(grafcet, *netlist, "any", 3000);
        CHECK(result.verdict != Verdict::different);
        ++(result.verdict == Verdict::equivalent ? proven : open);
    }
    MESSAGE(proven << " proven, " << open << " not within 3000 cases");
    CHECK(proven > 3 * open);
}

}  // namespace grafwire::testing
