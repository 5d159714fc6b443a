// Mistakes in the wiring of the handshake style, under any delay of its gates: a difference is
// shown by delays that a simulation replays, an equivalence is proven by the explorer of the tests.

#include <doctest/doctest.h>

#include "delays/chart_orders.h"
#include "delays/delay_cases.h"
#include "support/delay_checks.h"
#include "support/mutate.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

const char* const mutated_charts[] = {
    "input a, b\noutput o\ngraph G {\ninitial 1\nstep 2 : o\nstep 3\n"
    "1 -> 2 : a\n2 -> 3 : b\n3 -> 1 : /a\n}\n",
    "input a, b, c\noutput o\nassume /(a . b)\ngraph G {\ninitial 1\nstep 2 : o\nstep 3\nstep 4\n"
    "1 -> 2 : a\n1 -> 3 : b\n2 -> 4 : c\n3 -> 4 : c\n4 -> 1 : /c\n}\n",
    "input a, b, c\noutput o\ngraph G {\ninitial 1\nstep 2\nstep 3 : o\nstep 4\nstep 5\n"
    "1 -> 2, 3 : a\n2 -> 4 : b\n3 -> 5 : c\n4, 5 -> 1 : /a\n}\n",
};

/// One of so many mistakes is tried; with 1, all.
constexpr std::size_t every = 3;

struct MutantCounts {
    int different = 0;
    int equivalent = 0;
    int undecided = 0;  ///< a memory that nothing brings to a known value at power-up, mostly
};

void judge_mutant(const Grafcet& grafcet, const Netlist& netlist, MutantCounts& counts) {
    const CheckResult result = checked(grafcet, netlist, "any");
    if (result.verdict == Verdict::different) {
        REQUIRE(result.witness);
        CHECK(replays(grafcet, netlist, *result.witness, "any"));
        ++counts.different;
        return;
    }
    if (result.verdict == Verdict::undecided) {
        ++counts.undecided;
        return;
    }
    ChartOrders orders(grafcet);
    DelayOptions options;
    options.is_ordered = [&](const ChartCase& item) { return orders.depends_on_order(item); };
    CHECK(explore_delays(grafcet, netlist, options).first_wrong == "");
    ++counts.equivalent;
}

}  // namespace

TEST_CASE(
    "mutants of handshake under any delay: each is told apart, or proven to make no difference") {
    MutantCounts counts;
    for (const char* chart : mutated_charts) {
        CAPTURE(chart);
        const Grafcet grafcet = grafcet_of(chart);
        const Netlist netlist = netlist_of(grafcet, Style::handshake, true);
        CHECK(checked(grafcet, netlist, "any").verdict == Verdict::equivalent);
        const std::vector<Mutation> mutations = mutations_of(netlist);
        for (std::size_t i = 0; i < mutations.size(); i += every) {
            CAPTURE(describe(netlist, mutations[i]));
            judge_mutant(grafcet, mutated(netlist, mutations[i]), counts);
        }
    }
    MESSAGE(counts.different, " different, ", counts.equivalent, " equivalent, ", counts.undecided,
            " undecided");
    CHECK(counts.different > 100);
    CHECK(20 * counts.undecided < counts.different);
}

}  // namespace grafwire::testing
