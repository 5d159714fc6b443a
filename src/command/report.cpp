// grafwire report: everything about a GRAFCET on one page. A report that is written is a success,
// whatever the verdicts in it: `check` has the exit status for them.

#include "workflow/report.h"

#include <filesystem>

#include "command/command_line.h"
#include "command/help.h"
#include "command/inputs.h"
#include "command/progress.h"
#include "command/worker_pool.h"
#include "workflow/schematics.h"

namespace grafwire {

namespace {

namespace help = messages::help;

/// What may be written after `grafwire report`.
struct ReportArguments {
    std::string path;
    std::string stimuli;
    std::string style = "gates";
    std::string symbols = "iec";
    std::string changes = "one";
    std::uint64_t jobs = 0;  ///< 0: as many as there are cores
    std::uint64_t max_cases = 0;
    double max_seconds = 0;
    std::string max_memory;  ///< empty: no bound
    std::string output;
};

/// Of a path, the name: the same page wherever the files are.
std::string name_of_file(const std::string& path) {
    return std::filesystem::path(path).filename().string();
}

ExitStatus write_page(const ReportArguments& request, const CommandLine& line) {
    if (share_standard_input(request.path, request.stimuli)) return ExitStatus::bad_request;
    const auto chart = load_chart(request.path, line);
    if (!chart) return ExitStatus::bad_request;
    std::optional<Stimuli> stimuli;
    if (!request.stimuli.empty()) {
        stimuli = load_stimuli(request.stimuli, chart->grafcet);
        if (!stimuli) return ExitStatus::bad_request;
    }
    std::uint64_t max_memory = 0;
    if (!request.max_memory.empty()) {
        const auto bytes = parse_memory(request.max_memory);
        if (!bytes) return ExitStatus::bad_request;
        max_memory = *bytes;
    }
    ReportRequest asked;
    asked.file = name_of_file(request.path);
    asked.stimuli = stimuli ? &*stimuli : nullptr;
    asked.stimuli_file = name_of_file(request.stimuli);
    asked.style = row_named(style_table, request.style)->style;
    asked.shapes = row_named(gate_shapes_table, request.symbols)->shapes;
    asked.changes = request.changes == "many" ? Changes::many : Changes::one;
    asked.max_cases = request.max_cases;
    WorkerPool workers(request.jobs);
    asked.workers = &workers;
    asked.language = line.language();
    std::string page;
    {
        Progress progress(request.max_seconds, max_memory, line.language());
        asked.progress = [&progress](const Coverage& coverage) { progress.show(coverage); };
        asked.keep_going = [&progress] { return progress.goes_on(); };
        page = report_of(*chart, asked);
    }
    OutputFiles files({request.path, request.stimuli});
    files.add(request.output, std::move(page));
    return finish(files, ExitStatus::done);
}

}  // namespace

Task declare_report(const CommandLine& line) {
    const auto request = std::make_shared<ReportArguments>();
    line.add_argument(help::file_name, request->path, help::file()).names_file({".grafcet"});
    line.add_optional_argument(help::stim_name, request->stimuli, help::report_stim())
        .names_file({".stim"});
    line.add("--style", request->style, help::report_style())
        .one_of_names(style_table)
        .shows_default();
    line.add("--symbols", request->symbols, help::report_symbols())
        .one_of_names(gate_shapes_table)
        .shows_default();
    line.add("--changes", request->changes, help::changes()).one_of({"one", "many"});
    line.add("-j", request->jobs, help::jobs());
    line.add("--max-cases", request->max_cases, help::report_max_cases());
    line.add("--max-seconds", request->max_seconds, help::report_max_seconds());
    line.add("--max-memory", request->max_memory, help::max_memory());
    line.add("-o", request->output, help::report_output()).names_file({});
    line.add_strict();
    return [request, line] { return write_page(*request, line); };
}

}  // namespace grafwire
