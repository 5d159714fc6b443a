// Wrong wiring with timers on random charts: what random stimuli can tell from the reference, the
// check calls different. So no timing is overlooked: neither of delays that overlap in every way
// nor of timers that run while those of the GRAFCET do not.

#include <doctest/doctest.h>

#include "check/check_equivalence.h"
#include "check/netlist_witness.h"
#include "evolution/run.h"
#include "properties/netlist_in.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "support/mutate.h"

namespace grafwire::testing {

namespace {

struct Mutants {
    std::size_t alike = 0;  ///< the stimuli show no difference
    std::size_t found = 0;
    std::size_t undecided = 0;
};

bool stimuli_show_it(const Grafcet& grafcet, const Netlist& netlist, const Stimuli& stimuli) {
    const Time period = netlist.is_clocked() ? millisecond : 0;
    const RunResult expected =
        period == 0 ? run_until_stable(grafcet, stimuli) : run_scans(grafcet, stimuli, period);
    if (!expected.broken_assumptions.empty()) return false;
    return replay(grafcet, netlist, cell_delays(netlist, {}), stimuli, period).has_value();
}

/// Some mutants of a netlist, a few cells apart.
std::string mutants_are_found(const RandomCase& item, Style style, Mutants& tally) {
    const auto grafcet = read_grafcet(item.chart);
    const auto stimuli = read_stimuli(item.stimuli, *grafcet);
    const auto netlist = netlist_in(*grafcet, style);
    if (!netlist) return "no netlist";
    const std::vector<Mutation> mutations = mutations_of(*netlist);
    for (std::size_t i = 0; i < mutations.size(); i += 23) {
        const Netlist wrong = mutated(*netlist, mutations[i]);
        if (!stimuli_show_it(*grafcet, wrong, *stimuli)) {
            ++tally.alike;
            continue;
        }
        CheckOptions options;
        options.changes = Changes::many;  // as the stimuli do
        options.max_cases = 5000;
        const CheckResult result = check_equivalence(*grafcet, wrong, options);
        if (result.verdict == Verdict::equivalent) {
            return "overlooked: " + describe(*netlist, mutations[i]);
        }
        ++(result.verdict == Verdict::different ? tally.found : tally.undecided);
    }
    return {};
}

Features with_three_times() {
    Features features = Features::small();
    features.counters = 0;
    features.time_conditions = 3;
    features.edges = 1;
    return features;
}

}  // namespace

TEST_CASE("the check overlooks no wrong timer that random stimuli find") {
    for (const Style style : {Style::gates, Style::nand, Style::clocked}) {
        Mutants tally;
        const Property property = [&](const RandomCase& item) {
            return mutants_are_found(item, style, tally);
        };
        check_property(property, with_three_times(), 1'500'000, 100, 20);
        MESSAGE(style_table[static_cast<std::size_t>(style)].name
                << ": " << tally.found << " found, " << tally.undecided
                << " undecided within the bound, " << tally.alike << " not shown by the stimuli");
        CHECK(tally.found > 10 * tally.undecided);
    }
}

}  // namespace grafwire::testing
