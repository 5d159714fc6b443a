// Verdicts on netlists, with their counts, reports and witnesses: as made in every style, with one
// wrong gate, and with something foreign grafted on; one input at a time, or many.

#include <fmt/core.h>

#include "netlist/styles/styles.h"
#include "pinned/pinned_charts.h"
#include "pinned/pinned_table.h"
#include "random/random_source.h"
#include "referee/charts.h"
#include "referee/graft.h"
#include "support/mutate.h"
#include "support/styles.h"
#include "workflow/check.h"
#include "workflow/netlists.h"

namespace grafwire::testing {

namespace {

constexpr std::uint64_t first_check_seed = 41'000'000;
constexpr std::uint64_t check_charts = 210;
constexpr std::uint64_t most_cases = 900;
constexpr std::size_t mutants_of_check = 5;

std::string text_of(const Judgement& judgement, const Chart& chart) {
    std::string text;
    for (const ReportRow& form : report_forms()) {
        if (form.name == "text") text = form.write(judgement, chart, 0, Language::english);
    }
    REQUIRE(!text.empty());
    for (const std::string& line : judgement.explained.lines) text += line + "\n";
    for (const NamedText& file : judgement.witness_files) text += file.name + "\n" + file.text;
    return text;
}

CheckRequest request_of(std::string_view style, std::uint64_t seed) {
    CheckRequest request;
    request.subject.file = "chart.grafcet";
    request.subject.style = style;
    request.subject.cdx = "as the style has it";
    request.changes = seed % 2 == 0 ? Changes::one : Changes::many;
    request.max_cases = most_cases;
    request.with_files = true;
    if (seed % 5 == 1) request.period = 10 * millisecond;
    return request;
}

/// Adds what a check came to.
void pin(PinnedCase& pinned, const std::string& what, const Chart& chart, const Netlist& netlist,
         CheckRequest request) {
    if (!netlist.is_clocked()) request.period.reset();
    Diagnostics messages;
    const auto judgement = check_netlist(chart, netlist, request, messages);
    if (!judgement) {
        REQUIRE(!messages.items().empty());
        pinned.add("refused", what + "\n" + messages.items().front().message.english + "\n");
        return;
    }
    const CheckResult& result = judgement->result;
    pinned.add(fmt::format("{} {}", name_of(result.verdict), result.coverage.cases),
               what + "\n" + text_of(*judgement, chart));
}

/// Most asynchronous netlists of random charts are wrong at the first case, but those of plain
/// charts are right: of three charts two are plain ones, whose seeds are 2 more than a multiple
/// of 4.
std::uint64_t check_seed(std::uint64_t seed) {
    return seed % 3 == 0 ? first_check_seed + seed : first_check_seed + 4 * seed + 2;
}

PinnedCase pinned_checks(const Chart& chart, const StyleRow& row, std::uint64_t seed) {
    PinnedCase pinned;
    NetlistOptions options;
    options.style = row.style;
    options.modes = seed % 3 == 0;
    Diagnostics diagnostics;
    const auto netlist = make_netlist(chart, options, diagnostics);
    if (!netlist) {
        pinned.add("refused", diagnostics.items().front().message.english);
        return pinned;
    }
    const CheckRequest request = request_of(row.name, seed);
    pin(pinned, "as made", chart, *netlist, request);
    RandomSource random(seed);
    const auto mutations = mutations_of(*netlist);
    for (std::size_t i = 0; i < mutants_of_check; ++i) {
        const Mutation& mutation = random.pick(mutations);
        pin(pinned, describe(*netlist, mutation), chart, mutated(*netlist, mutation), request);
    }
    std::string told;
    const Netlist foreign = grafted(*netlist, random, told);
    pin(pinned, told, chart, foreign, request);
    return pinned;
}

void pin_checks(PinnedTable& table, std::uint64_t seed) {
    const Chart chart = pinned_chart(chart_of(check_seed(seed)));
    for (const StyleRow& row : style_table) {
        table.add(fmt::format("{:03} {}", seed, row.name), pinned_checks(chart, row, seed));
    }
}

}  // namespace

TEST_CASE("pinned: checks of netlists") {
    PinnedTable table("checks.txt");
    for (std::uint64_t seed = 0; seed < check_charts; seed += pinned_stride)
        pin_checks(table, seed);
    table.finish(!is_slow_build);
}

}  // namespace grafwire::testing
