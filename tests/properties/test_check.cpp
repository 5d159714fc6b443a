// The check on random charts: a clocked netlist is right by construction, so the verdict must never
// be "different"; a wiring of NAND latches may be wrong, and then the witness must show it again.

#include <doctest/doctest.h>

#include "check/check_equivalence.h"
#include "check/netlist_witness.h"
#include "properties/netlist_in.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "support/backward_workers.h"
#include "support/styles.h"

namespace grafwire::testing {

namespace {

CheckResult checked(const Grafcet& grafcet, const Netlist& netlist, std::uint64_t max_cases) {
    CheckOptions options;
    options.max_cases = max_cases;
    return check_equivalence(grafcet, netlist, options);
}

std::string witness_text(const Grafcet& grafcet, const Witness& witness) {
    std::string text = "witness\n" + write_stimuli(witness.stimuli, grafcet);
    for (const Witness::Value& value : witness.values) {
        if (value.expected == value.got) continue;
        text += value.name + ": expected " + std::to_string(static_cast<int>(value.expected)) +
                ", got " + std::to_string(static_cast<int>(value.got)) + "\n";
    }
    return text;
}

struct Verdicts {
    std::size_t equivalent = 0;
    std::size_t different = 0;
    std::size_t undecided = 0;
    void count(Verdict verdict) {
        ++(verdict == Verdict::equivalent  ? equivalent
           : verdict == Verdict::different ? different
                                           : undecided);
    }
};

std::string clocked_is_never_different(const RandomCase& item, Verdicts& tally) {
    const auto grafcet = read_grafcet(item.chart);
    const auto netlist = netlist_in(*grafcet, Style::clocked);
    const CheckResult result = checked(*grafcet, *netlist, 3000);
    tally.count(result.verdict);
    if (result.verdict == Verdict::different) return witness_text(*grafcet, *result.witness);
    return {};
}

/// Of an asynchronous style: a witness that replays wherever the verdict is "different".
std::string witness_replays(const RandomCase& item, Style style, Verdicts& tally) {
    const auto grafcet = read_grafcet(item.chart);
    const auto netlist = netlist_in(*grafcet, style);
    if (!netlist) return style == Style::handshake ? "" : "no netlist";
    const CheckResult result = checked(*grafcet, *netlist, 20'000);
    tally.count(result.verdict);
    if (result.verdict != Verdict::different) {
        if (result.witness) return "a witness without a difference";
        return {};
    }
    if (!result.witness) return "no witness";
    for (const Stimuli::Change& change : result.witness->stimuli.changes) {
        if (netlist->is_clocked() || change.at == 0 || change.assignments.size() < 2) continue;
        if (grafcet->assumptions.empty()) return "changes several inputs at once";
    }
    const Time period = result.witness->scan_period;
    const auto again =
        replay(*grafcet, *netlist, cell_delays(*netlist, {}), result.witness->stimuli, period);
    if (!again) return "does not replay: " + witness_text(*grafcet, *result.witness);
    if (again->kind != result.witness->kind) return "replays as a difference of another kind";
    const auto written = read_stimuli(write_stimuli(result.witness->stimuli, *grafcet), *grafcet);
    if (!written) return "the stimuli of the witness cannot be read";
    if (!replay(*grafcet, *netlist, cell_delays(*netlist, {}), *written, period)) {
        return "does not replay once written and read";
    }
    return {};
}

/// All that a check came to.
std::string told(const Grafcet& grafcet, const CheckResult& result) {
    std::string text = std::to_string(static_cast<int>(result.verdict)) + " after " +
                       std::to_string(result.coverage.cases) + " cases, " +
                       std::to_string(result.coverage.situations) + " situations, " +
                       std::to_string(result.coverage.waiting) + " waiting\n";
    if (result.witness) text += witness_text(grafcet, *result.witness);
    if (result.together && result.together->witness) {
        text += "together: " + witness_text(grafcet, *result.together->witness);
    }
    return text;
}

std::string is_the_same_for_several_workers(const RandomCase& item, Style style) {
    const auto grafcet = read_grafcet(item.chart);
    const auto netlist = netlist_in(*grafcet, style);
    if (!netlist) return {};
    CheckOptions options;
    options.max_cases = 100;
    options.looks_at_many = false;
    options.delays.kind = DelayModel::Kind::any;
    const std::string alone = told(*grafcet, check_equivalence(*grafcet, *netlist, options));
    BackwardWorkers workers;
    options.workers = &workers;
    const std::string shared = told(*grafcet, check_equivalence(*grafcet, *netlist, options));
    return shared == alone ? "" : "alone: " + alone + "shared: " + shared;
}

}  // namespace

TEST_CASE("several workers come to what one comes to alone") {
    Features few = Features::plain_chart();
    few.steps = 4;
    few.inputs = 2;
    // In other styles a single case can take a million orders of gates.
    const Property property = [](const RandomCase& item) {
        return is_the_same_for_several_workers(item, Style::handshake);
    };
    check_property(property, few, 1'200'000, 30, 1);
}

TEST_CASE("no clocked netlist of a small random chart is different") {
    Verdicts tally;
    const Property property = [&](const RandomCase& item) {
        return clocked_is_never_different(item, tally);
    };
    check_property(property, Features::small(), 1'000'000, 400, 1);
    MESSAGE("clocked: " << tally.equivalent << " equivalent, " << tally.undecided
                        << " undecided within the bound");
    CHECK(tally.equivalent > tally.undecided);
}

TEST_CASE("asynchronous netlists of plain charts: every witness replays") {
    Features features = Features::plain_chart();
    features.steps = 8;
    features.inputs = 3;
    for (const Style style : asynchronous_styles()) {
        Verdicts tally;
        const Property property = [&](const RandomCase& item) {
            return witness_replays(item, style, tally);
        };
        check_property(property, features, 1'100'000, 300, 1);
        MESSAGE(style_table[static_cast<std::size_t>(style)].name
                << ": " << tally.equivalent << " equivalent, " << tally.different << " different, "
                << tally.undecided << " undecided");
        CHECK(tally.equivalent != 0);
    }
}

TEST_CASE("asynchronous netlists of any charts: every witness replays") {
    Features features = Features::small();
    features.counters = 0;
    for (const Style style : asynchronous_styles()) {
        Verdicts tally;
        const Property property = [&](const RandomCase& item) {
            return witness_replays(item, style, tally);
        };
        check_property(property, features, 1'200'000, 300, 1);
        MESSAGE(style_table[static_cast<std::size_t>(style)].name
                << ": " << tally.equivalent << " equivalent, " << tally.different << " different, "
                << tally.undecided << " undecided");
    }
}

}  // namespace grafwire::testing
