// What every explanation begins with: what changed outside at the end of a witness, and what the
// reference made of it, scan by scan. The reference is run once more up to the last instant, and
// that one is repeated with its scans recorded:
//
//     At 100 ms: a=1.
//     The reference:
//       before: X0
//       scan 1: clears (1) 0 -> 1. Situation: X1
//
// A scan that changes nothing is left out (so the last one of every instant), and of a long
// cascade the first scans are shown.

#include "explain/explanation_writer.h"

#include <fmt/format.h>

#include <algorithm>

#include "evolution/run.h"
#include "explain/messages.h"
#include "grafcet/shown_transition.h"
#include "grafcet/write_grafcet.h"
#include "text/joined.h"
#include "trace/input_values.h"

namespace grafwire {

namespace {

namespace words = messages::explain;

constexpr std::size_t most_scans = 8;     ///< that are shown
constexpr std::size_t most_noted = 1000;  ///< of an instant

/// One scan; false if it was the last of its instant.
bool note_scan(const Evolution& evolution, EvolutionState& state, const InputValues& inputs,
               Time at, ReferenceEnd& end) {
    ReferenceEnd::Scan scan;
    scan.at = at;
    scan.cleared = evolution.cleared_by_scan(state, {inputs}, at);
    const EvolutionState before = state;
    evolution.scan(state, {inputs}, at);
    scan.situation = state.situation;
    scan.changes = before.situation != state.situation || !scan.cleared.empty();
    end.scans.push_back(std::move(scan));
    return !Evolution::is_settled(before, state);
}

/// Up to the last instant of a run until stable, and the scans of that one.
void follow_instants(const Evolution& evolution, const Witness& witness, ReferenceEnd& end) {
    const RunResult run = run_until_stable(evolution.grafcet(), witness.stimuli);
    StimuliPlayer player(witness.stimuli, evolution.grafcet().all_input_count());
    EvolutionState state;
    for (std::size_t row = 0; row < run.trace.row_count(); ++row) {
        const Time at = run.trace.times[row];
        player.advance(at);
        const InputValues& values = player.inputs();
        if (row == 0) {
            state = evolution.start({values});
        } else {
            evolution.end_delays(state, {values}, at);
        }
        if (row + 1 < run.trace.row_count()) {
            evolution.settle(state, {values}, at);
            continue;
        }
        end.before = state.situation;
        while (end.scans.size() < most_noted && note_scan(evolution, state, values, at, end)) {
        }
    }
}

/// The last scans of a run scan by scan: those since the inputs changed, but not too many.
void follow_scans(const Evolution& evolution, const Witness& witness, ReferenceEnd& end) {
    const Time period = witness.scan_period;
    const auto& changes = witness.stimuli.changes;
    const Time change = changes.empty() ? 0 : changes.back().at;
    const Time last = witness.stimuli.end / period;
    const Time first = std::max<Time>(
        {0, (change + period - 1) / period, last - static_cast<Time>(most_scans) + 1});
    StimuliPlayer player(witness.stimuli, evolution.grafcet().all_input_count());
    player.advance(0);
    EvolutionState state = evolution.start({player.inputs()});
    for (Time scan = 0; scan <= last; ++scan) {
        player.advance(scan * period);
        const InputValues& values = player.inputs();
        if (scan == first) end.before = state.situation;
        if (scan < first) {
            evolution.scan(state, {values}, scan * period);
        } else {
            note_scan(evolution, state, values, scan * period, end);
        }
    }
}

}  // namespace

bool ReferenceEnd::clears(TransitionId transition) const {
    return std::any_of(scans.begin(), scans.end(), [&](const Scan& scan) {
        return std::find(scan.cleared.begin(), scan.cleared.end(), transition) !=
               scan.cleared.end();
    });
}

/// By instants where the witness is one of instants, by scans where it has a scan period.
ReferenceEnd end_of_reference(const Grafcet& grafcet, const Witness& witness) {
    const Evolution evolution(grafcet);
    ReferenceEnd end;
    if (witness.scan_period == 0) {
        follow_instants(evolution, witness, end);
    } else {
        follow_scans(evolution, witness, end);
    }
    return end;
}

void ExplanationWriter::explain_changes() {
    const Time last = witness_.stimuli.end;
    const auto& changes = witness_.stimuli.changes;
    std::vector<std::string> set;
    if (!changes.empty() && changes.back().at == last) {
        for (const Stimuli::Assignment& assignment : changes.back().assignments) {
            set.push_back(fmt::format("{}={}",
                                      quoted_where_needed(input_name(grafcet_, assignment.input)),
                                      assignment.value ? 1 : 0));
        }
    }
    const std::string time = format_milliseconds(last);
    if (set.empty()) {
        say(words::no_change_at, time);
    } else {
        say(words::changes_at, time, joined(set, " "));
    }
}

std::string ExplanationWriter::situation_text(const BitTable& situation) const {
    std::vector<std::string> active;
    for (std::size_t i = 0; i < situation.size(); ++i) {
        if (situation.test(i)) {
            active.push_back("X" + grafcet_.steps[grafcet_.steps.id_at(i)].name);
        }
    }
    if (active.empty()) return words::no_step.in(language_);
    return joined(active, " ");
}

void ExplanationWriter::explain_reference() {
    say(words::the_reference);
    const ReferenceEnd end = end_of_reference(grafcet_, witness_);
    say(words::before, situation_text(end.before));
    std::size_t shown = 0;
    for (std::size_t i = 0; i < end.scans.size(); ++i) {
        const ReferenceEnd::Scan& scan = end.scans[i];
        if (!scan.changes) continue;
        if (shown++ == most_scans) {
            add("  …\n");
            break;
        }
        explain_scan(scan, i + 1);
    }
}

/// By its number within the instant, or by its moment where the witness has a scan period.
void ExplanationWriter::explain_scan(const ReferenceEnd::Scan& scan, std::size_t number) {
    const bool is_numbered = witness_.scan_period == 0;
    const std::string moment = format_milliseconds(scan.at);
    const std::string situation = situation_text(scan.situation);
    if (scan.cleared.empty()) {
        if (is_numbered) {
            say(words::scan_of_orders, number, situation);
        } else {
            say(words::scan_at_of_orders, moment, situation);
        }
        return;
    }
    std::vector<std::string> names;
    for (const TransitionId id : scan.cleared) names.push_back(shown_transition(grafcet_, id));
    const std::string cleared = joined(names, words::between_transitions.in(language_));
    if (is_numbered) {
        say(words::scan_clears, number, cleared, situation);
    } else {
        say(words::scan_at_clears, moment, cleared, situation);
    }
}

std::string ExplanationWriter::network_text(std::uint32_t number, const std::string& comment,
                                            Location where) const {
    if (where.is_known()) {
        return comment.empty()
                   ? words::network_at.in(language_, number, where.line)
                   : words::network_titled_at.in(language_, number, comment, where.line);
    }
    return comment.empty() ? words::network.in(language_, number)
                           : words::network_titled.in(language_, number, comment);
}

void ExplanationWriter::explain_difference(const Message<>& other_side) {
    say(words::where_they_part);
    for (const Witness::Value& value : witness_.values) {
        if (value.expected == value.got) continue;
        say(words::values_differ, value.name, digit_of(value.expected), other_side(),
            digit_of(value.got));
    }
}

}  // namespace grafwire
