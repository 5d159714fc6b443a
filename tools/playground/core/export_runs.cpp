// The files that are made of a run: of the reference, or of the gates.

#include "core/asked_chart.h"
#include "core/asked_check.h"
#include "core/export_files.h"
#include "core/messages.h"
#include "text/wrapped.h"
#include "trace/trace_table.h"
#include "workflow/drawings.h"
#include "workflow/runs.h"

namespace grafwire::playground {

namespace {

/// A chart and what is applied to it.
struct AskedRun {
    Chart chart;
    Stimuli stimuli;
    std::optional<Time> period;
};

std::optional<AskedRun> asked_run(const Arguments& arguments, Json& answer) {
    auto chart = asked_chart(arguments, answer);
    if (!chart) return std::nullopt;
    auto stimuli = asked_stimuli(arguments, *chart, answer);
    if (!stimuli) return std::nullopt;
    const AskedPeriod period = asked_period(arguments, "period", answer);
    if (!period.is_good) return std::nullopt;
    return AskedRun{std::move(*chart), std::move(*stimuli), period.value};
}

/// The gates in the same run, told in words where that is asked for.
std::optional<ExplainedSimulation> asked_simulation(const Arguments& arguments, const AskedRun& run,
                                                    bool with_waveform, bool with_words,
                                                    Json& answer) {
    const auto options = asked_options(arguments, answer);
    if (!options) return std::nullopt;
    const auto netlist = asked_netlist(arguments, run.chart, *options, answer);
    if (!netlist) return std::nullopt;
    if (with_words) {
        return explain_gates(run.chart, *netlist, run.stimuli, options->delays, run.period,
                             with_waveform, arguments.language());
    }
    return ExplainedSimulation{simulate_gates(run.chart, *netlist, run.stimuli, options->delays,
                                              run.period, with_waveform),
                               {}};
}

Json trace_answer(const Arguments& arguments, const Trace& trace, const AskedRun& run) {
    Json answer;
    const TraceFormat* format = asked_row(arguments, "format", trace_formats(), answer);
    if (format == nullptr) return answer;
    std::vector<TimingCause> causes;
    if (format->is_picture) {
        causes =
            causes_of(trace, run.chart.grafcet, tell_reference(run.chart, run.stimuli, run.period));
    }
    return file_answer(arguments, format->extension,
                       trace_in_format(trace, run.chart, *format, arguments.language(), causes));
}

}  // namespace

Json export_trace(const Arguments& arguments) {
    Json answer;
    const auto run = asked_run(arguments, answer);
    if (!run) return answer;
    const RunResult result = run_reference(run->chart, run->stimuli, run->period);
    return trace_answer(arguments, result.trace, *run);
}

Json export_gates(const Arguments& arguments) {
    Json answer;
    const auto run = asked_run(arguments, answer);
    if (!run) return answer;
    const auto simulation = asked_simulation(arguments, *run, false, false, answer);
    if (!simulation) return answer;
    return trace_answer(arguments, simulation->result.trace, *run);
}

Json export_waveform(const Arguments& arguments) {
    Json answer;
    const auto run = asked_run(arguments, answer);
    if (!run) return answer;
    const RunResult result = run_reference(run->chart, run->stimuli, run->period);
    return file_answer(arguments, ".vcd", waveform_of(result.trace, run->chart.grafcet.name).vcd);
}

Json export_gate_waveform(const Arguments& arguments) {
    Json answer;
    const auto run = asked_run(arguments, answer);
    if (!run) return answer;
    auto simulation = asked_simulation(arguments, *run, true, false, answer);
    if (!simulation) return answer;
    return file_answer(arguments, ".vcd", std::move(simulation->result.waveform.vcd));
}

Json export_story(const Arguments& arguments) {
    Json answer;
    const auto run = asked_run(arguments, answer);
    if (!run) return answer;
    const std::string text = explain_run(
        run->chart, tell_reference(run->chart, run->stimuli, run->period), arguments.language());
    return file_answer(arguments, ".txt", wrapped(text, TableLook().width));
}

Json export_gate_story(const Arguments& arguments) {
    Json answer;
    const auto run = asked_run(arguments, answer);
    if (!run) return answer;
    auto simulation = asked_simulation(arguments, *run, false, true, answer);
    if (!simulation) return answer;
    return file_answer(arguments, ".txt", wrapped(simulation->text, TableLook().width));
}

Json export_report(const Arguments& arguments) {
    Json answer;
    const ReportRow* form = asked_row(arguments, "format", report_forms(), answer);
    if (form == nullptr) return answer;
    const auto checked = asked_judgement(arguments, {}, false, answer);
    if (!checked) return answer;
    return file_answer(arguments, form->extension,
                       form->write(checked->judgement, checked->chart, 0, arguments.language()));
}

}  // namespace grafwire::playground
