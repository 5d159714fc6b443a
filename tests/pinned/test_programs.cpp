// Verdicts on ladder diagrams and S7-200 listings, with their counts and explanations: as made, and
// with one slip of the hand.

#include <fmt/core.h>

#include "ladder/ladder_from.h"
#include "pinned/pinned_charts.h"
#include "pinned/pinned_table.h"
#include "program/program.h"
#include "random/random_source.h"
#include "referee/charts.h"
#include "referee/mutate_program.h"
#include "s7/check_listing.h"
#include "s7/generate/listing_from.h"
#include "s7/machine/binding.h"
#include "workflow/check.h"

namespace grafwire::testing {

namespace {

constexpr std::uint64_t first_program_seed = 42'000'000;
constexpr std::uint64_t program_charts = 120;
constexpr std::uint64_t most_program_cases = 300;
constexpr std::size_t slips = 6;

CheckRequest request_of() {
    CheckRequest request;
    request.subject.file = "chart.grafcet";
    request.subject.against = "program";
    request.subject.is_program = true;
    request.max_cases = most_program_cases;
    request.with_files = true;
    return request;
}

/// Adds what a check came to.
void pin(PinnedCase& pinned, const std::string& what, const std::optional<Judgement>& judgement,
         const Diagnostics& messages) {
    if (!judgement) {
        REQUIRE(!messages.items().empty());
        pinned.add("refused", what + "\n" + messages.items().front().message.english + "\n");
        return;
    }
    const CheckResult& result = judgement->result;
    std::string text = what + "\n" + judgement->explained.text;
    for (const std::string& line : judgement->explained.lines) text += line + "\n";
    for (const NamedText& file : judgement->witness_files) text += file.name + "\n" + file.text;
    pinned.add(fmt::format("{} {}", name_of(result.verdict), result.coverage.cases), text);
}

void pin_ladder(PinnedCase& pinned, const std::string& what, const Chart& chart,
                const ladder::Ladder& ladder) {
    Diagnostics messages;
    const auto judgement = check_ladder(chart, ladder, request_of(), messages);
    pin(pinned, what, judgement, messages);
}

void pin_listing(PinnedCase& pinned, const std::string& what, const Chart& chart,
                 const s7::Listing& listing, const s7::IoAssignment& assignment) {
    Diagnostics messages;
    s7::check_listing(listing, s7::Cpu::cpu_214, messages);
    const auto binding = s7::bind(chart.grafcet, assignment, messages);
    std::optional<Judgement> judgement;
    if (!messages.has_errors()) {
        judgement =
            check_listing(chart, listing, s7::Cpu::cpu_214, *binding, request_of(), messages);
    }
    pin(pinned, what, judgement, messages);
}

void pin_ladders(PinnedTable& table, std::uint64_t seed) {
    const Chart chart = pinned_chart(chart_of(first_program_seed + seed));
    Diagnostics diagnostics;
    const ScanProgram program = program_from(chart.grafcet, {seed % 3 == 0});
    const auto ladder = ladder::ladder_from(chart.grafcet, program, diagnostics);
    if (diagnostics.has_errors()) return;
    PinnedCase pinned;
    pin_ladder(pinned, "as made", chart, ladder);
    RandomSource random(seed);
    for (std::size_t i = 0; i < slips; ++i) {
        std::string told;
        const ladder::Ladder faulty = mutated(ladder, random, told);
        pin_ladder(pinned, told, chart, faulty);
    }
    table.add(fmt::format("{:03}", seed), pinned);
}

void pin_listings(PinnedTable& table, std::uint64_t seed) {
    const Chart chart = pinned_chart(chart_of(first_program_seed + seed));
    Diagnostics diagnostics;
    const ScanProgram program = program_from(chart.grafcet, {seed % 3 == 0});
    const auto made = s7::listing_from(chart.grafcet, program, {}, diagnostics);
    if (!made) return;
    PinnedCase pinned;
    pin_listing(pinned, "as made", chart, made->listing, made->assignment);
    RandomSource random(seed);
    for (std::size_t i = 0; i < slips; ++i) {
        std::string told;
        const s7::Listing faulty = mutated(made->listing, random, told);
        pin_listing(pinned, told, chart, faulty, made->assignment);
    }
    table.add(fmt::format("{:03}", seed), pinned);
}

}  // namespace

TEST_CASE("pinned: checks of ladder diagrams") {
    PinnedTable table("ladders.txt");
    for (std::uint64_t seed = 0; seed < program_charts; seed += pinned_stride) {
        pin_ladders(table, seed);
    }
    table.finish(!is_slow_build);
}

TEST_CASE("pinned: checks of S7-200 listings") {
    PinnedTable table("listings.txt");
    for (std::uint64_t seed = 0; seed < program_charts; seed += pinned_stride) {
        pin_listings(table, seed);
    }
    table.finish(!is_slow_build);
}

}  // namespace grafwire::testing
