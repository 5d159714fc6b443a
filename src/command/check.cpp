// grafwire check: which charts are compared with what, with which bounds, and where the report and
// the files of witnesses go. The exit status is the verdict, of several checks the worst. All
// checks are planned before the first runs, and told in the order of the plan: what comes out does
// not depend on how many run at a time. A report in JUnit's form is written even where no check is
// made, since CI shows nothing else.

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "command/chart_results.h"
#include "command/command_line.h"
#include "command/help.h"
#include "command/judge.h"
#include "command/messages.h"
#include "command/option_uses.h"
#include "command/worker_pool.h"
#include "text/utf8.h"
#include "workflow/check_list.h"
#include "workflow/messages.h"

namespace grafwire {

namespace {

namespace say = messages::command;
namespace help = messages::help;

/// The folder that the program was called in; empty where it has none any more.
std::string folder_of_call() {
    std::error_code error;
    return std::filesystem::current_path(error).string();
}

/// The names of charts as every machine has them that has the same files in the folder of the call.
std::vector<std::string> common_names(const ChartFiles& charts, const std::string& folder) {
    std::vector<std::string> names;
    for (const ChartFile& chart : charts.files) {
        const std::filesystem::path path(chart.path);
        names.push_back((path.is_absolute() ? path.lexically_proximate(folder) : path)
                            .lexically_normal()
                            .generic_string());
    }
    return names;
}

/// What is asked for, and all that comes of it.
struct CheckRun {
    const CheckArguments& request;
    const CommandLine& line;
    ChartFiles charts;
    std::vector<PlannedCheck> plan;
    bool are_several = false;  ///< checks, in what is asked for
    bool is_refused = false;   ///< the request itself is wrong, and no check is made
    CheckList list;

    CheckArguments request_for(std::size_t number) const {
        return request.of_one(charts.files[plan[number].file].path, plan[number].style);
    }
};

CheckRun planned(const CheckArguments& request, const CommandLine& line) {
    CheckRun run{request, line, find_chart_files(request.files), {}, false, false, {}};
    const std::vector<std::string> styles =
        request.against.empty() ? styles_in(request.styles) : std::vector<std::string>(1);
    run.plan = plan_checks(run.charts.files.size(), styles);
    run.list.folder = folder_of_call();
    if (!request.shard.empty()) {
        run.plan = part_of(std::move(run.plan), common_names(run.charts, run.list.folder),
                           *parse_shard(request.shard));
    }
    run.are_several = run.charts.are_several || !request.shard.empty() ||
                      (request.against.empty() && request.styles != styles.front());
    run.list.files.resize(run.charts.files.size());
    for (std::size_t i = 0; i < run.plan.size(); ++i) {
        CheckedCase& item = run.list.cases.emplace_back();
        item.file = run.plan[i].file;
        item.subject = subject_of(run.request_for(i));
    }
    return run;
}

/// What is known of the checks before anything is read: of any of them.
unsigned facts_of(const CheckRun& run) {
    unsigned facts = fact::none;
    for (std::size_t i = 0; i < run.plan.size(); ++i) facts |= facts_of(run.request_for(i));
    return facts;
}

/// Reads every chart that is to be checked.
void load_files(CheckRun& run) {
    std::vector<bool> is_read(run.list.files.size(), false);
    for (const PlannedCheck& check : run.plan) {
        if (is_read[check.file]) continue;
        is_read[check.file] = true;
        CheckedFile& file = run.list.files[check.file];
        const MessageRecord messages;
        file.chart = load_plant(run.request, run.charts.files[check.file], run.line);
        file.text = messages.text();
        file.messages = messages.messages();
    }
}

/// Makes one check, which `workers` share, if there are any. Its messages wait, so that they can be
/// shown in the order of the plan.
void make_check(CheckRun& run, std::size_t number, const CheckValues& values,
                ProgressLine& progress, Workers* workers) {
    using Clock = std::chrono::steady_clock;
    CheckedCase& item = run.list.cases[number];
    const auto& chart = run.list.files[item.file].chart;
    if (chart) {
        const MessageRecord messages(MessageRecord::Kind::held);
        const CheckArguments request = run.request_for(number);
        const Clock::time_point began = Clock::now();
        Judged judged = judge({request, run.line, *chart, values, workers, progress,
                               std::filesystem::path(request.path).filename().string() + " " +
                                   run.plan[number].style});
        item.seconds = std::chrono::duration<double>(Clock::now() - began).count();
        item.judgement = std::move(judged.judgement);
        item.is_skipped = judged.is_unsuitable && run.request.styles == "all";
        item.text = messages.text();
        item.messages = messages.messages();
    }
    progress.count_done();
}

void make_checks(CheckRun& run, const CheckValues& values) {
    {
        const Interruption interruption;
        ProgressLine progress(run.line.language(), run.plan.size());
        WorkerPool pool(run.request.jobs);
        // The bound is for the memory of the program, in which checks would take it from each
        // other; and few checks leave cores idle unless these share the work within each.
        if (values.max_memory != 0 || run.plan.size() < pool.count()) {
            for (std::size_t i = 0; i < run.plan.size(); ++i) {
                make_check(run, i, values, progress, &pool);
            }
        } else {
            const auto work = [&](std::size_t number, std::size_t) {
                make_check(run, number, values, progress, nullptr);
            };
            pool.share(run.plan.size(), work, [] {});
        }
    }
    // Of a shard the other styles may be with others.
    if (run.request.shard.empty()) {
        for (const std::size_t file : refuse_skipped_files(run.list)) {
            complain(messages::workflow::no_style_holds(visible(run.charts.files[file].path)));
        }
    }
    for (const CheckedCase& item : run.list.cases) {
        if (!item.is_skipped) show(item.text);
    }
}

/// Where the request itself is wrong, that is why none of the checks is made.
void refuse_all(CheckRun& run, const MessageRecord& messages) {
    run.is_refused = true;
    for (CheckedCase& item : run.list.cases) {
        item.text = messages.text();
        item.messages = messages.messages();
    }
}

/// Reads what is asked for, and makes all checks that can be made.
void check_all(CheckRun& run) {
    std::optional<CheckValues> values;
    {
        const MessageRecord messages;
        if (refuse_idle_options(run.line, "check", facts_of(run))) {
            refuse_all(run, messages);
            return;
        }
    }
    load_files(run);
    {
        const MessageRecord messages;
        values = values_of(run.request);
        if (!values) refuse_all(run, messages);
    }
    if (values) make_checks(run, *values);
}

// Results.

/// No answer within the bounds is neither yes nor no; that a style cannot hold a chart, where all
/// styles are tried, is no failure.
ExitStatus exit_status(CheckOutcome outcome) {
    switch (outcome) {
        case CheckOutcome::equivalent:
        case CheckOutcome::skipped:
            return ExitStatus::done;
        case CheckOutcome::different:
            return ExitStatus::answer_is_no;
        case CheckOutcome::undecided:
            return ExitStatus::out_of_bounds;
        case CheckOutcome::error:
            break;
    }
    return ExitStatus::bad_request;
}

ExitStatus exit_status(const CheckList& list) {
    ExitStatus status = ExitStatus::done;
    for (const CheckedCase& item : list.cases) {
        status = worse_of(status, exit_status(item.outcome()));
    }
    return status;
}

/// Adds the files to their folder, and says where they will stand; those of an earlier difference
/// go, so that what is there always belongs to the last verdict.
std::vector<std::string> add_witness(OutputFiles& files, const std::string& folder,
                                     const std::vector<NamedText>& witness_files) {
    std::vector<std::string> paths;
    if (!witness_files.empty()) files.add_folder(folder);
    for (const std::string_view name : witness_file_names) {
        const std::string path = (std::filesystem::path(folder) / name).string();
        const auto file = std::find_if(witness_files.begin(), witness_files.end(),
                                       [&](const NamedText& item) { return item.name == name; });
        if (file == witness_files.end()) {
            files.remove(path);
        } else {
            files.add(path, file->text);
            paths.push_back(path);
        }
    }
    return paths;
}

/// The folder of the witness of a check: of several, one each in that asked for, called after chart
/// and style.
std::string witness_folder(const CheckRun& run, std::size_t number) {
    if (!run.are_several) return run.request.witness;
    const PlannedCheck& check = run.plan[number];
    const std::string chart = name_for(run.charts.files[check.file]);
    const std::string name = check.style.empty() ? chart : chart + "-" + check.style;
    return (std::filesystem::path(run.request.witness) / name).string();
}

/// The report, where there is one: of a wrong request, and of a single check that was not made,
/// only JUnit and SARIF tell.
std::optional<std::string> report_of(const CheckRun& run) {
    const ReportRow& form = *row_named(report_forms(), run.request.format);
    if (form.tells_errors) return form.write_several(run.list, run.line.language());
    if (run.is_refused) return std::nullopt;
    if (run.are_several) return form.write_several(run.list, run.line.language());
    const CheckedCase& only = run.list.cases.front();
    if (!only.judgement) return std::nullopt;
    return form.write(*only.judgement, *run.list.files.front().chart, only.seconds,
                      run.line.language());
}

/// Writes the report, and the files of witnesses where they are asked for.
ExitStatus report(CheckRun& run) {
    std::vector<std::string> inputs = run.charts.paths();
    inputs.insert(inputs.end(), {run.request.against, run.request.io});
    OutputFiles files(std::move(inputs));
    for (std::size_t i = 0; !run.request.witness.empty() && i < run.plan.size(); ++i) {
        auto& judgement = run.list.cases[i].judgement;
        if (!judgement) continue;
        judgement->subject.witness_files =
            add_witness(files, witness_folder(run, i), judgement->witness_files);
    }
    if (auto text = report_of(run)) files.add(run.request.output, std::move(*text));
    return finish(files, exit_status(run.list));
}

ExitStatus check(const CheckArguments& request, const CommandLine& line) {
    CheckRun run = planned(request, line);
    if (!request.witness.empty() && run.are_several && !have_names_of_their_own(run.charts)) {
        return ExitStatus::bad_request;
    }
    check_all(run);
    const ExitStatus status = report(run);
    if (run.are_several && !run.is_refused) show(outcome_table(run.list));
    return status;
}

/// What is compared, and under which conditions.
void declare_subject(const CommandLine& line, CheckArguments& request) {
    line.add_arguments(help::file_name, request.files, help::files()).names_file({".grafcet"});
    std::vector<std::string_view> styles;
    for (const StyleRow& row : style_table) styles.push_back(row.name);
    styles.push_back("all");
    line.add("--style", request.styles, with_rows(help::check_style(), style_table))
        .one_that([](std::string_view words) { return !styles_in(words).empty(); }, styles)
        .shows_default();
    request.netlist.declare_equations(line);
    request.netlist.declare_delay(line);
    line.add("--against", request.against, help::check_against())
        .names_file({".blif", ".json", ".awl", ".xml"});
    line.add("--program", request.program, help::check_program());
    line.add("--io", request.io, help::check_io()).names_file({".io"});
    line.add("--changes", request.changes, help::changes()).one_of({"one", "many"});
    line.add("--power-up", request.power_up, help::power_up()).one_of({"unknown", "initial"});
    line.add("--scan", request.scan, help::check_scan());
    line.add("--cpu", request.cpu, help::check_cpu()).one_of(cpu_numbers()).shows_default();
}

/// What is written, and when the check gives up.
void declare_results(const CommandLine& line, CheckArguments& request) {
    line.add("--to", request.format, help::check_to()).one_of_names(report_forms()).shows_default();
    line.add("-o", request.output, help::check_output()).names_file({});
    line.add("--witness", request.witness, help::witness()).names_folder();
    line.add_flag("--tolerance", request.tolerance, help::tolerance());
    line.add_flag("--pulses", request.pulses, help::pulses());
    line.add("--assume", request.assumptions, help::assume());
    line.add_strict();
    line.add("--shard", request.shard, help::shard())
        .one_that([](std::string_view text) { return parse_shard(text).has_value(); }, {"K/N"});
    line.add("-j", request.jobs, help::jobs());
    line.add("--max-cases", request.max_cases, help::max_cases());
    line.add("--max-seconds", request.max_seconds, help::max_seconds());
    line.add("--max-memory", request.max_memory, help::max_memory());
}

}  // namespace

Task declare_check(const CommandLine& line) {
    const auto request = std::make_shared<CheckArguments>();
    declare_subject(line, *request);
    declare_results(line, *request);
    return [request, line] { return check(*request, line); };
}

}  // namespace grafwire
