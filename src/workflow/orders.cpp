// Wiring in the style handshake is right under any delay where the chart does not depend on the
// order in which its transitions clear. Here that is asked of the chart before its wiring is made,
// and told: as warnings, and as a remark beside a verdict.

#include "workflow/orders.h"

#include <algorithm>

#include "grafcet/add_conditions.h"
#include "grafcet/write_grafcet.h"
#include "orders/messages.h"
#include "orders/tell_orders.h"
#include "text/counted.h"
#include "text/indented.h"
#include "workflow/messages.h"

namespace grafwire {

namespace {

namespace say = messages::workflow;

/// A case takes as long as its states are large. Most examples are looked at whole within this.
constexpr std::uint64_t most_work = 4'000'000;
constexpr std::uint64_t fewest_cases = 20;
constexpr std::uint64_t most_cases = 60'000;
constexpr std::uint64_t searches_for_interlocks = 6;

std::uint64_t bound_for(const Grafcet& grafcet) {
    const std::uint64_t size = 1 + grafcet.steps.size() + grafcet.transitions.size();
    return std::clamp(most_work / size, fewest_cases, most_cases);
}

std::string_view name_of(RaceKind kind) {
    switch (kind) {
        case RaceKind::withdrawn:
            return "withdrawn";
        case RaceKind::arrival:
            return "arrival";
        case RaceKind::difference:
            return "difference";
        case RaceKind::unrest:
            break;
    }
    return "unrest";
}

/// Lines, each two places to the right, without the last line end.
std::string moved_in(const std::string& lines) {
    std::string text = indented(lines);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text;
}

Localized moved_in(const Localized& lines) {
    return {moved_in(lines.english), moved_in(lines.french)};
}

Localized told_stimuli(const Chart& chart, const FoundRace& found) {
    return messages::orders::stimuli(moved_in(write_stimuli(found.stimuli, chart.grafcet)));
}

/// What helps, or that nothing does.
Localized told_cure(const InterlockedChart& interlocked) {
    if (interlocked.interlocks.empty()) return messages::orders::no_cure();
    return messages::orders::cure(told_interlocks(interlocked));
}

/// The lines of a text as one.
std::string in_one_line(const std::string& lines) {
    std::string text;
    for (const std::string& line : lines_of(lines)) text += (text.empty() ? "" : "; ") + line;
    return text;
}

/// A warning each; the last of them gets `cures` as notes.
void warn_of(const Chart& chart, const RaceReport& report, const std::vector<Localized>& cures,
             Diagnostics& diagnostics) {
    for (const FoundRace& found : report.races) {
        Diagnostic& warning =
            diagnostics.warning(code::order_of_clearing, place_of(chart.grafcet, found.race),
                                say::order_matters(told_race(chart.grafcet, found.race)));
        warning.notes.push_back({chart.grafcet.transitions[found.race.second].where,
                                 told_ends(chart.grafcet, found.race)});
        warning.notes.push_back({{},
                                 messages::orders::stimuli_in_one_line(
                                     in_one_line(write_stimuli(found.stimuli, chart.grafcet)))});
        if (&found != &report.races.back()) continue;
        for (const Localized& cure : cures) warning.notes.push_back({{}, cure});
    }
    if (!report.is_complete) {
        diagnostics.warning(code::order_of_clearing, {},
                            say::order_seen_in_part(messages::counted::cases(report.cases)));
    }
}

void add_text(Localized& text, const Localized& more) {
    text.english += more.english;
    text.french += more.french;
}

/// The remark beside a verdict: every race with what it comes to and its stimuli, then what helps.
Localized remark_on(const Chart& chart, const RaceReport& report, const Localized& cure) {
    Localized text;
    if (report.races.empty()) return text;
    add_text(text, say::remark_on_orders());
    const Localized line_end = Localized::same_in_both("\n");
    for (const FoundRace& found : report.races) {
        add_text(text, moved_in(told_race(chart.grafcet, found.race)));
        add_text(text, line_end);
        for (const Localized& more :
             {told_ends(chart.grafcet, found.race), told_stimuli(chart, found)}) {
            add_text(text, moved_in(moved_in(more)));
            add_text(text, line_end);
        }
    }
    add_text(text, moved_in(cure));
    add_text(text, line_end);
    return text;
}

}  // namespace

OrderFindings find_orders(const Chart& chart, bool modes) {
    RaceOptions options;
    options.has_modes = modes;
    options.max_cases = bound_for(chart.grafcet);
    RaceReport races = find_races(chart.grafcet, options);
    InterlockedChart interlocked =
        with_interlocks(chart.grafcet, races, options, searches_for_interlocks * options.max_cases);
    return {std::move(races), std::move(interlocked)};
}

Chart interlocked_chart(const Chart& chart, const OrderFindings& findings) {
    return {chart.source, findings.interlocked.grafcet, chart.warnings};
}

Diagnostics order_warnings(const Chart& chart, const OrderFindings& findings) {
    Diagnostics diagnostics;
    std::vector<Localized> cures;
    const InterlockedChart& interlocked = findings.interlocked;
    for (const Interlock& interlock : interlocked.interlocks) {
        cures.push_back(messages::orders::one_cure(told_interlock(interlocked, interlock)));
    }
    if (cures.empty()) cures.push_back(messages::orders::no_cure());
    warn_of(chart, findings.races, cures, diagnostics);
    return diagnostics;
}

Diagnostics interlock_warnings(const Chart& chart, const OrderFindings& findings) {
    Diagnostics diagnostics;
    warn_of(chart, findings.interlocked.left, {say::interlocks_do_not_suffice()}, diagnostics);
    return diagnostics;
}

Localized told_interlocks(const OrderFindings& findings) {
    const InterlockedChart& chart = findings.interlocked;
    if (chart.interlocks.empty() && chart.left.races.empty() && chart.left.is_complete) {
        return say::no_interlock_needed();
    }
    if (chart.interlocks.empty()) return messages::orders::no_cure();
    return say::interlocks_added(chart.interlocks.size(), told_interlocks(chart));
}

std::vector<std::string> interlock_sentences(const OrderFindings& findings) {
    std::vector<std::string> sentences;
    for (const Interlock& interlock : findings.interlocked.interlocks) {
        sentences.push_back(told_interlock(findings.interlocked, interlock).english);
    }
    return sentences;
}

OrderRemarks order_remarks(const Chart& chart, const OrderFindings& findings, bool is_interlocked) {
    const RaceReport& report = is_interlocked ? findings.interlocked.left : findings.races;
    OrderRemarks remarks;
    for (const FoundRace& found : report.races) {
        const OrderRace& race = found.race;
        const auto& transitions = chart.grafcet.transitions;
        remarks.races.push_back({std::string(name_of(race.kind)),
                                 race.first == none ? std::string() : transitions[race.first].name,
                                 transitions[race.second].name,
                                 write_stimuli(found.stimuli, chart.grafcet)});
    }
    remarks.cases = report.cases;
    remarks.is_complete = report.is_complete;
    remarks.text = remark_on(
        chart, report,
        is_interlocked ? say::interlocks_do_not_suffice() : told_cure(findings.interlocked));
    if (!is_interlocked) return remarks;
    const Grafcet& grafcet = findings.interlocked.grafcet;
    for (const Interlock& interlock : findings.interlocked.interlocks) {
        const Transition& waiting = grafcet.transitions[interlock.waiting];
        remarks.interlocks.push_back(
            {waiting.name, grafcet.transitions[interlock.awaited].name,
             write_expression(grafcet, grafcet.expressions, interlock.condition),
             write_expression(grafcet, grafcet.expressions, waiting.condition)});
    }
    remarks.interlock_text = told_interlocks(findings.interlocked);
    return remarks;
}

std::string interlocked_text(const Chart& chart, const OrderFindings& findings) {
    const Grafcet& grafcet = findings.interlocked.grafcet;
    std::vector<AddedCondition> added;
    for (const Interlock& interlock : findings.interlocked.interlocks) {
        const ExprKind kind = grafcet.expressions.kind(interlock.condition);
        added.push_back({interlock.waiting,
                         write_expression(grafcet, grafcet.expressions, interlock.condition),
                         kind != ExprKind::disjunction && kind != ExprKind::exclusive_or});
    }
    return with_added_conditions(chart.source, chart.grafcet, added);
}

}  // namespace grafwire
