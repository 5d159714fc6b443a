// X and outputs that change more often in an instant than the GRAFCET asks for: known hazards, and
// on random charts what simulations with random delays show.

#include <algorithm>
#include <random>

#include "check/check_equivalence.h"
#include "check/netlist_from_blif.h"
#include "evolution/evolution.h"
#include "netlist/passes/wire_delays.h"
#include "random/random_cases.h"
#include "random/random_grafcet.h"
#include "random/read_text.h"
#include "simulate/simulate.h"
#include "support/delay_checks.h"
#include "support/small_netlists.h"
#include "support/styles.h"

namespace grafwire::testing {

namespace {

CheckOptions options_for(std::string_view delays, std::uint64_t max_cases = 0) {
    CheckOptions options;
    options.delays = *delay_model_of(delays);
    options.looks_at_many = false;
    options.looks_for_pulses = true;
    options.max_cases = max_cases;
    return options;
}

/// How often each net changes in each instant of a run, for as long as the run is right.
struct ChangesInRun {
    std::vector<Time> instants;
    std::vector<std::vector<unsigned>> counts;  ///< per instant and net
    Trace trace;
};
ChangesInRun changes_in_run(const Grafcet& grafcet, const Netlist& netlist,
                            const CellDelays& delays, const Stimuli& stimuli,
                            const DelaySchedule& schedule = {}) {
    ChangesInRun run;
    SimulateOptions options;
    options.schedule = schedule;
    options.instant = [&](Time at, const Simulator&) {
        run.instants.push_back(at);
        run.counts.emplace_back(netlist.net_count());
    };
    options.observer = [&](Time, NetId net, Logic) {
        if (!run.counts.empty()) ++run.counts.back()[index_of(net)];
    };
    run.trace = simulate(grafcet, netlist, delays, stimuli, options).trace;
    return run;
}

/// Looks, and holds every find against a simulation of its own.
Pulses pulses_of(const Grafcet& grafcet, const Netlist& netlist, const CheckOptions& options) {
    const CheckResult result = check_equivalence(grafcet, netlist, options);
    REQUIRE(result.pulses);
    for (const Pulse& pulse : result.pulses->found) {
        CAPTURE(pulse.name);
        const ChangesInRun run = changes_in_run(
            grafcet, netlist, cell_delays(netlist, options.delays), pulse.stimuli, pulse.delays);
        CHECK(run.instants.back() == pulse.stimuli.end);
        CHECK(run.counts.back()[index_of(pulse.net)] == pulse.got);
        CHECK(pulse.got > pulse.expected);
        CHECK((pulse.got - pulse.expected) % 2 == 0);
    }
    return *result.pulses;
}

Pulses pulses_of(const Grafcet& grafcet, Style style, std::string_view delays) {
    const Equations equations =
        equations_from(grafcet, {style_table[static_cast<std::size_t>(style)].default_cdx, true});
    Diagnostics diagnostics;
    const auto netlist =
        netlist_from(grafcet, equations, style, diagnostics, *delay_model_of(delays));
    REQUIRE(netlist);
    return pulses_of(grafcet, *netlist, options_for(delays));
}

const Pulse* pulse_of(const Pulses& pulses, std::string_view name) {
    for (const Pulse& pulse : pulses.found) {
        if (pulse.name == name) return &pulse;
    }
    return nullptr;
}

constexpr const char* selection = R"(
input a, b, c
output v
graph G {
  initial 0 : v if a.b + /a.c
}
)";

/// a.b + /a.c in gates, with or without b.c beside them.
std::string selection_in_gates(bool with_consensus) {
    std::string text = R"(.model selection
.inputs a b c Init AUdur AUdoux
.outputs X0 v
.names X0 Init held
1- 1
-1 1
.names held AUdur X0
10 1
.names a na
0 1
.names a b first
11 1
.names na c second
11 1
.names b c both
11 1
)";
    text += with_consensus ? ".names first second both any\n1-- 1\n-1- 1\n--1 1\n"
                           : ".names first second any\n1- 1\n-1 1\n";
    return text + ".names AUdoux nx\n0 1\n.names X0 nx any v\n111 1\n.end\n";
}

}  // namespace

TEST_CASE("pulses: a.b + /a.c falls for a moment as a changes, unless b.c covers the change") {
    const Grafcet grafcet = grafcet_of(selection);
    for (const std::string delays : {"unit", "1..2", "74HC", "any"}) {
        CAPTURE(delays);
        const Pulses bare =
            pulses_of(grafcet, blif(grafcet, selection_in_gates(false)), options_for(delays));
        CHECK(bare.complete);
        CHECK(bare.open.empty());
        const Pulse* found = pulse_of(bare, "v");
        REQUIRE(found != nullptr);
        CHECK(found->expected == 0);
        CHECK(found->got == 2);
        const Pulses covered =
            pulses_of(grafcet, blif(grafcet, selection_in_gates(true)), options_for(delays));
        CHECK(covered.complete);
        CHECK(covered.open.empty());
        CHECK(pulse_of(covered, "v") == nullptr);
    }
}

TEST_CASE("pulses: wires that take time are gone through as well") {
    const Grafcet grafcet = grafcet_of(selection);
    for (const bool with_consensus : {false, true}) {
        const Netlist netlist = blif(grafcet, selection_in_gates(with_consensus));
        const Netlist wired = with_wire_delays(netlist, telling_wires(netlist));
        const Pulses pulses = pulses_of(grafcet, wired, options_for("any-wire"));
        CHECK(pulses.complete);
        CHECK(pulses.open.empty());
        CHECK((pulse_of(pulses, "v") == nullptr) == with_consensus);
    }
}

TEST_CASE("pulses: changes that transient situations ask for are none") {
    const Grafcet grafcet = grafcet_of(R"(
input a
output v, w
graph G {
  initial 0
  step 1 : v
  step 2 : w
  0 -> 1 : a
  1 -> 2 : a
  2 -> 0 : /a
}
)");
    for (const std::string delays : {"unit", "1..1.5", "any"}) {
        CAPTURE(delays);
        const Pulses pulses = pulses_of(grafcet, Style::handshake, delays);
        CHECK(pulses.complete);
        CHECK(pulses.open.empty());
        for (const char* name : {"X0", "X1", "X2", "v", "w"}) {
            CAPTURE(name);
            CHECK(pulse_of(pulses, name) == nullptr);
        }
    }
}

TEST_CASE("pulses: they are no part of the verdict, and bounds hold for them as well") {
    const Grafcet grafcet = grafcet_of(selection);
    const Netlist netlist = blif(grafcet, selection_in_gates(false));
    CheckOptions options = options_for("any");
    const CheckResult with = check_equivalence(grafcet, netlist, options);
    options.looks_for_pulses = false;
    const CheckResult without = check_equivalence(grafcet, netlist, options);
    CHECK(!without.pulses);
    CHECK(with.verdict == without.verdict);
    CHECK(with.coverage.cases == without.coverage.cases);
    const Pulses few = pulses_of(grafcet, netlist, options_for("any", 3));
    CHECK(!few.complete);
    CHECK(few.cases <= 3);
    CheckOptions stopped = options_for("any");
    stopped.keep_going = [] { return false; };
    CHECK(!pulses_of(grafcet, netlist, stopped).complete);
}

TEST_CASE("pulses: a netlist that is wrong somewhere is looked at where it is right") {
    const Grafcet grafcet = grafcet_of(R"(
input a, b, c
output v, w
graph G {
  initial 0 : v if a.b + /a.c, w if b.c
}
)");
    std::string text = selection_in_gates(false);
    text.insert(text.find(".outputs X0 v") + 13, " w");
    text.insert(text.find(".end"), ".names b w\n1 1\n");
    const Netlist netlist = blif(grafcet, text);
    const CheckResult result = check_equivalence(grafcet, netlist, options_for("any"));
    CHECK(result.verdict == Verdict::different);
    const Pulses pulses = pulses_of(grafcet, netlist, options_for("any"));
    CHECK(!pulses.complete);
    CHECK(pulses.cases > 0);
}

namespace {

/// How often the reference changes each X and output in each instant but the first, from scan to
/// scan; as far as it is stable.
std::vector<std::vector<unsigned>> changes_of_reference(const Grafcet& grafcet,
                                                        const Stimuli& stimuli) {
    const Evolution evolution(grafcet);
    StimuliPlayer player(stimuli, grafcet.all_input_count());
    player.advance(0);
    InputValues values = player.inputs();
    EvolutionState state = evolution.start({values});
    if (!evolution.settle(state, {values}, 0).stable) return {};
    const std::size_t steps = grafcet.steps.size();
    const auto shown = [&](std::size_t i) {
        return i < steps ? state.situation.test(i)
                         : evolution.outputs(state, {values}).test(i - steps);
    };
    std::vector<std::vector<unsigned>> all;
    for (Time at = 10 * millisecond; at <= stimuli.end; at += 10 * millisecond) {
        const std::size_t count = steps + grafcet.outputs.size();
        std::vector<bool> last(count);
        for (std::size_t i = 0; i < count; ++i) last[i] = shown(i);
        player.advance(at);
        values = player.inputs();
        std::vector<unsigned> changes(count);
        EvolutionState before;
        for (int scan = 0; scan == 0 || !Evolution::is_settled(before, state); ++scan) {
            if (scan == 50) return all;
            before = state;
            evolution.scan(state, {values}, at);
            for (std::size_t i = 0; i < count; ++i) {
                if (shown(i) == last[i]) continue;
                last[i] = !last[i];
                ++changes[i];
            }
        }
        all.push_back(std::move(changes));
    }
    return all;
}

}  // namespace

TEST_CASE("pulses: no simulation of a random chart shows one that was not told") {
    Features features = Features::small();
    features.time_conditions = 0;
    features.counters = 0;
    features.stored = false;
    features.assumptions = false;
    std::mt19937 random(3);
    int found = 0;
    int compared = 0;
    int seen = 0;
    const std::size_t open_seeds = case_count(30);
    for (std::uint32_t seed = 1; seed <= std::max<std::size_t>(30, open_seeds); ++seed) {
        RandomSource source(seed);
        const std::string text = random_grafcet(source, features);
        CAPTURE(text);
        const auto grafcet = read_grafcet(text);
        REQUIRE(grafcet);
        const Netlist netlist = netlist_of(*grafcet, seed % 2 == 0 ? Style::nand : Style::gates);
        const PortMap ports = map_ports(*grafcet, netlist);
        std::vector<NetId> nets = ports.steps;
        nets.insert(nets.end(), ports.outputs.begin(), ports.outputs.end());
        for (const std::string delays : {"unit", "1..1.2", "any"}) {
            CAPTURE(delays);
            // Where delays are open, a single case can take a million orders of gates.
            const bool is_small = grafcet->steps.size() <= 4 && seed % 3 == 0;
            if (delays != "unit" && (!is_small || seed > open_seeds)) continue;
            const std::uint64_t most_cases = delays == "unit" ? 400 : 100;
            const Pulses pulses = pulses_of(*grafcet, netlist, options_for(delays, most_cases));
            found += static_cast<int>(pulses.found.size());
            if (!pulses.complete) continue;
            ++compared;
            const auto is_told = [&](NetId net) {
                const bool is_found =
                    std::any_of(pulses.found.begin(), pulses.found.end(),
                                [&](const Pulse& pulse) { return pulse.net == net; });
                return is_found || !pulses.open.empty();
            };
            for (int number = 0; number < 10; ++number) {
                const Stimuli stimuli = single_changes(random, *grafcet);
                const auto expected = changes_of_reference(*grafcet, stimuli);
                CellDelays circuit = cell_delays(netlist, *delay_model_of(delays));
                const bool is_unit = delays == "unit";
                const Time most = delays == "any" ? 20 : 1;
                for (auto* edge : {&circuit.rise, &circuit.fall}) {
                    for (Time& delay : *edge) {
                        if (is_unit) continue;
                        delay = 1000 * (1 + static_cast<Time>(random()) % most) +
                                static_cast<Time>(random() % 200);
                    }
                }
                const ChangesInRun run = changes_in_run(*grafcet, netlist, circuit, stimuli);
                for (std::size_t i = 1; i < run.counts.size() && i <= expected.size(); ++i) {
                    for (std::size_t net = 0; net < nets.size(); ++net) {
                        if (run.counts[i][index_of(nets[net])] <= expected[i - 1][net]) continue;
                        ++seen;
                        CHECK(is_told(nets[net]));
                    }
                }
            }
        }
    }
    CHECK(found > 0);
    CHECK(compared > 0);
    CHECK(seen > 0);
}

}  // namespace grafwire::testing
