// A referee for the check of netlists: whatever it calls equivalent is run at random in another
// simulator, with two values and nothing in common with the product's but the netlist, beside the
// reference; whatever it calls different must show its difference there. Charts of all kinds, their
// netlists as they are made, and mutants of these.

#include <doctest/doctest.h>
#include <fmt/core.h>

#include <array>

#include "check/check_equivalence.h"
#include "check/netlist_witness.h"
#include "netlist/styles/styles.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "referee/charts.h"
#include "referee/graft.h"
#include "referee/pair_run.h"
#include "referee/random_walk.h"
#include "support/mutate.h"
#include "support/styles.h"

namespace grafwire::testing {

namespace {

constexpr std::size_t netlist_walks = 8;
constexpr std::size_t steps_of_walk = 60;
/// How often power-up is tried where the gates leave something open there.
constexpr std::size_t power_ups = 64;

struct NetlistCounts {
    std::size_t equivalent = 0;
    std::size_t different = 0;
    std::size_t undecided = 0;
    std::size_t runs = 0;
    std::size_t instants = 0;
    std::size_t contradicted = 0;
    std::size_t found = 0;  ///< of the different ones: those that random runs find as well
    std::size_t replayed = 0;
    std::size_t not_replayed = 0;
    std::size_t elsewhere = 0;  ///< other stimuli than those of the witness show a difference
    std::size_t open = 0;       ///< none do: known values would be right in every run tried

    void print(const char* what) const {
        fmt::print(
            "{}: {} equivalent, {} different ({} found by runs), {} undecided; {} runs, {} "
            "instants, {} contradictions; witnesses: {} replayed, {} not, {} shown by other "
            "stimuli, {} in three values only\n",
            what, equivalent, different, found, undecided, runs, instants, contradicted, replayed,
            not_replayed, elsewhere, open);
    }
};

/// A netlist, and all that is needed to make it again.
struct NetlistCase {
    std::string chart;  ///< its text
    Style style = Style::gates;
    bool modes = true;
    std::string mutation;  ///< empty: as it was made
    std::uint64_t seed = 0;
};

std::string told(const NetlistCase& item, const std::string& what, const Grafcet& grafcet,
                 const Stimuli& stimuli, Time scan_period) {
    return fmt::format("{}\nstyle {}, modes {}, {}, seed {}\n{}--- chart\n{}--- stimuli\n{}--- end",
                       what, style_table[static_cast<std::size_t>(item.style)].name,
                       item.modes ? "on" : "off", item.mutation.empty() ? "as made" : item.mutation,
                       item.seed,
                       scan_period == 0 ? std::string("until stable\n")
                                        : "every " + format_duration(scan_period) + "\n",
                       item.chart, write_stimuli(stimuli, grafcet));
}

CheckResult checked(const Grafcet& grafcet, const Netlist& netlist, std::uint64_t max_cases) {
    CheckOptions options;
    options.max_cases = max_cases;
    return check_equivalence(grafcet, netlist, options);
}

/// Runs in search of a difference; the first that shows one.
std::optional<Walk> contradicting_walk(const NetlistCase& item, const Grafcet& grafcet,
                                       const Netlist& netlist, Happens happens,
                                       NetlistCounts& counts) {
    RandomSource random(item.seed);
    for (std::size_t i = 0; i < netlist_walks; ++i) {
        const Time period = netlist.is_clocked() ? random_period(grafcet, random) : 0;
        Walk walk = random_walk(grafcet, netlist, happens, period, random, steps_of_walk);
        ++counts.runs;
        counts.instants += walk.instants;
        if (!walk.contradiction.empty()) return walk;
    }
    return std::nullopt;
}

void judge_equivalent(const NetlistCase& item, const Grafcet& grafcet, const Netlist& netlist,
                      Happens happens, NetlistCounts& counts) {
    ++counts.equivalent;
    const auto walk = contradicting_walk(item, grafcet, netlist, happens, counts);
    if (!walk) return;
    ++counts.contradicted;
    FAIL_CHECK(told(item, "called equivalent, but " + walk->contradiction, grafcet, walk->stimuli,
                    walk->scan_period));
}

/// Whether a witness shows its difference from some state at power-up.
bool shows(const Grafcet& grafcet, const Netlist& netlist, const Witness& witness,
           std::uint64_t seed) {
    if (!witness.power_up.empty()) {
        std::vector<bool> values(netlist.net_count());
        for (const auto& initial : witness.power_up) values[index_of(initial.net)] = initial.value;
        return replayed(grafcet, netlist, witness.stimuli, witness.scan_period, false, values)
            .has_value();
    }
    RandomSource random(seed);
    InputValues inputs(grafcet.all_input_count(), 0);
    for (const Stimuli::Change& change : witness.stimuli.changes) {
        if (change.at != 0) break;
        for (const auto& set : change.assignments) inputs[set.input] = set.value ? 1 : 0;
    }
    for (std::size_t i = 0; i < power_ups; ++i) {
        if (replayed(grafcet, netlist, witness.stimuli, witness.scan_period, i % 2 == 1,
                     random_power_up(grafcet, netlist, inputs, random))) {
            return true;
        }
    }
    return false;
}

/// A race shows a value that the gates leave open, and an oscillation may be one of such values:
/// three values do so now and then where two would not. Then another run has to differ. If none
/// does, the verdict rests on the three values alone.
void judge_different(const NetlistCase& item, const Grafcet& grafcet, const Netlist& netlist,
                     const Witness& witness, Happens happens, NetlistCounts& counts) {
    ++counts.different;
    const bool differs = contradicting_walk(item, grafcet, netlist, happens, counts).has_value();
    counts.found += differs ? 1 : 0;
    if (shows(grafcet, netlist, witness, item.seed)) {
        ++counts.replayed;
        return;
    }
    const bool is_at_start = witness.stimuli.end == 0;
    if (witness.kind == DifferenceKind::race ||
        (witness.kind == DifferenceKind::oscillation && is_at_start)) {
        ++(differs ? counts.elsewhere : counts.open);
        return;
    }
    ++counts.not_replayed;
    FAIL_CHECK(told(item, "called different, but the witness shows nothing", grafcet,
                    witness.stimuli, witness.scan_period));
}

void judge_verdict(const NetlistCase& item, const Grafcet& grafcet, const Netlist& netlist,
                   Verdict verdict, const std::optional<Witness>& witness, Happens happens,
                   NetlistCounts& counts) {
    switch (verdict) {
        case Verdict::undecided:
            ++counts.undecided;
            break;
        case Verdict::equivalent:
            judge_equivalent(item, grafcet, netlist, happens, counts);
            break;
        case Verdict::different:
            REQUIRE(witness);
            judge_different(item, grafcet, netlist, *witness, happens, counts);
            break;
    }
}

/// What the check says of one change at a time, and where that is equivalent of many at once.
void judge(const NetlistCase& item, const Grafcet& grafcet, const Netlist& netlist,
           std::uint64_t max_cases, NetlistCounts& counts) {
    const CheckResult result = checked(grafcet, netlist, max_cases);
    const Happens happens = netlist.is_clocked() ? Happens::many_things : Happens::one_thing;
    judge_verdict(item, grafcet, netlist, result.verdict, result.witness, happens, counts);
    if (!result.together) return;
    judge_verdict(item, grafcet, netlist, result.together->verdict, result.together->witness,
                  Happens::many_things, counts);
}

std::optional<Netlist> netlist_in(const Grafcet& grafcet, Style style, bool modes) {
    const CdxForm cdx = style_table[static_cast<std::size_t>(style)].default_cdx;
    const Equations equations = equations_from(grafcet, {cdx, modes});
    Diagnostics diagnostics;
    return netlist_from(grafcet, equations, style, diagnostics);
}

/// A netlist that is probably wrong: one of another chart, one with something foreign in it, one
/// with a slip of the hand. `told`: in words, what was done.
std::optional<Netlist> spoiled(const NetlistCase& item, const Grafcet& grafcet,
                               const Netlist& netlist, RandomSource& random, std::string& told) {
    if (random.one_in(4)) {
        const std::string text = altered(item.chart, random);
        const auto other = read_grafcet(text);
        if (!other) return std::nullopt;
        // The timers are to stand for the same time conditions.
        if (other->expressions.time_conditions().size() !=
            grafcet.expressions.time_conditions().size()) {
            return std::nullopt;
        }
        told = "made of another chart:\n" + text;
        return netlist_in(*other, item.style, item.modes);
    }
    if (random.flip()) return grafted(netlist, random, told);
    const std::vector<Mutation> mutations = mutations_of(netlist);
    if (mutations.empty()) return std::nullopt;
    const Mutation& mutation = random.pick(mutations);
    told = describe(netlist, mutation);
    return mutated(netlist, mutation);
}

void judge_mutants(NetlistCase item, const Grafcet& grafcet, std::size_t count,
                   std::uint64_t max_cases, NetlistCounts& counts) {
    const auto netlist = netlist_in(grafcet, item.style, item.modes);
    if (!netlist) return;
    RandomSource random(item.seed);
    for (std::size_t i = 0; i < count; ++i) {
        const auto wrong = spoiled(item, grafcet, *netlist, random, item.mutation);
        if (!wrong) continue;
        REQUIRE(fault_of(*wrong) == "");
        judge(item, grafcet, *wrong, max_cases, counts);
    }
}

}  // namespace

TEST_CASE("referee: the netlists of the examples") {
    NetlistCounts counts;
    for (const auto& [name, text] : texts_of_examples()) {
        const auto grafcet = read_grafcet(text);
        REQUIRE(grafcet);
        for (const Style style : all_styles()) {
            for (const bool modes : {true, false}) {
                const auto netlist = netlist_in(*grafcet, style, modes);
                if (netlist) judge({text, style, modes, "", 1}, *grafcet, *netlist, 4000, counts);
            }
        }
    }
    counts.print("examples");
    CHECK(counts.equivalent > 20);
}

TEST_CASE("referee: the netlists of random charts") {
    NetlistCounts counts;
    const std::size_t charts = case_count(300);
    for (std::uint64_t seed = 5'000'000; seed < 5'000'000 + charts; ++seed) {
        const std::string text = chart_of(seed);
        const auto grafcet = read_grafcet(text);
        REQUIRE(grafcet);
        for (const Style style : all_styles()) {
            const bool modes = seed % 3 != 0;
            const auto netlist = netlist_in(*grafcet, style, modes);
            if (netlist) judge({text, style, modes, "", seed}, *grafcet, *netlist, 3000, counts);
        }
    }
    counts.print("random charts");
    CHECK(counts.equivalent > charts / 2);
}

TEST_CASE("referee: mutants of the netlists of the examples") {
    NetlistCounts counts;
    const auto texts = texts_of_examples();
    const std::size_t each = 1 + case_count(600) / (4 * texts.size());
    for (const auto& [name, text] : texts) {
        const auto grafcet = read_grafcet(text);
        for (const Style style : all_styles()) {
            judge_mutants({text, style, true, "", 2}, *grafcet, each, 3000, counts);
        }
    }
    counts.print("mutants of examples");
    CHECK(counts.different > counts.equivalent);
    CHECK(counts.found > counts.different / 2);
    CHECK(counts.open <= 1 + counts.different / 100);
}

TEST_CASE("referee: mutants of the netlists of random charts") {
    NetlistCounts counts;
    // Its gates wait for one another by more inputs than most charts need.
    NetlistCounts of_handshake;
    const std::size_t charts = 1 + case_count(2400) / 8;
    for (std::uint64_t seed = 6'000'000; seed < 6'000'000 + charts; ++seed) {
        const std::string text = chart_of(seed);
        const auto grafcet = read_grafcet(text);
        REQUIRE(grafcet);
        for (const Style style : all_styles()) {
            NetlistCounts& of_style = style == Style::handshake ? of_handshake : counts;
            judge_mutants({text, style, seed % 3 != 0, "", seed}, *grafcet, 2, 2000, of_style);
        }
    }
    counts.print("mutants of random charts");
    of_handshake.print("mutants of random charts, handshake");
    CHECK(counts.different > counts.equivalent);
    for (const NetlistCounts* each : {&counts, &of_handshake}) {
        CHECK(each->found > each->different / 2);
        CHECK(each->open <= 1 + each->different / 100);
    }
}

}  // namespace grafwire::testing
