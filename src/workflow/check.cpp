// The checks of a netlist, a ladder diagram and a listing. All go the same way: see whether the
// question makes sense, compare with the reference in every case that can be reached, explain the
// witness if there is one. They differ in what explores (`check_equivalence` for gates, which have
// no scans of their own, `check_scans` for programs) and in who explains.

#include "workflow/check.h"

#include <algorithm>

#include "check/check_equivalence.h"
#include "check/coverage.h"
#include "check/netlist_witness.h"
#include "check/partial_inputs.h"
#include "check/scan_check.h"
#include "draw/write_drawing.h"
#include "explain/explain.h"
#include "explain/pulse_race.h"
#include "explain/write_explanation.h"
#include "grafcet/messages.h"
#include "laddercheck/ladder_device.h"
#include "netlist/passes/wire_delays.h"
#include "netlist/styles/messages.h"
#include "plcopen/messages.h"
#include "plcopen/read_ladder.h"
#include "s7/addresses/messages.h"
#include "s7check/explain_listing.h"
#include "s7check/fault_localization.h"
#include "s7check/listing_device.h"
#include "schedule/delays_text.h"
#include "simulate/simulate.h"
#include "story/instant_story.h"
#include "text/joined.h"
#include "text/utf8.h"
#include "workflow/check_list.h"
#include "workflow/drawings.h"
#include "workflow/messages.h"

namespace grafwire {

namespace {

namespace say = messages::workflow;

/// Whether the chart gives a check something to say; why not goes into `messages`.
bool is_worth_checking(const Chart& chart, const std::string& file, bool has_modes,
                       Diagnostics& messages) {
    if (!can_ever_act(chart.grafcet)) {
        messages.error(code::no_steps, {}, say::nothing_ever_happens(visible(file)));
        return false;
    }
    if (!Assumptions(chart.grafcet).can_hold(unassigned_inputs(chart.grafcet, has_modes))) {
        messages.error(code::contradicting_assumptions, {}, say::assumptions_leave_no_input());
        return false;
    }
    return true;
}

/// The options of the explorations.
CheckOptions check_options(const CheckRequest& request) {
    CheckOptions options;
    options.max_cases = request.max_cases;
    options.workers = request.workers;
    options.changes = request.changes;
    options.delays = request.subject.delays;
    options.progress = request.progress;
    options.keep_going = request.keep_going;
    options.looks_for_pulses = request.looks_for_pulses;
    return options;
}

/// Of the way through the gates, what a report for people shows.
constexpr std::size_t most_links = 36;

/// A run, and its waveform.
struct Recorded {
    const Trace& trace;
    Waveform waveform;
};

/// Enters the files that show a witness, in the order of witness_file_names, and its picture: what
/// the reference does, and what was found.
void add_witness_files(Judgement& judgement, const Grafcet& grafcet, const std::string& explanation,
                       const Recorded& got, Language language) {
    const Witness& witness = *judgement.result.witness;
    const auto period =
        witness.scan_period == 0 ? std::nullopt : std::optional<Time>(witness.scan_period);
    const ToldRun run = tell_run(grafcet, witness.stimuli, period);
    const Trace& trace = run.result.trace;
    const Recorded expected{trace, waveform_of(trace, grafcet.name)};
    const ShownRun shown{trace, title_of(grafcet), causes_of(trace, grafcet, run)};
    judgement.witness_picture = sheets_of_runs(shown, &got.trace, language);
    const std::string picture =
        write_svg_drawing(judgement.witness_picture, shown.title, papers[0], language);
    judgement.witness_files = {{"witness.stim", write_stimuli(witness.stimuli, grafcet)},
                               {"witness.txt", explanation},
                               {"witness.svg", picture},
                               {"expected.csv", write_csv(expected.trace)},
                               {"expected.vcd", expected.waveform.vcd},
                               {"expected.gtkw", write_gtkw(expected.waveform, "expected.vcd")},
                               {"got.csv", write_csv(got.trace)},
                               {"got.vcd", got.waveform.vcd},
                               {"got.gtkw", write_gtkw(got.waveform, "got.vcd")}};
}

/// The same delays, with every gate named from the start.
DelaySchedule all_delays(const Netlist& netlist, const CellDelays& delays,
                         const DelaySchedule& schedule) {
    DelaySchedule all;
    for (std::size_t i = 0; i < netlist.cells.size(); ++i) {
        all.changes.push_back({0, netlist.cells.id_at(i), delays.rise[i], delays.fall[i], 0});
    }
    all.changes.insert(all.changes.end(), schedule.changes.begin(), schedule.changes.end());
    return all;
}

/// What the netlist makes of the stimuli of a witness, beside the reference.
void add_files_of_gates(Judgement& judgement, const Grafcet& grafcet, const Netlist& netlist,
                        const CellDelays& delays, const std::string& explanation,
                        Language language) {
    const Witness& witness = *judgement.result.witness;
    const Stimuli& stimuli = witness.stimuli;
    SimulateOptions options;
    options.waveform = true;
    options.scan_period = witness.scan_period;
    options.schedule = witness.delays;
    const SimulateResult simulated = simulate(grafcet, netlist, delays, stimuli, options);
    add_witness_files(judgement, grafcet, explanation, {simulated.trace, simulated.waveform},
                      language);
    if (!witness.delays.changes.empty()) {
        judgement.witness_files.push_back(
            {"witness.delays", write_delays(all_delays(netlist, delays, witness.delays), netlist)});
    }
}

/// Puts a witness into words; `whole`: all of it, in the language of the request.
ExplainedWitness explained_by_gates(const Grafcet& grafcet, const Netlist& netlist,
                                    const CellDelays& delays, const Witness& witness,
                                    const CheckRequest& request, std::string& whole) {
    const Netlist powered = with_power_up(netlist, witness.power_up);
    const Explanation explanation = explain(grafcet, powered, delays, witness);
    const auto text_in = [&](Language language, std::size_t links) {
        return write_explanation(grafcet, powered, witness, explanation,
                                 {language, links, request.subject.against});
    };
    ExplainedWitness explained;
    explained.text = text_in(request.language, most_links);
    for (const Netlist::InitialValue& initial : witness.power_up) {
        explained.power_up.emplace_back(netlist.names[initial.net], initial.value);
    }
    if (explanation.cause) explained.cause = identifier_of(explanation.cause->kind);
    explained.lines = lines_of(text_in(Language::english, 0));
    whole = text_in(request.language, 0);
    return explained;
}

/// Explains the witness, with its files beside it if they are wanted.
void add_explanation(Judgement& judgement, const Grafcet& grafcet, const Netlist& netlist,
                     const CheckRequest& request) {
    const CellDelays delays = cell_delays(netlist, request.subject.delays);
    const Witness& witness = *judgement.result.witness;
    std::string whole;
    judgement.explained = explained_by_gates(grafcet, netlist, delays, witness, request, whole);
    if (request.with_files) {
        add_files_of_gates(judgement, grafcet, with_power_up(netlist, witness.power_up), delays,
                           whole, request.language);
    }
}

/// A netlist in which only those wires take time that a schedule names, and that schedule for it.
struct NeededWires {
    Netlist netlist;
    DelaySchedule schedule;
};
NeededWires needed_wires(const Netlist& netlist, const DelaySchedule& delays) {
    const std::vector<Wire> wires = telling_wires(netlist);
    const std::size_t gates = netlist.cells.size();
    std::vector<Wire> needed;
    DelaySchedule schedule = delays;
    for (DelayChange& change : schedule.changes) {
        if (index_of(change.cell) < gates) continue;
        const Wire& wire = wires[index_of(change.cell) - gates];
        const auto known = std::find(needed.begin(), needed.end(), wire);
        change.cell = static_cast<CellId>(gates + static_cast<std::size_t>(known - needed.begin()));
        if (known == needed.end()) needed.push_back(wire);
    }
    return {with_wire_delays(netlist, needed), std::move(schedule)};
}

/// Makes the witness one in terms of a netlist in which only those wires take time that the
/// difference needs, and gives that netlist; else `wired`, where the others are as fast as gates.
Netlist with_wires_needed(const Grafcet& grafcet, const Netlist& netlist, const Netlist& wired,
                          const DelayModel& delays, Witness& witness) {
    NeededWires fewer = needed_wires(netlist, witness.delays);
    auto again = replay(grafcet, with_power_up(fewer.netlist, witness.power_up),
                        cell_delays(fewer.netlist, delays), witness.stimuli, 0, fewer.schedule);
    if (!again || again->kind != witness.kind) return wired;
    again->power_up = std::move(witness.power_up);
    again->delays = std::move(fewer.schedule);
    witness = std::move(*again);
    return std::move(fewer.netlist);
}

/// The same of a net that changes too often.
Netlist with_wires_needed(const Grafcet& grafcet, const Netlist& netlist, const Netlist& wired,
                          const DelayModel& delays, Pulse& pulse) {
    NeededWires fewer = needed_wires(netlist, pulse.delays);
    const unsigned changes =
        changes_at_end(grafcet, fewer.netlist, cell_delays(fewer.netlist, delays), pulse.stimuli,
                       run_until_stable(grafcet, pulse.stimuli), fewer.schedule, pulse.net);
    if (changes <= pulse.expected) return wired;
    pulse.got = changes;
    pulse.delays = std::move(fewer.schedule);
    return std::move(fewer.netlist);
}

std::vector<std::string> net_names(const Netlist& netlist, const std::vector<NetId>& nets) {
    std::vector<std::string> names;
    for (const NetId net : nets) names.emplace_back(netlist.names[net]);
    return names;
}

/// Explains what changes too often. `compared` is what was simulated, with wires as cells where
/// they take time.
std::vector<ExplainedPulse> explained_pulses(const Grafcet& grafcet, const Netlist& netlist,
                                             const Netlist& compared, Pulses& pulses,
                                             const CheckRequest& request) {
    const DelayModel& model = request.subject.delays;
    std::vector<ExplainedPulse> all;
    for (Pulse& pulse : pulses.found) {
        const bool has_wires = model.kind == DelayModel::Kind::any_wire;
        const Netlist shown =
            has_wires ? with_wires_needed(grafcet, netlist, compared, model, pulse) : compared;
        const CellDelays delays = cell_delays(shown, model);
        const PulseRace race = race_of(grafcet, shown, delays, pulse);
        const auto text_in = [&](Language language) {
            return write_pulse(grafcet, shown, pulse, race, {language, 0, request.subject.against});
        };
        ExplainedPulse explained{text_in(request.language),
                                 lines_of(text_in(Language::english)),
                                 net_names(shown, race.sooner),
                                 net_names(shown, race.later),
                                 {}};
        if (!pulse.delays.changes.empty()) {
            explained.delays = write_delays(all_delays(shown, delays, pulse.delays), shown);
        }
        all.push_back(std::move(explained));
    }
    return all;
}

/// Finds how much delays may differ, and explains what goes wrong first.
void add_tolerance(Judgement& judgement, const Grafcet& grafcet, const CheckRequest& request) {
    Tolerance tolerance = find_tolerance(grafcet, request.tolerance_of, check_options(request));
    if (tolerance.witness) {
        const DelayModel delays = delays_of_ratio(tolerance.fails);
        if (const auto netlist = request.tolerance_of(delays)) {
            std::string whole;
            judgement.explained.at_tolerance.push_back(
                explained_by_gates(grafcet, *netlist, cell_delays(*netlist, delays),
                                   *tolerance.witness, request, whole));
        }
    }
    judgement.result.tolerance = std::move(tolerance);
}

}  // namespace

PowerUp power_up_of(const Chart& chart, const Netlist& netlist, bool is_from_elsewhere) {
    const Grafcet& grafcet = chart.grafcet;
    const NetId init = map_ports(grafcet, netlist).inputs[grafcet.inputs.size()];
    if (init != no_net) return PowerUp::init;
    if (!is_from_elsewhere) return PowerUp::initial_values;
    return netlist.starts_initially ? PowerUp::given : PowerUp::unknown;
}

/// The period of a clocked netlist is part of the verdict, and so is how many inputs change at once
/// in one without a clock; the report names both.
std::optional<Judgement> check_netlist(const Chart& chart, const Netlist& netlist,
                                       const CheckRequest& request, Diagnostics& messages) {
    if (!is_worth_checking(chart, request.subject.file, netlist.has_modes, messages)) {
        return std::nullopt;
    }
    if (netlist.is_clocked() && !request.subject.delays.is_fixed()) {
        messages.error(code::unsupported_by_style, {}, say::clocked_has_no_races());
        return std::nullopt;
    }
    Judgement judgement{request.subject, {}, {}, {}};
    CheckSubject& subject = judgement.subject;
    if (netlist.is_clocked()) {
        subject.period = request.period ? format_duration(*request.period) : "every";
    } else {
        subject.changes = request.changes;
    }
    subject.power_up = power_up_of(chart, netlist, !subject.against.empty());
    subject.warnings = chart.warnings;
    if (subject.delays.family != nullptr) {
        subject.figures = used_figures(*subject.delays.family, netlist);
    }
    // Compare it with the reference in every reachable case.
    CheckOptions options = check_options(request);
    options.scan_period = request.period;
    const bool has_wires = subject.delays.kind == DelayModel::Kind::any_wire;
    Netlist compared = has_wires ? with_wire_delays(netlist, telling_wires(netlist)) : netlist;
    judgement.result = check_equivalence(chart.grafcet, compared, options);
    // Explain a difference, and what changes too often.
    std::vector<ExplainedPulse> pulses;
    if (judgement.result.pulses) {
        pulses =
            explained_pulses(chart.grafcet, netlist, compared, *judgement.result.pulses, request);
    }
    if (auto& witness = judgement.result.witness) {
        if (has_wires) {
            compared =
                with_wires_needed(chart.grafcet, netlist, compared, subject.delays, *witness);
        }
        add_explanation(judgement, chart.grafcet, compared, request);
    }
    judgement.explained.pulses = std::move(pulses);
    if (request.tolerance_of) add_tolerance(judgement, chart.grafcet, request);
    return judgement;
}

// Programs.

namespace {

/// What the program makes of the stimuli of a witness, beside the reference.
void add_files_of_scans(Judgement& judgement, const Grafcet& grafcet, const ScannedDevice& device,
                        Language language) {
    const Witness& witness = *judgement.result.witness;
    const Trace got = run_device(grafcet, device, witness.stimuli, witness.scan_period);
    add_witness_files(judgement, grafcet, judgement.explained.text,
                      {got, waveform_of(got, grafcet.name)}, language);
}

/// Compares a program with the reference after every scan, in every state that can be reached.
/// `explain` puts a witness into words.
std::optional<Judgement> check_device(
    const Chart& chart, const ScannedDevice& device, const CheckRequest& request,
    Diagnostics& messages, const std::function<std::string(const Witness&, Language)>& explain) {
    const Grafcet& grafcet = chart.grafcet;
    if (!is_worth_checking(chart, request.subject.file, device.has_modes(), messages)) {
        return std::nullopt;
    }
    const Time period = request.period ? *request.period : natural_period(grafcet, device);
    Judgement judgement{request.subject, {}, {}, {}};
    CheckSubject& subject = judgement.subject;
    subject.is_program = true;
    subject.period = format_duration(period);
    subject.power_up = device.has_modes() ? PowerUp::init : PowerUp::initial_values;
    subject.warnings = chart.warnings;
    judgement.result = check_scans(grafcet, device, period, check_options(request));
    if (const auto& witness = judgement.result.witness) {
        judgement.explained.text = explain(*witness, request.language);
        judgement.explained.lines = lines_of(explain(*witness, Language::english));
        if (request.with_files) {
            add_files_of_scans(judgement, grafcet, device, request.language);
        }
    }
    return judgement;
}

/// Whether every step and output has its variable; what is missing goes into `messages`.
bool can_compare(const CheckRequest& request, const LadderNames& names, Diagnostics& messages) {
    if (!names.missing.empty()) {
        messages.error(
            code::bad_ladder, {},
            say::missing_variables(request.subject.against, joined(names.missing, ", ")));
        return false;
    }
    if (!names.missing_inputs.empty()) {
        messages.warning(
            code::bad_ladder, {},
            say::missing_inputs(request.subject.against, joined(names.missing_inputs, ", ")));
    }
    return true;
}

/// Init, AUdur and AUdoux have addresses, all of them or none; AUdoux needs none where it has
/// nothing to switch off.
bool has_all_modes_or_none(const Grafcet& grafcet, const s7::Binding& binding) {
    const bool has_continuous =
        std::any_of(grafcet.actions.begin(), grafcet.actions.end(),
                    [](const Action& action) { return action.kind == ActionKind::continuous; });
    const auto first = binding.inputs.end() - control_input_count;
    const auto end = binding.inputs.end() - (has_continuous ? 0 : 1);
    const auto count =
        std::count_if(first, end, [](const auto& operand) { return operand.has_value(); });
    return count == 0 || count == end - first;
}

}  // namespace

std::optional<ladder::Ladder> read_ladder(const SourceFile& source, const std::string& program,
                                          Diagnostics& diagnostics) {
    auto ladder = plcopen::read_ladder(source, diagnostics, program);
    diagnostics.sort_by_place();
    return ladder;
}

std::optional<Judgement> check_ladder(const Chart& chart, const ladder::Ladder& ladder,
                                      const CheckRequest& request, Diagnostics& messages) {
    const LadderNames names = find_names(chart.grafcet, ladder);
    if (!can_compare(request, names, messages)) return std::nullopt;
    const LadderDevice device(chart.grafcet, ladder, names);
    return check_device(chart, device, request, messages,
                        [&](const Witness& witness, Language language) {
                            return device.explain(witness, language);
                        });
}

std::optional<Judgement> check_listing(const Chart& chart, const s7::Listing& listing, s7::Cpu cpu,
                                       const s7::Binding& binding, const CheckRequest& request,
                                       Diagnostics& messages) {
    const Grafcet& grafcet = chart.grafcet;
    if (!has_all_modes_or_none(grafcet, binding)) {
        messages.error(code::unassigned_name, {}, say::modes_all_or_none());
        return std::nullopt;
    }
    const ListingDevice device(listing, cpu, binding);
    std::optional<Diagnosis> diagnosis;
    std::optional<ScannedDevice::Stop> stop;
    bool is_sought = false;
    const auto explain = [&](const Witness& witness, Language language) {
        // Find what the difference comes from, once.
        if (!is_sought) {
            diagnosis = localize_fault(grafcet, listing, cpu, binding, witness);
            stop = last_scan(grafcet, device, witness).stop;
            is_sought = true;
        }
        return explain_listing_witness(grafcet, listing, witness, diagnosis, stop, language);
    };
    return check_device(chart, device, request, messages, explain);
}

// Reports.

namespace {

std::string text(const Judgement& judgement, const Chart& chart, double, Language language) {
    return write_check_text(judgement.subject, chart.grafcet, judgement.result, judgement.explained,
                            language);
}

std::string json(const Judgement& judgement, const Chart& chart, double, Language) {
    return write_check_json(judgement.subject, chart.grafcet, judgement.result,
                            judgement.explained);
}

std::string junit(const Judgement& judgement, const Chart& chart, double seconds, Language) {
    const JunitCase only = junit_case(judgement.subject, chart.grafcet, judgement.result,
                                      judgement.explained, seconds);
    return write_junit({&only, 1});
}

std::string sarif(const Judgement& judgement, const Chart& chart, double seconds, Language) {
    CheckList list;
    list.files.push_back({chart, {}, {{chart.source, chart.warnings}}});
    CheckedCase& only = list.cases.emplace_back();
    only.subject = judgement.subject;
    only.judgement = judgement;
    only.seconds = seconds;
    return write_check_sarif(list, Language::english);
}

constexpr ReportRow table[] = {
    {"text", ".txt", text, write_texts},
    {"json", ".json", json, write_json_lines},
    {"junit", ".xml", junit, write_junit_suite, true},
    {"sarif", ".sarif", sarif, write_check_sarif, true},
};

}  // namespace

std::span<const ReportRow> report_forms() {
    return table;
}

}  // namespace grafwire
