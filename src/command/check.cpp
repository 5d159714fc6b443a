// grafwire check: what is compared (a netlist made or read, a listing, a ladder diagram), with
// which bounds, and where the report and the files of a witness go. The exit status is the verdict.
// A report in JUnit's form is written even where no check is made, since CI shows nothing else.

#include "workflow/check.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <new>

#include "command/command_line.h"
#include "command/help.h"
#include "command/inputs.h"
#include "command/messages.h"
#include "command/option_uses.h"
#include "command/progress.h"
#include "command/worker_pool.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

namespace say = messages::command;
namespace help = messages::help;

/// What may be written after `grafwire check`.
struct CheckArguments {
    std::string path;
    NetlistRequest netlist;
    std::string against;
    std::string program;
    std::string io;
    std::string cpu = "214";
    std::string scan;
    std::string changes;   ///< empty: one
    std::string power_up;  ///< empty: unknown
    std::string format = "text";
    std::string witness;
    bool tolerance = false;
    std::vector<std::string> assumptions;
    std::uint64_t jobs = 0;  ///< 0: as many as there are cores
    std::uint64_t max_cases = 0;
    double max_seconds = 0;
    std::string max_memory;  ///< empty: no bound
    std::string output;
};

/// All that a check works with besides what is compared.
struct Session {
    const CheckArguments& request;
    const CommandLine& line;
    const Chart& chart;
    Language language;
    std::uint64_t max_memory = 0;  ///< in bytes; 0: no bound
    std::optional<Time> period;
};

/// No answer within the bounds is neither yes nor no.
ExitStatus exit_status(Verdict verdict) {
    switch (verdict) {
        case Verdict::equivalent:
            return ExitStatus::done;
        case Verdict::different:
            return ExitStatus::answer_is_no;
        case Verdict::undecided:
            return ExitStatus::out_of_bounds;
    }
    return ExitStatus::bad_request;
}

/// What is known of the request before anything is read.
unsigned facts_of(const CheckArguments& request) {
    if (request.against.empty()) {
        return fact::generated |
               (request.netlist.options().style == Style::clocked ? fact::clocked
                                                                  : fact::asynchronous);
    }
    const std::optional<Against> against = against_of(request.against);
    if (against == Against::listing) return fact::listing;
    if (against == Against::ladder) return fact::ladder;
    return fact::elsewhere | fact::open_start | fact::asynchronous | fact::clocked;
}

/// What is known of a netlist from elsewhere once it is there.
unsigned facts_of(const Chart& chart, const Netlist& netlist) {
    unsigned facts = fact::elsewhere;
    facts |= netlist.is_clocked() ? fact::clocked : fact::asynchronous;
    if (power_up_of(chart, netlist, true) != PowerUp::init) facts |= fact::open_start;
    return facts;
}

/// What the reports say of a request before anything has been read.
CheckSubject subject_of(const CheckArguments& request) {
    CheckSubject subject;
    subject.file = request.path;
    subject.against = request.against;
    if (request.against.empty()) {
        subject.style = request.netlist.style;
        subject.cdx = name_of(cdx_form(request.netlist.options()));
    }
    subject.delays = request.netlist.delays();
    subject.name = request.against.empty() ? subject.style + " " + subject.cdx : request.against;
    for (const std::string* asked : {&request.changes, &request.power_up, &request.scan}) {
        if (!asked->empty()) subject.name += " " + *asked;
    }
    return subject;
}

/// Runs a check within its bounds, and shows what it has to say.
template <typename Check>
std::optional<Judgement> within_bounds(const Session& session, const Check& check) {
    const CheckArguments& request = session.request;
    CheckRequest asked;
    asked.subject = subject_of(request);
    asked.changes = request.changes == "many" ? Changes::many : Changes::one;
    asked.period = session.period;
    asked.max_cases = request.max_cases;
    WorkerPool workers(request.jobs);
    asked.workers = &workers;
    asked.language = session.language;
    asked.with_files = !request.witness.empty();
    Diagnostics messages;
    std::optional<Judgement> judgement;
    {
        Progress progress(request.max_seconds, session.max_memory, session.language);
        asked.progress = [&progress](const Coverage& coverage) { progress.show(coverage); };
        asked.keep_going = [&progress] { return progress.goes_on(); };
        judgement = check(asked, messages);
    }
    show_messages(messages);
    return judgement;
}

/// A netlist from elsewhere, if its ports allow a comparison.
std::optional<Netlist> load_fitting_netlist(const Session& session) {
    const CheckArguments& request = session.request;
    auto netlist = load_netlist(request.against);
    if (!netlist) return std::nullopt;
    const PortComparison ports =
        fit_netlist(session.chart, *netlist, request.power_up == "initial");
    if (!ports.fits()) {
        show(say::ports_do_not_fit(visible(request.against), visible(request.path),
                                   port_table(ports)));
    }
    if (!ports.can_compare()) return std::nullopt;
    if (refuse_idle_options(session.line, "check", facts_of(session.chart, *netlist))) {
        return std::nullopt;
    }
    return netlist;
}

/// What is compared under other delays: the netlist that is made for them, or the one from
/// elsewhere as it is.
NetlistFor netlist_by_delays(const Session& session, const Netlist& netlist) {
    if (!session.request.against.empty()) {
        return [&netlist](const DelayModel&) { return std::optional(netlist); };
    }
    return [&session](const DelayModel& delays) {
        NetlistOptions options = session.request.netlist.options();
        options.delays = delays;
        Diagnostics said_before;
        return make_netlist(session.chart, options, said_before);
    };
}

/// A netlist that is made of the GRAFCET, or one from elsewhere.
std::optional<Judgement> judge_netlist(const Session& session) {
    const auto netlist = session.request.against.empty()
                             ? make_netlist(session.chart, session.request.netlist)
                             : load_fitting_netlist(session);
    if (!netlist) return std::nullopt;
    return within_bounds(session, [&](CheckRequest asked, Diagnostics& messages) {
        if (session.request.tolerance) asked.tolerance_of = netlist_by_delays(session, *netlist);
        return check_netlist(session.chart, *netlist, asked, messages);
    });
}

/// An S7-200 listing. Its addresses say nothing by themselves, so a table of assignment is needed.
std::optional<Judgement> judge_listing(const Session& session) {
    const CheckArguments& request = session.request;
    if (request.io.empty()) {
        complain(say::listing_needs_io(request.against));
        return std::nullopt;
    }
    const auto io = load_assignment(request.io);
    if (!io) return std::nullopt;
    const s7::Cpu cpu = cpu_of_number(request.cpu).value_or(s7::Cpu::cpu_214);
    const auto listing = load_listing(request.against, cpu, &io->assignment);
    if (!listing) return std::nullopt;
    Diagnostics diagnostics;
    const auto binding = s7::bind(session.chart.grafcet, io->assignment, diagnostics);
    show_diagnostics(diagnostics, io->source);
    if (!binding) return std::nullopt;
    return within_bounds(session, [&](const CheckRequest& asked, Diagnostics& messages) {
        return check_listing(session.chart, *listing, cpu, *binding, asked, messages);
    });
}

/// A ladder diagram, whose variables have the names of the GRAFCET.
std::optional<Judgement> judge_ladder(const Session& session) {
    const CheckArguments& request = session.request;
    Diagnostics diagnostics;
    const SourceFile source = read_source(request.against, diagnostics);
    std::optional<ladder::Ladder> ladder;
    if (!diagnostics.has_errors()) ladder = read_ladder(source, request.program, diagnostics);
    show_diagnostics(diagnostics, source);
    if (!ladder) return std::nullopt;
    return within_bounds(session, [&](const CheckRequest& asked, Diagnostics& messages) {
        return check_ladder(session.chart, *ladder, asked, messages);
    });
}

/// Compares what is asked for with the chart; empty, with the reason shown, where that is not
/// possible.
std::optional<Judgement> judge(const Session& session) {
    const unsigned facts = facts_of(session.request);
    if ((facts & fact::listing) != 0) return judge_listing(session);
    if ((facts & fact::ladder) != 0) return judge_ladder(session);
    return judge_netlist(session);
}

/// The GRAFCET, with all that the plant never does.
std::optional<Chart> load_plant(const CheckArguments& request) {
    auto chart = load_chart(request.path);
    if (!chart) return std::nullopt;
    bool is_good = true;
    for (const std::string& text : request.assumptions) {
        Diagnostics diagnostics;
        const SourceFile source{"--assume", text};
        is_good = add_assumption(source, *chart, diagnostics) && is_good;
        show_diagnostics(diagnostics, source);
    }
    if (!is_good) return std::nullopt;
    return chart;
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

/// Writes the report, and the files of the witness into the folder asked for, if one is, where
/// those of an earlier witness go. `seconds`: what the check took.
ExitStatus report(const CheckArguments& request, const Chart& chart, Judgement& judgement,
                  double seconds, Language language) {
    OutputFiles files({request.path, request.against, request.io});
    if (!request.witness.empty()) {
        judgement.subject.witness_files =
            add_witness(files, request.witness, judgement.witness_files);
    }
    const ReportRow* form = row_named(report_forms(), request.format);
    files.add(request.output, form->write(judgement, chart, seconds, language));
    return finish(files, exit_status(judgement.result.verdict));
}

/// Where no check could be made for the reasons that the messages say: a JUnit report, if one is
/// asked for, has them too: the reader of these reports may see nothing else.
ExitStatus report_refused(const CheckArguments& request, const std::string& messages,
                          double seconds) {
    if (request.format != "junit") return ExitStatus::bad_request;
    OutputFiles files({request.path, request.against, request.io});
    files.add(request.output, write_refused_junit(subject_of(request), messages, seconds));
    return finish(files, ExitStatus::bad_request);
}

/// Whatever goes wrong before the verdict ends in `refused`, so that CI sees a report of it.
ExitStatus check(const CheckArguments& request, const CommandLine& line) {
    const auto began = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    };
    const MessageRecord messages;
    const auto refused = [&] { return report_refused(request, messages.text(), seconds()); };
    // Read the request and the GRAFCET.
    if (refuse_idle_options(line, "check", facts_of(request))) return refused();
    const auto chart = load_plant(request);
    if (!chart) return refused();
    Session session{request, line, *chart, line.language(), 0, {}};
    if (!request.max_memory.empty()) {
        const auto bytes = parse_memory(request.max_memory);
        if (!bytes) return refused();
        session.max_memory = *bytes;
    }
    const Period period = parse_period(request.scan);
    if (period.is_wrong) return refused();
    session.period = period.value;
    // Judge what is to be compared with it, and report.
    std::optional<Judgement> judgement;
    try {
        judgement = judge(session);
    } catch (const std::bad_alloc&) {
        complain(say::check_takes_too_much_memory());
    }
    if (!judgement) return refused();
    return report(request, *chart, *judgement, seconds(), line.language());
}

/// What is compared, and under which conditions.
void declare_subject(const CommandLine& line, CheckArguments& request) {
    line.add_argument(help::file_name, request.path, help::file());
    request.netlist.declare(line, false);
    request.netlist.declare_delay(line);
    line.add("--against", request.against, help::check_against());
    line.add("--program", request.program, help::check_program());
    line.add("--io", request.io, help::check_io());
    line.add("--changes", request.changes, help::changes()).one_of({"one", "many"});
    line.add("--power-up", request.power_up, help::power_up()).one_of({"unknown", "initial"});
    line.add("--scan", request.scan, help::check_scan());
    line.add("--cpu", request.cpu, help::check_cpu()).one_of(cpu_numbers()).shows_default();
}

/// What is written, and when the check gives up.
void declare_report(const CommandLine& line, CheckArguments& request) {
    line.add("--to", request.format, help::check_to()).one_of_names(report_forms()).shows_default();
    line.add("-o", request.output, help::check_output());
    line.add("--witness", request.witness, help::witness());
    line.add_flag("--tolerance", request.tolerance, help::tolerance());
    line.add("--assume", request.assumptions, help::assume());
    line.add("-j", request.jobs, help::jobs());
    line.add("--max-cases", request.max_cases, help::max_cases());
    line.add("--max-seconds", request.max_seconds, help::max_seconds());
    line.add("--max-memory", request.max_memory, help::max_memory());
}

}  // namespace

Task declare_check(const CommandLine& line) {
    const auto request = std::make_shared<CheckArguments>();
    declare_subject(line, *request);
    declare_report(line, *request);
    return [request, line] { return check(*request, line); };
}

}  // namespace grafwire
