#include <fmt/format.h>

#include <algorithm>

#include "check/scan_check.h"
#include "evolution/run.h"
#include "laddercheck/ladder_device.h"
#include "plcopen/messages.h"
#include "plcopen/read_ladder.h"
#include "s7/addresses/messages.h"
#include "s7check/explain_listing.h"
#include "s7check/fault_localization.h"
#include "s7check/listing_device.h"
#include "workflow/check_parts.h"
#include "workflow/messages.h"

namespace grafwire {

namespace {

namespace say = messages::workflow;

/// The files that show the witness of a program: stimuli, what reference and program make of them,
/// the explanation.
std::vector<NamedText> files_of_scans(const Grafcet& grafcet, const ScannedDevice& device,
                                      const Witness& witness, const std::string& explanation) {
    const RunResult expected = run_scans(grafcet, witness.stimuli, witness.scan_period);
    const Trace got = run_device(grafcet, device, witness.stimuli, witness.scan_period);
    return {{"witness.stim", write_stimuli(witness.stimuli, grafcet)},
            {"witness.txt", explanation},
            {"expected.csv", write_csv(expected.trace)},
            {"expected.vcd", write_vcd(expected.trace, grafcet.name)},
            {"got.csv", write_csv(got)},
            {"got.vcd", write_vcd(got, grafcet.name)}};
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
            judgement.witness_files =
                files_of_scans(grafcet, device, *witness, judgement.explained.text);
        }
    }
    return judgement;
}

/// Whether every step and output has its variable; what is missing goes into `messages`.
bool can_compare(const CheckRequest& request, const LadderNames& names, Diagnostics& messages) {
    if (!names.missing.empty()) {
        messages.error(code::bad_ladder, {},
                       say::missing_variables(request.subject.against,
                                              fmt::format("{}", fmt::join(names.missing, ", "))));
        return false;
    }
    if (!names.missing_inputs.empty()) {
        messages.warning(
            code::bad_ladder, {},
            say::missing_inputs(request.subject.against,
                                fmt::format("{}", fmt::join(names.missing_inputs, ", "))));
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

}  // namespace grafwire
