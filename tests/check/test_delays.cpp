// Verdicts about every circuit that delays allow: what they say holds in a simulation of any of
// these circuits.

#include <random>

#include "check/check_equivalence.h"
#include "check/netlist_witness.h"
#include "check/tolerance.h"
#include "evolution/run.h"
#include "netlist/part_families.h"
#include "netlist/passes/wire_delays.h"
#include "random/random_grafcet.h"
#include "random/read_text.h"
#include "settling/cell_bands.h"
#include "simulate/simulate.h"
#include "support/delay_checks.h"
#include "support/small_netlist.h"
#include "support/small_netlists.h"
#include "support/styles.h"

namespace grafwire::testing {

namespace {

constexpr const char* sequence = R"(
input a, b
output v
graph G {
  initial 0
  step 1 : v
  step 2
  0 -> 1 : a
  1 -> 2 : b
  2 -> 0 : /a
}
)";

constexpr const char* alone = R"(
input a
output v
graph G {
  initial 0 : v if a
}
)";

/// The netlist made for a delay model.
Netlist made_for(const Grafcet& grafcet, Style style, std::string_view delays) {
    const Equations equations = equations_from(grafcet, {CdxForm::successor, true});
    Diagnostics diagnostics;
    auto netlist = netlist_from(grafcet, equations, style, diagnostics, *delay_model_of(delays));
    REQUIRE(netlist);
    return std::move(*netlist);
}

/// Gates that take anything between two times, each edge for itself.
CellDelays random_delays(std::mt19937& random, const Netlist& netlist, Time least, Time most) {
    CellDelays delays = cell_delays(netlist, {});
    std::uniform_int_distribution<Time> between(least, most);
    for (Time& delay : delays.rise) delay = between(random);
    for (Time& delay : delays.fall) delay = between(random);
    return delays;
}

}  // namespace

TEST_CASE("delays: models by the words that ask for them") {
    CHECK(delay_model_of("unit")->is_fixed());
    CHECK(delay_model_of("any")->kind == DelayModel::Kind::any);
    const auto bounds = delay_model_of("0.4..1.6");
    REQUIRE(bounds);
    CHECK(bounds->kind == DelayModel::Kind::bounded);
    CHECK(bounds->gate == DelayBand{400, 1600});
    CHECK(delay_model_of("1..2")->gate == DelayBand{1000, 2000});
    for (const char* text :
         {"", "..", "1..", "..2", "2..1", "0..1", "-1..2", "1..2..3", "1.0000..2", "a..b", "1 .. 2",
          "Any", "1..99999999999999999999", "."}) {
        CAPTURE(text);
        CHECK(!delay_model_of(text));
    }
}

TEST_CASE("delays: a part family gives every cell bounds of its own") {
    const auto model = delay_model_of("74LS");
    REQUIRE(model);
    CHECK(model->kind == DelayModel::Kind::bounded);
    CHECK(model->family == part_family_named("74LS"));
    CHECK(model->gate == DelayBand{2'000, 33'000});
    CHECK(model->bands(CellType::nand_gate, 8) == edges(2, 23, 3, 30));
    // Two 74LS32, one behind the other or not.
    CHECK(model->bands(CellType::or_gate, 3) == either_edge(3, 66));
    // No part is a timer that counts scans.
    CHECK(model->bands(CellType::scan_timer, 2).rise == model->gate);
    CHECK(delay_model_of("4000-typical")->bands(CellType::nor_gate, 2) == either_edge(44, 200));
    CHECK(!delay_model_of("74hc"));
}

TEST_CASE("delays: what a witness takes lies within the bounds of each edge") {
    const Grafcet grafcet = grafcet_of(sequence);
    for (const char* family : {"74HC", "74LS", "4000"}) {
        CAPTURE(family);
        const Netlist netlist = made_for(grafcet, Style::nand, family);
        const CheckResult result = checked(grafcet, netlist, family);
        REQUIRE(result.verdict == Verdict::different);
        CHECK(replays(grafcet, netlist, *result.witness, family));
        REQUIRE(!result.witness->delays.changes.empty());
        const CellBands bands = cell_bands(netlist, *delay_model_of(family));
        for (const DelayChange& change : result.witness->delays.changes) {
            CAPTURE(netlist.names[netlist.cells[change.cell].output]);
            const DelayBand rise = bands.rise[index_of(change.cell)];
            const DelayBand fall = bands.fall[index_of(change.cell)];
            CHECK((rise.min <= change.rise && change.rise <= rise.max));
            CHECK((fall.min <= change.fall && change.fall <= fall.max));
        }
    }
}

TEST_CASE("delays: a step that never moves is right whatever they are") {
    const Grafcet grafcet = grafcet_of(alone);
    for (const Style style : asynchronous_styles()) {
        const CheckResult result = checked(grafcet, netlist_of(grafcet, style), "any");
        CHECK(result.verdict == Verdict::equivalent);
        CHECK(result.complete);
    }
}

TEST_CASE(
    "delays: a sequence of phase modules loses its step where gates may be as slow as they like") {
    const Grafcet grafcet = grafcet_of(sequence);
    for (const Style style : {Style::gates, Style::nand, Style::nor}) {
        const Netlist netlist = netlist_of(grafcet, style);
        const CheckResult result = checked(grafcet, netlist, "any");
        CHECK(result.verdict == Verdict::different);
        REQUIRE(result.witness);
        CHECK(!result.witness->delays.changes.empty());
        CHECK(replays(grafcet, netlist, *result.witness, "any"));
    }
}

TEST_CASE("delays: the same sequence is right between bounds that are close") {
    const Grafcet grafcet = grafcet_of(sequence);
    for (const Style style : {Style::gates, Style::nand}) {
        CHECK(checked(grafcet, made_for(grafcet, style, "1..1.5"), "1..1.5").verdict ==
              Verdict::equivalent);
        const Netlist netlist = made_for(grafcet, style, "1..8");
        const CheckResult result = checked(grafcet, netlist, "1..8");
        REQUIRE(result.verdict == Verdict::different);
        for (const DelayChange& change : result.witness->delays.changes) {
            CHECK(change.rise >= nanosecond);
            CHECK(change.rise <= 8 * nanosecond);
        }
        CHECK(replays(grafcet, netlist, *result.witness, "1..8"));
    }
}

TEST_CASE("delays: the ratio up to which a sequence is right lies between two that are checked") {
    const Grafcet grafcet = grafcet_of(sequence);
    for (const Style style : {Style::gates, Style::nand}) {
        const NetlistFor made = [&](const DelayModel& delays) {
            return std::optional(made_for(grafcet, style, delays.name));
        };
        const Tolerance tolerance = find_tolerance(grafcet, made, {});
        CHECK(!tolerance.is_unlimited);
        REQUIRE(tolerance.holds >= 15);
        CHECK(tolerance.fails == next_ratio(tolerance.holds));
        const std::string holds = delays_of_ratio(tolerance.holds).name;
        const std::string fails = delays_of_ratio(tolerance.fails).name;
        CHECK(checked(grafcet, made_for(grafcet, style, holds), holds).verdict ==
              Verdict::equivalent);
        REQUIRE(tolerance.witness);
        CHECK(replays(grafcet, made_for(grafcet, style, fails), *tolerance.witness, fails));
    }
}

TEST_CASE("delays: a ratio is told from both sides where checks are cut short") {
    const Grafcet grafcet = grafcet_of(sequence);
    const NetlistFor made = [&](const DelayModel& delays) {
        return std::optional(made_for(grafcet, Style::nand, delays.name));
    };
    CheckOptions options;
    options.max_cases = 1;
    const Tolerance cut = find_tolerance(grafcet, made, options);
    CHECK(cut.holds == 0);
    CHECK(!cut.is_unlimited);
    options.max_cases = 0;
    options.keep_going = [] { return false; };
    const Tolerance stopped = find_tolerance(grafcet, made, options);
    CHECK(stopped.holds == 0);
    CHECK(stopped.fails == 0);
}

TEST_CASE("delays: ratios have two digits") {
    CHECK(next_ratio(0) == 10);
    CHECK(next_ratio(10) == 11);
    CHECK(next_ratio(99) == 100);
    CHECK(next_ratio(100) == 110);
    CHECK(delays_of_ratio(17).gate == DelayBand{1'000, 1'700});
    CHECK(delays_of_ratio(120).gate == DelayBand{1'000, 12'000});
}

TEST_CASE("delays: with wires of any delay a difference replays in the netlist that has them") {
    const Grafcet grafcet = grafcet_of(sequence);
    for (const Style style : {Style::gates, Style::nand, Style::rs}) {
        const Netlist netlist = netlist_of(grafcet, style);
        const Netlist wired = with_wire_delays(netlist, telling_wires(netlist));
        const CheckResult result = checked(grafcet, wired, "any-wire");
        CHECK(result.verdict != Verdict::equivalent);
        if (result.verdict != Verdict::different) continue;
        CHECK(replays(grafcet, wired, *result.witness, "any-wire"));
    }
    const Grafcet still = grafcet_of(alone);
    const Netlist netlist = netlist_of(still, Style::nand);
    CHECK(checked(still, with_wire_delays(netlist, telling_wires(netlist)), "any-wire").verdict ==
          Verdict::equivalent);
}

TEST_CASE("delays: no circuit within the bounds contradicts an equivalence") {
    const Grafcet grafcet = grafcet_of(sequence);
    std::mt19937 random(17);
    for (const Style style : {Style::gates, Style::nand}) {
        const Netlist netlist = made_for(grafcet, style, "1..1.5");
        REQUIRE(checked(grafcet, netlist, "1..1.5").verdict == Verdict::equivalent);
        for (int number = 0; number < 300; ++number) {
            const Stimuli stimuli = single_changes(random, grafcet);
            const CellDelays delays = random_delays(random, netlist, 1000, 1500);
            CHECK(!replay(grafcet, netlist, delays, stimuli, 0));
        }
    }
}

TEST_CASE("delays: random charts; a difference replays, an equivalence is not contradicted") {
    std::mt19937 random(23);
    int differences = 0;
    int equivalences = 0;
    Features features = Features::plain_chart();
    features.steps = 5;
    features.graphs = 1;
    features.inputs = 2;
    features.outputs = 1;
    features.assumptions = false;
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        RandomSource source(seed);
        const std::string text = random_grafcet(source, features);
        CAPTURE(text);
        const auto grafcet = read_grafcet(text);
        REQUIRE(grafcet);
        const Netlist netlist = netlist_of(*grafcet, seed % 2 == 0 ? Style::nand : Style::gates);
        for (const std::string delays : {"any", "1..1.2"}) {
            CAPTURE(delays);
            const CheckResult result = checked(*grafcet, netlist, delays, 400);
            if (result.verdict == Verdict::different) {
                ++differences;
                CHECK(replays(*grafcet, netlist, *result.witness, delays));
            }
            if (result.verdict != Verdict::equivalent) continue;
            ++equivalences;
            for (int number = 0; number < 20; ++number) {
                const Stimuli stimuli = single_changes(random, *grafcet);
                const CellDelays circuit = random_delays(random, netlist, 1000, 1200);
                CHECK(!replay(*grafcet, netlist, circuit, stimuli, 0));
            }
        }
    }
    CHECK(differences > 10);
    CHECK(equivalences > 3);
}

TEST_CASE("delays: a memory that moves by itself at power-up leaves the verdict open") {
    const Grafcet grafcet = grafcet_of(std::string("assume /AUdur\nassume /AUdoux") + alone);
    SmallNetlist small;
    small.input("a");
    small.input("Init");
    small.cell(CellType::high, "X0", {});
    small.cell(CellType::buffer, "q", {"Init"});
    small.cell(CellType::inverter, "not_q", {"q"});
    small.cell(CellType::or_gate, "either", {"q", "not_q"});
    small.cell(CellType::and_gate, "v", {"a", "either"});
    small.output("X0");
    small.output("v");
    small.netlist.step_count = 1;
    small.netlist.has_modes = true;
    CHECK(checked(grafcet, small.netlist, "any").verdict == Verdict::equivalent);
    small.starts_at("q", false);
    CHECK(checked(grafcet, small.netlist, "unit").verdict == Verdict::equivalent);
    CHECK(checked(grafcet, small.netlist, "any").verdict == Verdict::undecided);
}

}  // namespace grafwire::testing
