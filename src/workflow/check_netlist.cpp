#include "check/check_equivalence.h"
#include "check/coverage.h"
#include "check/netlist_witness.h"
#include "check/partial_inputs.h"
#include "evolution/run.h"
#include "explain/explain.h"
#include "explain/write_explanation.h"
#include "grafcet/messages.h"
#include "simulate/simulate.h"
#include "text/utf8.h"
#include "workflow/check_parts.h"
#include "workflow/messages.h"

namespace grafwire {

namespace {

/// Of the way through the gates, what a report for people shows.
constexpr std::size_t most_links = 36;

/// The files that show a witness: stimuli, what reference and netlist make of them, the
/// explanation.
std::vector<NamedText> files_of_witness(const Grafcet& grafcet, const Netlist& netlist,
                                        const CellDelays& delays, const Witness& witness,
                                        const std::string& explanation) {
    const Stimuli& stimuli = witness.stimuli;
    const RunResult run = witness.scan_period == 0
                              ? run_until_stable(grafcet, stimuli)
                              : run_scans(grafcet, stimuli, witness.scan_period);
    SimulateOptions options;
    options.waveform = true;
    options.scan_period = witness.scan_period;
    const SimulateResult simulated = simulate(grafcet, netlist, delays, stimuli, options);
    return {{"witness.stim", write_stimuli(stimuli, grafcet)},
            {"witness.txt", explanation},
            {"expected.csv", write_csv(run.trace)},
            {"expected.vcd", write_vcd(run.trace, grafcet.name)},
            {"got.csv", write_csv(simulated.trace)},
            {"got.vcd", simulated.waveform}};
}

/// Explains the witness, with its files beside it if they are wanted.
void add_explanation(Judgement& judgement, const Grafcet& grafcet, const Netlist& netlist,
                     const CheckRequest& request) {
    const CellDelays delays = cell_delays(netlist, request.subject.delays);
    const Witness& witness = *judgement.result.witness;
    const Netlist powered = with_power_up(netlist, witness.power_up);
    const Explanation explanation = explain(grafcet, powered, delays, witness);
    const auto text_in = [&](Language language, std::size_t links) {
        return write_explanation(grafcet, powered, witness, explanation,
                                 {language, links, request.subject.against});
    };
    judgement.explained.text = text_in(request.language, most_links);
    for (const Netlist::InitialValue& initial : witness.power_up) {
        judgement.explained.power_up.emplace_back(netlist.names[initial.net], initial.value);
    }
    if (explanation.cause) judgement.explained.cause = identifier_of(explanation.cause->kind);
    judgement.explained.lines = lines_of(text_in(Language::english, 0));
    if (request.with_files) {
        judgement.witness_files =
            files_of_witness(grafcet, powered, delays, witness, text_in(request.language, 0));
    }
}

}  // namespace

bool is_worth_checking(const Chart& chart, const std::string& file, bool has_modes,
                       Diagnostics& messages) {
    if (!can_ever_act(chart.grafcet)) {
        messages.error(code::no_steps, {}, messages::workflow::nothing_ever_happens(visible(file)));
        return false;
    }
    if (!Assumptions(chart.grafcet).can_hold(unassigned_inputs(chart.grafcet, has_modes))) {
        messages.error(code::contradicting_assumptions, {},
                       messages::workflow::assumptions_leave_no_input());
        return false;
    }
    return true;
}

CheckOptions check_options(const CheckRequest& request) {
    CheckOptions options;
    options.max_cases = request.max_cases;
    options.changes = request.changes;
    options.delays = request.subject.delays;
    options.progress = request.progress;
    options.keep_going = request.keep_going;
    return options;
}

PowerUp power_up_of(const Chart& chart, const Netlist& netlist, bool is_from_elsewhere) {
    const Grafcet& grafcet = chart.grafcet;
    const NetId init = map_ports(grafcet, netlist).inputs[grafcet.inputs.size()];
    if (init != no_net) return PowerUp::init;
    if (!is_from_elsewhere) return PowerUp::initial_values;
    return netlist.starts_initially ? PowerUp::given : PowerUp::unknown;
}

std::optional<Judgement> check_netlist(const Chart& chart, const Netlist& netlist,
                                       const CheckRequest& request, Diagnostics& messages) {
    if (!is_worth_checking(chart, request.subject.file, netlist.has_modes, messages)) {
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
    // Compare it with the reference in every reachable case.
    CheckOptions options = check_options(request);
    options.scan_period = request.period;
    judgement.result = check_equivalence(chart.grafcet, netlist, options);
    // Explain a difference.
    if (judgement.result.witness) add_explanation(judgement, chart.grafcet, netlist, request);
    return judgement;
}

}  // namespace grafwire
