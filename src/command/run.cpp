// grafwire run: the reference evolution, over stimuli or step by step.

#include "command/command_line.h"
#include "command/help.h"
#include "command/inputs.h"
#include "command/messages.h"
#include "command/option_uses.h"
#include "command/step_by_step.h"
#include "command/terminal.h"
#include "text/joined.h"
#include "text/wrapped.h"
#include "workflow/runs.h"

namespace grafwire {

namespace {

namespace help = messages::help;

/// What may be written after `grafwire run`.
struct RunArguments {
    std::string path;
    std::string stimuli;
    std::string scan;
    bool explain = false;
    TraceOutput output;
};

/// The reference under stimuli from a file, in a trace or in words.
ExitStatus run_stimuli(const RunArguments& request, const Chart& chart, Language language) {
    const auto stimuli = load_stimuli(request.stimuli, chart.grafcet);
    if (!stimuli) return ExitStatus::bad_request;
    const Period period = parse_period(request.scan);
    if (period.is_wrong || has_too_many_scans(chart.grafcet, *stimuli, period)) {
        return ExitStatus::bad_request;
    }
    // Let the reference evolve.
    const bool is_told = request.explain || request.output.is_picture();
    const ToldRun run = is_told ? tell_reference(chart, *stimuli, period.value)
                                : ToldRun{run_reference(chart, *stimuli, period.value), {}};
    const RunResult& result = run.result;
    for (const auto& broken : result.broken_assumptions) {
        warn(broken_assumption_text(chart.grafcet, broken));
    }
    // Write the trace, up to the instant without a stable situation if there is one.
    if (result.unstable_at) {
        complain(messages::command::no_stable_situation(format_milliseconds(*result.unstable_at),
                                                        joined(result.changing, ", ")));
    }
    OutputFiles files({request.path, request.stimuli});
    if (request.explain) {
        files.add("-", wrapped(explain_run(chart, run, language), width_of_output()));
    }
    ShownRun shown{result.trace, title_of(chart.grafcet)};
    if (request.output.is_picture()) {
        shown.causes = causes_of(result.trace, chart.grafcet, run);
    }
    if (!request.output.add_files(
            files, request.output.text_of(shown, chart, language),
            request.output.vcd.empty() ? Waveform() : waveform_of(result.trace, chart.grafcet.name),
            request.explain)) {
        return ExitStatus::bad_request;
    }
    return finish(files, result.unstable_at ? ExitStatus::answer_is_no : ExitStatus::done);
}

/// The reference under what is typed.
ExitStatus run_typed(const RunArguments& request, const Chart& chart, Language language) {
    const Period period = parse_period(request.scan);
    if (period.is_wrong) return ExitStatus::bad_request;
    return step_by_step(request.path, chart, period.value, language);
}

ExitStatus run(const RunArguments& request, const CommandLine& line) {
    const bool is_typed = request.stimuli.empty();
    if (refuse_idle_options(line, "run", is_typed ? fact::none : fact::stimuli) ||
        request.output.is_refused()) {
        return ExitStatus::bad_request;
    }
    if (share_standard_input(request.path, request.stimuli)) return ExitStatus::bad_request;
    if (is_typed && request.path == "-") {
        complain(messages::command::lines_share_standard_input());
        return ExitStatus::bad_request;
    }
    const auto chart = load_chart(request.path, line);
    if (!chart) return ExitStatus::bad_request;
    return is_typed ? run_typed(request, *chart, line.language())
                    : run_stimuli(request, *chart, line.language());
}

}  // namespace

Task declare_run(const CommandLine& line) {
    const auto request = std::make_shared<RunArguments>();
    line.add_argument(help::file_name, request->path, help::file()).names_file({".grafcet"});
    line.add_optional_argument(help::stim_name, request->stimuli, help::run_stim())
        .names_file({".stim"});
    line.add("--scan", request->scan, help::run_scan());
    line.add_flag("--explain", request->explain, help::run_explain());
    request->output.declare(line);
    request->output.declare_format(line);
    line.add_strict();
    return [request, line] { return run(*request, line); };
}

}  // namespace grafwire
