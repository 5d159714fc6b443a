// grafwire s7 run: an S7-200 listing executed scan by scan. Its columns are those of a GRAFCET, if
// one is given, so that the trace can be compared with that of grafwire run.

#include "command/command_line.h"
#include "command/help.h"
#include "command/inputs.h"
#include "command/messages.h"
#include "command/terminal.h"
#include "s7/machine/machine.h"
#include "workflow/runs.h"

namespace grafwire {

namespace {

namespace say = messages::command;
namespace help = messages::help;

/// What may be written after `grafwire s7 run`.
struct S7Arguments {
    std::string listing;
    std::string stimuli;
    std::string scan;
    std::string io;
    std::string cpu = "214";
    std::string grafcet;
    TraceOutput output;
};

/// The names of the columns, with messages shown.
std::optional<ListingColumns> load_columns(const S7Arguments& request, const s7::Listing& listing,
                                           const std::optional<LoadedAssignment>& io) {
    std::optional<Chart> chart;
    if (!request.grafcet.empty()) {
        chart = load_chart(request.grafcet);
        if (!chart) return std::nullopt;
    }
    Diagnostics diagnostics;
    auto columns =
        columns_of(listing, io ? &io->assignment : nullptr, chart ? &*chart : nullptr, diagnostics);
    show_diagnostics(diagnostics, io ? io->source : SourceFile());
    return columns;
}

/// A listing that fails (a stack too deep, a timer of no such number) fails at a place and a
/// moment, and both are shown.
ExitStatus run_listing(const S7Arguments& request, Language language) {
    if (!request.grafcet.empty() && request.io.empty()) {
        complain(say::grafcet_needs_io());
        return ExitStatus::bad_request;
    }
    if (request.output.is_refused()) return ExitStatus::bad_request;
    // Read the listing, the table of assignment, and the stimuli.
    std::optional<LoadedAssignment> io;
    if (!request.io.empty()) {
        io = load_assignment(request.io);
        if (!io) return ExitStatus::bad_request;
    }
    const s7::Cpu cpu = cpu_of_number(request.cpu).value_or(s7::Cpu::cpu_214);
    const auto listing = load_listing(request.listing, cpu, io ? &io->assignment : nullptr);
    if (!listing) return ExitStatus::bad_request;
    const auto columns = load_columns(request, *listing, io);
    if (!columns) return ExitStatus::bad_request;
    const auto stimuli = load_stimuli(request.stimuli, columns->grafcet);
    if (!stimuli) return ExitStatus::bad_request;
    const Period period = parse_period(request.scan);
    if (!period.value || has_too_many_scans(columns->grafcet, *stimuli, period)) {
        return ExitStatus::bad_request;
    }
    for (const std::string& name : lost_inputs(*columns, *stimuli)) {
        warn(say::listing_has_no_input(name));
    }
    // Execute it, scan by scan.
    s7::Machine machine(*listing, cpu);
    const s7::ListingRun run =
        s7::run_listing(machine, columns->grafcet, columns->binding, *stimuli, *period.value);
    if (run.failure) {
        complain(say::listing_failed(format_milliseconds(run.failure->at),
                                     run.failure->error.network, run.failure->error.where.line,
                                     run.failure->error.message));
        return ExitStatus::bad_request;
    }
    OutputFiles files({request.listing, request.stimuli, request.io, request.grafcet});
    if (!request.output.add_files(
            files, trace_text(run.trace, columns->grafcet, request.output.csv, language),
            waveform_of(run.trace, "listing"))) {
        return ExitStatus::bad_request;
    }
    return finish(files, ExitStatus::done);
}

}  // namespace

Task declare_s7(const CommandLine& line) {
    const auto request = std::make_shared<S7Arguments>();
    const CommandLine run = line.add_command(
        "run", help::s7_run(),
        "grafwire s7 run examples/s7-200/manipulator.awl --stim examples/manipulator.stim "
        "--scan 10ms --io examples/s7-200/manipulator.io");
    run.add_argument(help::listing_name, request->listing, help::listing()).names_file({".awl"});
    run.add("--stim", request->stimuli, help::s7_stim()).names_file({".stim"}).required();
    run.add("--scan", request->scan, help::s7_scan()).required();
    run.add("--io", request->io, help::s7_io()).names_file({".io"});
    run.add("--cpu", request->cpu, help::s7_cpu()).one_of(cpu_numbers()).shows_default();
    run.add("--grafcet", request->grafcet, help::s7_grafcet()).names_file({".grafcet"});
    request->output.declare(run);
    return [request, language = line.language()] { return run_listing(*request, language); };
}

}  // namespace grafwire
