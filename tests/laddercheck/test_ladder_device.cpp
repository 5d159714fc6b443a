// Ladder diagrams judged scan by scan: right ones, the naive set/reset form, and seeded faults.

#include <doctest/doctest.h>

#include "check/scan_check.h"
#include "evolution/run.h"
#include "ladder/ladder_from.h"
#include "laddercheck/ladder_device.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "support/chart_files.h"

namespace grafwire::testing {

namespace {

using ladder::CoilKind;
using ladder::ContactKind;
using ladder::Ladder;
using ladder::Power;

Ladder ladder_of(const Grafcet& grafcet, bool modes = true) {
    Diagnostics diagnostics;
    return ladder::ladder_from(grafcet, program_from(grafcet, {modes}), diagnostics);
}

CheckResult check(const Grafcet& grafcet, const LadderDevice& device) {
    return check_scans(grafcet, device, natural_period(grafcet, device), {});
}

std::string chart_named(const std::string& name) {
    for (const ChartFiles& chart : example_charts()) {
        if (chart.name == name) return chart.chart;
    }
    FAIL("no example " << name);
    return {};
}

/// The first contact of a rung.
Power* first_contact(Power& power) {
    if (power.kind == Power::Kind::contact) return &power;
    for (Power& part : power.parts) {
        if (Power* found = first_contact(part)) return found;
    }
    return nullptr;
}

/// Checks a faulty diagram; the witness must replay, and name the network `number`.
void must_be_found(const Grafcet& grafcet, const Ladder& faulty, std::uint32_t number) {
    CAPTURE(number);
    const LadderDevice device(grafcet, faulty, find_names(grafcet, faulty));
    const CheckResult result = check(grafcet, device);
    REQUIRE(result.verdict == Verdict::different);
    REQUIRE(result.witness);
    const Witness& witness = *result.witness;
    const auto again = replay_scans(grafcet, device, witness.stimuli, witness.scan_period);
    REQUIRE(again);
    CHECK(again->stimuli.end == witness.stimuli.end);
    const std::string explanation = device.explain(witness, Language::english);
    CHECK_MESSAGE(explanation.find("  network " + std::to_string(number)) != std::string::npos,
                  explanation);
    CHECK(device.explain(witness, Language::french).find("réseau " + std::to_string(number)) !=
          std::string::npos);
}

}  // namespace

TEST_CASE("the ladder diagrams of the examples are equivalent") {
    for (const ChartFiles& chart : example_charts()) {
        CAPTURE(chart.name);
        const auto grafcet = read_grafcet(chart.chart);
        for (const bool modes : {true, false}) {
            const Ladder ladder = ladder_of(*grafcet, modes);
            const LadderDevice device(*grafcet, ladder, find_names(*grafcet, ladder));
            CHECK(device.has_modes() == modes);
            // One has too many states for a complete exploration to be a matter of a second.
            const bool is_large = chart.name == "level-crossing";
            CheckOptions options;
            options.max_cases = is_large ? 20'000 : 0;
            const Time period = natural_period(*grafcet, device);
            const CheckResult result = check_scans(*grafcet, device, period, options);
            CHECK(result.verdict != Verdict::different);
            if (!is_large) CHECK(result.verdict == Verdict::equivalent);
        }
    }
}

TEST_CASE("the ladder diagrams of random charts are not different") {
    check_property(
        [](const RandomCase& item) -> std::string {
            const auto grafcet = read_grafcet(item.chart);
            const Ladder ladder = ladder_of(*grafcet);
            const LadderDevice device(*grafcet, ladder, find_names(*grafcet, ladder));
            CheckOptions options;
            options.max_cases = 5'000;
            const Time period = natural_period(*grafcet, device);
            const CheckResult result = check_scans(*grafcet, device, period, options);
            if (result.verdict != Verdict::different) return {};
            return device.explain(*result.witness, Language::english);
        },
        Features::small(), 960'000, 100, 1);
}

TEST_CASE("faults in the rungs of transitions and steps are found and named") {
    for (const char* name : {"single-sequence", "nine-steps", "parallel-convergence"}) {
        CAPTURE(name);
        const auto grafcet = read_grafcet(chart_named(name));
        const Ladder right = ladder_of(*grafcet);
        std::size_t faults = 0;
        for (std::size_t r = 0; r < right.rungs.size(); ++r) {
            const ladder::Rung& rung = right.rungs[r];
            const std::string& written = right.variable(rung.coils.front().variable).name;
            if (rung.coils.size() != 1 || (written[0] != 'T' && written[0] != 'X')) continue;
            if (r == 0) continue;  // the initial situation
            Ladder negated = right;
            Power* contact = first_contact(negated.rungs[r].power);
            REQUIRE(contact != nullptr);
            contact->contact = contact->contact == ContactKind::normal ? ContactKind::negated
                                                                       : ContactKind::normal;
            must_be_found(*grafcet, negated, rung.number);
            ++faults;
            if (rung.coils.front().kind == CoilKind::normal) continue;
            Ladder swapped = right;
            CoilKind& kind = swapped.rungs[r].coils.front().kind;
            kind = kind == CoilKind::set ? CoilKind::reset : CoilKind::set;
            must_be_found(*grafcet, swapped, rung.number);
            ++faults;
        }
        CHECK(faults > 10);
    }
}

TEST_CASE("a rung that is missing is found, and what is not written is named") {
    const auto grafcet = read_grafcet(chart_named("single-sequence"));
    const Ladder right = ladder_of(*grafcet);
    std::size_t dropped = 0;
    for (std::size_t r = 1; r < right.rungs.size(); ++r) {
        const ladder::Coil coil = right.rungs[r].coils.front();
        if (coil.kind != CoilKind::set || right.variable(coil.variable).name[0] != 'X') continue;
        Ladder faulty = right;
        faulty.rungs.erase(faulty.rungs.begin() + static_cast<std::ptrdiff_t>(r));
        const LadderDevice device(*grafcet, faulty, find_names(*grafcet, faulty));
        const CheckResult result = check(*grafcet, device);
        REQUIRE(result.verdict == Verdict::different);
        const std::string explanation = device.explain(*result.witness, Language::english);
        CHECK_MESSAGE(explanation.find(right.variable(coil.variable).name) != std::string::npos,
                      explanation);
        ++dropped;
    }
    CHECK(dropped == 3);
}

TEST_CASE("a fault in a rung that counts is named behind the output that compares the count") {
    const auto grafcet = read_grafcet(R"(
        input a
        output lamp
        counter n : 0..3
        graph G {
          initial 0 : lamp if [n > 0]
          step 1 : n := n + 1
          0 -> 1 : a
          1 -> 0 : /a
        })");
    const Ladder right = ladder_of(*grafcet);
    std::size_t faults = 0;
    for (std::size_t r = 0; r < right.rungs.size(); ++r) {
        const ladder::Rung& rung = right.rungs[r];
        const bool counts = std::any_of(
            rung.blocks.begin(), rung.blocks.end(),
            [&](const ladder::Block& block) { return right.variable(block.target).name == "n"; });
        Ladder faulty = right;
        Power* contact = first_contact(faulty.rungs[r].power);
        if (!counts || contact == nullptr) continue;
        contact->contact =
            contact->contact == ContactKind::normal ? ContactKind::negated : ContactKind::normal;
        must_be_found(*grafcet, faulty, rung.number);
        ++faults;
    }
    CHECK(faults != 0);
}

TEST_CASE("networks of a file are named with their lines, in both languages") {
    const auto grafcet = read_grafcet(chart_named("single-sequence"));
    Ladder faulty = ladder_of(*grafcet);
    for (std::size_t r = 0; r < faulty.rungs.size(); ++r) {
        faulty.rungs[r].origin = {static_cast<std::uint32_t>(100 + r), 1};
        if (r != 0 && faulty.rungs[r].coils.front().kind == CoilKind::set) {
            faulty.rungs[r].coils.front().kind = CoilKind::reset;
        }
    }
    const LadderDevice device(*grafcet, faulty, find_names(*grafcet, faulty));
    const CheckResult result = check(*grafcet, device);
    REQUIRE(result.witness);
    const std::string english = device.explain(*result.witness, Language::english);
    CHECK_MESSAGE(english.find(", line 1") != std::string::npos, english);
    CHECK(english.find(", ligne 1") == std::string::npos);
    const std::string french = device.explain(*result.witness, Language::french);
    CHECK_MESSAGE(french.find(", ligne 1") != std::string::npos, french);
    CHECK(french.find(", line 1") == std::string::npos);
}

// The form of the course without bits for the transitions: each step is set by CAX and reset by CDX
// in the order of the steps. A scan then sees steps that an earlier rung of it has changed.
TEST_CASE("set and reset by CAX and CDX alone let a token run through the chart in one scan") {
    const auto grafcet = read_grafcet(R"(
        input m, a
        graph G {
          initial 0
          step 1
          step 2
          0 -> 1 : m
          1 -> 2 : a
          2 -> 0 : /m
        })");
    Ladder ladder;
    const auto bit = [&](const char* name, ladder::Role role) {
        ladder::Variable variable;
        variable.name = name;
        variable.role = role;
        variable.initial = variable.name == "X0" ? 1 : 0;
        return ladder.add(variable);
    };
    const auto m = bit("m", ladder::Role::input);
    const auto a = bit("a", ladder::Role::input);
    const auto x0 = bit("X0", ladder::Role::memory);
    const auto x1 = bit("X1", ladder::Role::memory);
    const auto x2 = bit("X2", ladder::Role::memory);
    const auto rung = [&](Power power, CoilKind kind, ladder::VariableId variable) {
        ladder::Rung made;
        made.number = static_cast<std::uint32_t>(ladder.rungs.size() + 1);
        made.power = std::move(power);
        made.coils.push_back({kind, variable});
        ladder.rungs.push_back(std::move(made));
    };
    const auto both = [&](Power first, Power second) {
        std::vector<Power> parts;
        parts.push_back(std::move(first));
        parts.push_back(std::move(second));
        return series(std::move(parts));
    };
    using ladder::contact;
    rung(contact(x1), CoilKind::reset, x0);
    rung(both(contact(x2), contact(m, ContactKind::negated)), CoilKind::set, x0);
    rung(contact(x2), CoilKind::reset, x1);
    rung(both(contact(x0), contact(m)), CoilKind::set, x1);
    rung(contact(x0), CoilKind::reset, x2);
    rung(both(contact(x1), contact(a)), CoilKind::set, x2);
    const LadderDevice device(*grafcet, ladder, find_names(*grafcet, ladder));
    CHECK_FALSE(device.has_modes());
    const CheckResult result = check(*grafcet, device);
    REQUIRE(result.verdict == Verdict::different);
    // One scan with m = 1 is enough: step 0 is still active after it, for it is reset by X1 only in
    // the next.
    CHECK(write_stimuli(result.witness->stimuli, *grafcet) == "0s : m=1\n0s : end\n");
    const std::string explanation = device.explain(*result.witness, Language::english);
    CHECK_MESSAGE(explanation.find("no network has written X0 in this scan") != std::string::npos,
                  explanation);
}

TEST_CASE("names are found as identifiers, and what is missing is listed") {
    const auto grafcet = read_grafcet(R"(
        input "a b", c
        output "V+"
        graph G { initial 0 : "V+" 0 -> 0 : "a b" . c })");
    Ladder ladder;
    const auto add = [&](const char* name) {
        ladder::Variable variable;
        variable.name = name;
        return ladder.add(variable);
    };
    const auto a_b = add("A_B");
    const auto v_plus = add("V_plus");
    const LadderNames names = find_names(*grafcet, ladder);
    CHECK(names.inputs[0] == a_b);
    CHECK_FALSE(names.inputs[1]);
    CHECK(names.outputs == std::vector{v_plus});
    CHECK(names.missing_inputs == std::vector<std::string>{"c"});
    CHECK(names.missing == std::vector<std::string>{"X0"});
}

}  // namespace grafwire::testing
