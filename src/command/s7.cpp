#include <fmt/format.h>

#include "command/command.h"
#include "command/inputs.h"
#include "s7/machine/machine.h"
#include "workflow/runs.h"

namespace grafwire {

namespace {

struct Request {
    std::string listing;
    std::string stimuli;
    std::string scan;
    std::string io;
    std::string cpu = "214";
    std::string grafcet;
    TraceOutput output;
};

/// The names of the columns, with messages shown.
std::optional<ListingColumns> load_columns(const Request& request, const s7::Listing& listing,
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

ExitStatus run_listing(const Request& request) {
    if (!request.grafcet.empty() && request.io.empty()) {
        complain("--grafcet needs --io: the table that says which address is which step");
        return ExitStatus::bad_request;
    }
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
    if (!period.value) return ExitStatus::bad_request;
    for (const std::string& name : lost_inputs(*columns, *stimuli)) {
        warn(fmt::format("the listing has no input {}: what the stimuli say of it is left out",
                         name));
    }
    // Execute it, scan by scan.
    s7::Machine machine(*listing, cpu);
    const s7::ListingRun run =
        s7::run_listing(machine, columns->grafcet, columns->binding, *stimuli, *period.value);
    if (run.failure) {
        complain(fmt::format("at {} ms, network {}, line {}: {}",
                             format_milliseconds(run.failure->at), run.failure->error.network,
                             run.failure->error.where.line, run.failure->error.message));
        return ExitStatus::bad_request;
    }
    OutputFiles files({request.listing, request.stimuli, request.io, request.grafcet});
    request.output.add_files(files, write_csv(run.trace), write_vcd(run.trace, "listing"));
    return finish(files, ExitStatus::done);
}

}  // namespace

Task declare_s7(const CommandLine& line, const Language&) {
    const auto request = std::make_shared<Request>();
    const CommandLine run = line.add_command(
        "run", "execute a listing over stimuli, scan by scan",
        "grafwire s7 run examples/s7-200/manipulator.awl --stim examples/manipulator.stim "
        "--scan 10ms --io examples/s7-200/manipulator.io");
    run.add("LISTING", request->listing, "the instruction list (.awl), - for standard input")
        .required();
    run.add("--stim", request->stimuli, "the stimuli (.stim)").required();
    run.add("--scan", request->scan, "the time from one scan to the next, such as 10ms").required();
    run.add("--io", request->io,
            "table of assignment: which address stands for which name (default: names are "
            "the addresses)");
    run.add("--cpu", request->cpu, "the controller: 212 or 214")
        .one_of(cpu_numbers())
        .shows_default();
    run.add("--grafcet", request->grafcet,
            "the GRAFCET whose columns the trace shall have; needs --io");
    request->output.declare(run);
    return [request] { return run_listing(*request); };
}

}  // namespace grafwire
