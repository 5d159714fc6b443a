#include "check/scan_check.h"
#include "support/naive_device.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

using Outcome = ScannedDevice::Outcome;

const std::string warning = R"(
input a, b
output lamp, horn
graph G { initial 0 step 1 : lamp if 30ms/X1, horn if 50ms/X1
  0 -> 1 : a
  1 -> 0 : /a }
)";

CheckResult check_device(const Grafcet& grafcet, const ScannedDevice& device) {
    return check_scans(grafcet, device, natural_period(grafcet, device), {});
}

Logic inverted(Logic value) {
    return value == Logic::one ? Logic::zero : Logic::one;
}

}  // namespace

TEST_CASE("the period divides all delays, and leaves room between two") {
    const auto period = [](const std::string& text) {
        const Grafcet grafcet = grafcet_of(text);
        return natural_period(grafcet, NaiveDevice(grafcet));
    };
    CHECK(period("input a graph G { initial 0 }") == 10 * millisecond);
    CHECK(period("output o graph G { initial 0 : o if 400ms/X0 }") == 400 * millisecond);
    CHECK(period(warning) == 5 * millisecond);
    CHECK(period("input a output o graph G { initial 0 : o if 400ms/a/1s }") == 200 * millisecond);

    struct Slow : NaiveDevice {
        using NaiveDevice::NaiveDevice;
        std::vector<Time> delays() const override { return {150 * millisecond}; }
    };
    const Grafcet grafcet = grafcet_of("output o graph G { initial 0 : o if 400ms/X0 }");
    CHECK(natural_period(grafcet, Slow(grafcet)) == 50 * millisecond);
}

TEST_CASE("a program that does what the reference does is equivalent") {
    const Grafcet grafcet = grafcet_of(warning);
    const CheckResult result = check_device(grafcet, NaiveDevice(grafcet));
    CHECK(result.verdict == Verdict::equivalent);
    CHECK(result.complete);
    CHECK_FALSE(result.witness);
    CHECK(result.coverage.situations == 3);  // 0, 1, and none while AUdur is 1
    CHECK(result.coverage.unstable == 0);
    CHECK(result.coverage.waiting == 0);

    const CheckResult plain = check_device(grafcet, NaiveDevice(grafcet, {}, false));
    CHECK(plain.verdict == Verdict::equivalent);
    CHECK(plain.coverage.situations == 2);
    CHECK(plain.coverage.cases < result.coverage.cases);

    // Not a scan more: what remains of a delay is part of a state, how long ago it ended is not.
    CHECK(result.coverage.cases == 138);
    CHECK(plain.coverage.cases == 28);
}

TEST_CASE("a delay that is a scan too long shows itself in the scan in which it should end") {
    const Grafcet grafcet = grafcet_of(warning);
    // The lamp is held back until the horn sounds.
    const NaiveDevice device(grafcet, [](const NaiveState&, const InputValues&, Outcome& shown,
                                         std::string&) { shown.outputs[0] = shown.outputs[1]; });
    const CheckResult result = check_device(grafcet, device);
    CHECK(result.verdict == Verdict::different);
    REQUIRE(result.witness);
    const Witness& witness = *result.witness;
    CHECK(witness.kind == DifferenceKind::output);
    CHECK(witness.scan_period == 5 * millisecond);
    CHECK(write_stimuli(witness.stimuli, grafcet) == "0s : a=1\n30ms : end\n");
    CHECK(witness.values[2].name == "lamp");
    CHECK(witness.values[2].expected == Logic::one);
    CHECK(witness.values[2].got == Logic::zero);

    CHECK(replay_scans(grafcet, device, witness.stimuli, witness.scan_period));
    CHECK_FALSE(replay_scans(grafcet, NaiveDevice(grafcet), witness.stimuli, witness.scan_period));
}

TEST_CASE("a program that reads an input where the GRAFCET does not is found out") {
    const Grafcet grafcet = grafcet_of(warning);
    SUBCASE("at once") {
        const NaiveDevice device(grafcet, [](const NaiveState& state, const InputValues& inputs,
                                             Outcome& shown, std::string&) {
            if (state.ts[1] && inputs[1] != 0) shown.steps[1] = Logic::zero;
        });
        const CheckResult result = check_device(grafcet, device);
        CHECK(result.verdict == Verdict::different);
        CHECK(result.witness->kind == DifferenceKind::situation);
        CHECK(write_stimuli(result.witness->stimuli, grafcet) == "0s : a=1 b=1\n0s : end\n");
    }
    SUBCASE("after it has remembered it") {
        // The horn fails once b has been 1 for three scans.
        const NaiveDevice device(grafcet, [](const NaiveState&, const InputValues& inputs,
                                             Outcome& shown, std::string& extra) {
            if (extra.size() >= 3) shown.outputs[1] = inverted(shown.outputs[1]);
            if (extra.size() < 3) extra = inputs[1] != 0 ? extra + "b" : "";
        });
        const CheckResult result = check_device(grafcet, device);
        CHECK(result.verdict == Verdict::different);
        CHECK(write_stimuli(result.witness->stimuli, grafcet) == "0s : b=1\n15ms : end\n");
    }
    SUBCASE("but not where the plant rules that out") {
        const Grafcet bound = grafcet_of("assume /(a . b)" + warning);
        const NaiveDevice device(bound, [](const NaiveState& state, const InputValues& inputs,
                                           Outcome& shown, std::string&) {
            if (state.ts[1] && inputs[0] != 0 && inputs[1] != 0) shown.steps[1] = Logic::zero;
        });
        CHECK(check_device(bound, device).verdict == Verdict::equivalent);
    }
}

TEST_CASE("a bound on the cases leaves a check of scans undecided") {
    const Grafcet grafcet = grafcet_of(warning);
    CheckOptions options;
    options.max_cases = 10;
    const CheckResult result = check_scans(grafcet, NaiveDevice(grafcet), 5 * millisecond, options);
    CHECK(result.verdict == Verdict::undecided);
    CHECK_FALSE(result.complete);
    CHECK(result.coverage.cases == 10);
    CHECK(result.coverage.waiting > 0);
}

TEST_CASE("a device over stimuli gives a row per scan, vars and counters unknown") {
    const Grafcet grafcet = grafcet_of(R"(
input a output lamp var v
graph G { initial 0 step 1 : lamp, set v
  0 -> 1 : a })");
    const auto stimuli = read_stimuli("0s :\n15ms : a=1\n20ms : end\n", grafcet);
    REQUIRE(stimuli);
    CHECK(write_csv(run_device(grafcet, NaiveDevice(grafcet), *stimuli, 10 * millisecond)) ==
          "time_ms,a,Init,AUdur,AUdoux,X0,X1,lamp,v\n"
          "0,0,0,0,0,1,0,0,x\n"
          "10,0,0,0,0,1,0,0,x\n"
          "20,1,0,0,0,0,1,1,x\n");
}

}  // namespace grafwire::testing
