// A referee for the check of programs that are executed scan by scan, ladder diagrams and lists for
// the S7-200: as test_netlists.cpp, with interpreters of their own.

#include <doctest/doctest.h>
#include <fmt/core.h>

#include <memory>

#include "check/scan_check.h"
#include "ladder/ladder_from.h"
#include "laddercheck/ladder_device.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "referee/charts.h"
#include "referee/ladder_interpreter.h"
#include "referee/listing_interpreter.h"
#include "referee/mutate_program.h"
#include "s7/check_listing.h"
#include "s7/generate/listing_from.h"
#include "s7/machine/binding.h"
#include "s7check/listing_device.h"

namespace grafwire::testing {

namespace {

constexpr std::size_t program_walks = 6;
constexpr std::size_t scans_of_walk = 60;
constexpr std::uint64_t most_cases = 1500;

struct ProgramCounts {
    std::size_t equivalent = 0;
    std::size_t different = 0;
    std::size_t undecided = 0;
    std::size_t runs = 0;
    std::size_t scans = 0;
    std::size_t contradicted = 0;
    std::size_t replayed = 0;
    std::size_t not_replayed = 0;

    void print(const char* what) const {
        fmt::print(
            "{}: {} equivalent, {} different, {} undecided; {} runs, {} scans, {} "
            "contradictions; {} witnesses replayed, {} not\n",
            what, equivalent, different, undecided, runs, scans, contradicted, replayed,
            not_replayed);
    }
};

/// A program and what it is to be compared with, in the eyes of the check and of the referee.
struct ProgramCase {
    const std::string& chart;
    const Grafcet& grafcet;
    const ScannedDevice& device;
    ScannedProgram& program;
    std::string what;  ///< in words: which program, how it was changed
    std::uint64_t seed = 0;
};

std::string told(const ProgramCase& item, const std::string& what, const Stimuli& stimuli,
                 Time period) {
    return fmt::format("{}\n{}, seed {}, a scan every {}\n--- chart\n{}--- stimuli\n{}--- end",
                       what, item.what, item.seed, format_duration(period), item.chart,
                       write_stimuli(stimuli, item.grafcet));
}

void judge_equivalent(const ProgramCase& item, Time period, ProgramCounts& counts) {
    ++counts.equivalent;
    RandomSource random(item.seed);
    for (std::size_t i = 0; i < program_walks; ++i) {
        const ScanWalk walk = random_scans(item.grafcet, item.program, period,
                                           item.device.has_modes(), random, scans_of_walk);
        ++counts.runs;
        counts.scans += walk.scans;
        if (walk.contradiction.empty()) continue;
        ++counts.contradicted;
        FAIL_CHECK(
            told(item, "called equivalent, but " + walk.contradiction, walk.stimuli, period));
        return;
    }
}

void judge_different(const ProgramCase& item, const Witness& witness, ProgramCounts& counts) {
    ++counts.different;
    for (const bool is_plain : {false, true}) {
        const ScanWalk walk = replayed_scans(item.grafcet, item.program, witness.stimuli,
                                             witness.scan_period, is_plain);
        if (!walk.contradiction.empty()) continue;
        ++counts.not_replayed;
        FAIL_CHECK(told(item, "called different, but the witness shows nothing", witness.stimuli,
                        witness.scan_period));
        return;
    }
    ++counts.replayed;
}

void judge(const ProgramCase& item, ProgramCounts& counts) {
    const Time period = natural_period(item.grafcet, item.device);
    CheckOptions options;
    options.max_cases = most_cases;
    const CheckResult result = check_scans(item.grafcet, item.device, period, options);
    if (result.verdict == Verdict::undecided) ++counts.undecided;
    if (result.verdict == Verdict::equivalent) judge_equivalent(item, period, counts);
    if (result.verdict == Verdict::different) {
        REQUIRE(result.witness);
        judge_different(item, *result.witness, counts);
    }
}

void judge_ladder(const std::string& chart, const Grafcet& grafcet, const ladder::Ladder& ladder,
                  const std::string& what, std::uint64_t seed, ProgramCounts& counts) {
    const LadderDevice device(grafcet, ladder, find_names(grafcet, ladder));
    LadderInterpreter program(grafcet, ladder);
    judge({chart, grafcet, device, program, what, seed}, counts);
}

/// The ladder diagram of a chart, and some mutants of it.
void judge_ladders(const std::string& chart, std::uint64_t seed, bool modes, std::size_t mutants,
                   ProgramCounts& right, ProgramCounts& wrong) {
    const auto grafcet = read_grafcet(chart);
    REQUIRE(grafcet);
    Diagnostics diagnostics;
    const auto ladder = ladder::ladder_from(*grafcet, program_from(*grafcet, {modes}), diagnostics);
    if (diagnostics.has_errors()) return;
    judge_ladder(chart, *grafcet, ladder, "ladder diagram as made", seed, right);
    RandomSource random(seed);
    for (std::size_t i = 0; i < mutants; ++i) {
        std::string what;
        const ladder::Ladder faulty = mutated(ladder, random, what);
        judge_ladder(chart, *grafcet, faulty, "ladder diagram, " + what, seed, wrong);
    }
}

void judge_listing(const std::string& chart, const Grafcet& grafcet, const s7::Listing& listing,
                   const s7::IoAssignment& assignment, const std::string& what, std::uint64_t seed,
                   ProgramCounts& counts) {
    Diagnostics diagnostics;
    s7::check_listing(listing, s7::Cpu::cpu_214, diagnostics);
    const auto binding = s7::bind(grafcet, assignment, diagnostics);
    if (diagnostics.has_errors()) return;
    const ListingDevice device(listing, s7::Cpu::cpu_214, *binding);
    ListingInterpreter program(grafcet, listing, assignment);
    judge({chart, grafcet, device, program, what, seed}, counts);
}

void judge_listings(const std::string& chart, std::uint64_t seed, bool modes, std::size_t mutants,
                    ProgramCounts& right, ProgramCounts& wrong) {
    const auto grafcet = read_grafcet(chart);
    REQUIRE(grafcet);
    Diagnostics diagnostics;
    const auto made = s7::listing_from(*grafcet, program_from(*grafcet, {modes}), {}, diagnostics);
    if (!made) return;
    judge_listing(chart, *grafcet, made->listing, made->assignment, "listing as made", seed, right);
    RandomSource random(seed);
    for (std::size_t i = 0; i < mutants; ++i) {
        std::string what;
        const s7::Listing faulty = mutated(made->listing, random, what);
        judge_listing(chart, *grafcet, faulty, made->assignment, "listing, " + what, seed, wrong);
    }
}

using Judge = void (*)(const std::string&, std::uint64_t, bool, std::size_t, ProgramCounts&,
                       ProgramCounts&);

void judge_all(Judge judge_one, const char* name, std::uint64_t first_seed) {
    ProgramCounts right;
    ProgramCounts wrong;
    for (const auto& [example, chart] : texts_of_examples())
        judge_one(chart, 3, true, 4, right, wrong);
    const std::size_t charts = case_count(150);
    for (std::uint64_t seed = first_seed; seed < first_seed + charts; ++seed) {
        judge_one(chart_of(seed), seed, seed % 3 != 0, 4, right, wrong);
    }
    right.print(name);
    wrong.print((std::string(name) + ", mutants").c_str());
    CHECK(right.equivalent > charts / 2);
    CHECK(right.different == 0);
    CHECK(wrong.different > wrong.equivalent);
}

}  // namespace

TEST_CASE("referee: ladder diagrams") {
    judge_all(judge_ladders, "ladder diagrams", 7'000'000);
}

TEST_CASE("referee: lists for the S7-200") {
    judge_all(judge_listings, "listings", 8'000'000);
}

}  // namespace grafwire::testing
