// The exploration, driven with a device of its own making: one that can do two things in a case.

#include <doctest/doctest.h>

#include <memory>
#include <set>

#include "check/exploration.h"
#include "evolution/run.h"
#include "grafcet/parse_grafcet.h"
#include "support/backward_workers.h"

namespace grafwire::testing {

namespace {

constexpr const char* coin = R"(
input a
output lamp
graph G { initial 0 step 1 : lamp
  0 -> 1 : a
  1 -> 0 : /a }
)";

/// Follows the GRAFCET, and flips a coin whenever `a` rises. The next rise after the side of the
/// coin that is named `fault` goes unnoticed.
class CoinDevice : public ExploredNetlist {
  public:
    static constexpr int never_flipped = 2;
    static constexpr int no_fault = 3;

    /// `sides` gets the sides of the coin that cases have started from.
    CoinDevice(const Grafcet& grafcet, int fault, std::set<int>& sides)
        : grafcet_(grafcet), fault_(fault), sides_(sides) {}

    bool is_worth_sharing() const override { return true; }
    bool is_clocked() const override { return false; }
    bool has_modes() const override { return false; }
    std::vector<std::uint32_t> conditions_of_timers() const override { return {}; }
    std::vector<std::uint8_t> relevant_timers() const override { return {}; }
    std::vector<Time> delays() const override { return {}; }

    NetlistOutcomes run(const SimulatorState* start, const PartialInputs&, const PathStep& step,
                        const ReferenceOutcome& expected) override {
        NetlistOutcomes outcomes;
        if (step.inputs[0] == PartialInput::unassigned) {
            NetlistOutcome& outcome = outcomes.emplace_back();
            outcome.kind = NetlistOutcome::Kind::unassigned;
            outcome.unknown = UnknownCause{UnknownCause::Kind::unassigned_input, 0};
            return outcomes;
        }
        const State state = start == nullptr ? State() : unpacked(*start);
        sides_.insert(state.side);
        for (const State& next : successors(state, step.inputs[0] == PartialInput::one)) {
            NetlistOutcome& outcome = outcomes.emplace_back();
            const bool agrees = expected.state.situation.test(1) == next.is_on &&
                                expected.outputs.test(0) == next.is_on;
            outcome.kind = agrees ? NetlistOutcome::Kind::agrees : NetlistOutcome::Kind::differs;
            outcome.state = packed(next);
        }
        return outcomes;
    }

    std::optional<SimulatorState> abstracted(const SimulatorState&,
                                             const std::vector<std::uint32_t>&) override {
        return std::nullopt;
    }

    void encode(std::string& encoding, const SimulatorState& state) const override {
        for (const Logic value : state.values) encoding += static_cast<char>(value);
    }

    /// The first difference under any sequence of coins.
    std::optional<Witness> replay(const Stimuli& stimuli, Time) const override {
        return replay_from(State(), stimuli, 0, empty_trace(grafcet_));
    }

  private:
    struct State {
        bool was_high = false;
        bool is_on = false;
        int side = never_flipped;
    };

    std::vector<State> successors(const State& state, bool is_high) const {
        const bool rises = is_high && !state.was_high;
        if (!rises) return {{is_high, is_high && state.is_on, state.side}};
        const bool is_on = state.side != fault_;
        return {{is_high, is_on, 0}, {is_high, is_on, 1}};
    }

    static SimulatorState packed(const State& state) {
        SimulatorState result;
        result.values = {logic_of(state.was_high), logic_of(state.is_on),
                         logic_of((state.side & 1) != 0), logic_of((state.side & 2) != 0)};
        return result;
    }
    static State unpacked(const SimulatorState& state) {
        const auto bit = [&](std::size_t i) { return state.values[i] == Logic::one; };
        return {bit(0), bit(1), (bit(2) ? 1 : 0) + (bit(3) ? 2 : 0)};
    }

    std::optional<Witness> replay_from(const State& state, const Stimuli& stimuli,
                                       std::size_t change, const Trace& trace) const {
        if (change == stimuli.changes.size()) {
            return first_difference(grafcet_, stimuli, run_until_stable(grafcet_, stimuli), trace);
        }
        bool is_high = state.was_high;
        for (const auto& set : stimuli.changes[change].assignments) {
            if (set.input == 0) is_high = set.value;
        }
        for (const State& next : successors(state, is_high)) {
            Trace longer = trace;
            longer.times.push_back(stimuli.changes[change].at);
            for (const bool value :
                 {is_high, false, false, false, !next.is_on, next.is_on, next.is_on}) {
                longer.values.push_back(value ? 1 : 0);
            }
            if (auto witness = replay_from(next, stimuli, change + 1, longer)) return witness;
        }
        return std::nullopt;
    }

    const Grafcet& grafcet_;
    int fault_;
    std::set<int>& sides_;
};

/// What comes of exploring the device with a fault, and the sides of the coin that it has seen.
struct Explored {
    CheckResult result;
    std::set<int> sides;
};

Explored explored(const Grafcet& grafcet, int fault, Workers* workers = nullptr) {
    Explored all;
    CheckOptions options;
    options.workers = workers;
    const auto make_device = [&](const KeepGoing&) -> std::unique_ptr<ExploredNetlist> {
        return std::make_unique<CoinDevice>(grafcet, fault, all.sides);
    };
    all.result = explore(grafcet, make_device, options, {Changes::one, Passing::free, 0}).result;
    return all;
}

Grafcet parsed_chart() {
    Diagnostics diagnostics;
    auto grafcet = parse_grafcet({"coin", coin}, diagnostics);
    REQUIRE(grafcet);
    return *grafcet;
}

}  // namespace

TEST_CASE("every outcome of a case is followed") {
    const Grafcet grafcet = parsed_chart();
    const auto [result, sides] = explored(grafcet, CoinDevice::no_fault);
    CHECK(result.verdict == Verdict::equivalent);
    CHECK(result.complete);
    CHECK(sides == std::set<int>{0, 1, CoinDevice::never_flipped});
    CHECK(result.coverage.situations == 2);
}

TEST_CASE("a difference behind either outcome is found, and its witness replays") {
    const Grafcet grafcet = parsed_chart();
    for (const int fault : {0, 1}) {
        CAPTURE(fault);
        const CheckResult result = explored(grafcet, fault).result;
        CHECK(result.verdict == Verdict::different);
        REQUIRE(result.witness);
        CHECK(result.witness->kind == DifferenceKind::situation);
        // High from the start, low, and high again: the shortest with two rises.
        CHECK(write_stimuli(result.witness->stimuli, grafcet) ==
              "0s : a=1\n100ms : a=0\n200ms : a=1\n200ms : end\n");
        std::set<int> sides;
        const auto again = CoinDevice(grafcet, fault, sides).replay(result.witness->stimuli, 0);
        REQUIRE(again);
        CHECK(again->kind == result.witness->kind);
        CHECK(again->stimuli.end == result.witness->stimuli.end);
    }
    // What goes wrong at once, whatever the coin will say.
    const CheckResult result = explored(grafcet, CoinDevice::never_flipped).result;
    REQUIRE(result.witness);
    CHECK(write_stimuli(result.witness->stimuli, grafcet) == "0s : a=1\n0s : end\n");
}

TEST_CASE("it comes to the same whoever shares the work, and in whatever order") {
    const Grafcet grafcet = parsed_chart();
    for (const int fault : {0, 1, CoinDevice::never_flipped, CoinDevice::no_fault}) {
        CAPTURE(fault);
        const CheckResult alone = explored(grafcet, fault).result;
        BackwardWorkers backward;
        const CheckResult shared = explored(grafcet, fault, &backward).result;
        CHECK(shared.verdict == alone.verdict);
        CHECK(shared.coverage.cases == alone.coverage.cases);
        CHECK(shared.coverage.situations == alone.coverage.situations);
        CHECK(shared.coverage.waiting == alone.coverage.waiting);
        CHECK(shared.witness.has_value() == alone.witness.has_value());
        if (!shared.witness || !alone.witness) continue;
        CHECK(write_stimuli(shared.witness->stimuli, grafcet) ==
              write_stimuli(alone.witness->stimuli, grafcet));
    }
}

}  // namespace grafwire::testing
