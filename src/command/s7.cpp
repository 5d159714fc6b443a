#include <fmt/format.h>

#include <vector>

#include "command/command.h"
#include "command/exit_status.h"
#include "command/inputs.h"
#include "command/trace_output.h"
#include "s7/machine/binding.h"
#include "s7/machine/machine.h"
#include "s7/machine/run_listing.h"
#include "s7/parse_listing.h"

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

/// The GRAFCET that gives the columns, and where the listing keeps what they show.
struct Named {
    Grafcet grafcet;
    s7::Binding binding;
};

std::optional<Named> name_columns(const Request& request, const s7::Listing& listing,
                                  const std::optional<LoadedAssignment>& io) {
    Named named;
    s7::IoAssignment assignment = io ? io->assignment : s7::addresses_of(listing);
    if (request.grafcet.empty()) {
        named.grafcet = s7::names_of(assignment);
        // What is no column needs no address.
        std::erase_if(assignment.entries,
                      [&](const s7::IoAssignment::Entry& entry) { return !s7::is_shown(entry); });
    } else {
        auto loaded = load_grafcet(request.grafcet);
        if (!loaded) return std::nullopt;
        named.grafcet = std::move(loaded->grafcet);
    }
    auto binding = bind_listing(named.grafcet, assignment, io ? io->source : SourceFile());
    if (!binding) return std::nullopt;
    named.binding = std::move(*binding);
    return named;
}

/// Control inputs that the stimuli set and the listing does not have.
void warn_of_lost_inputs(const Named& named, const Stimuli& stimuli) {
    std::vector<bool> is_told(named.binding.inputs.size(), false);
    for (const Stimuli::Change& change : stimuli.changes) {
        for (const Stimuli::Assignment& set : change.assignments) {
            if (named.binding.inputs[set.input] || is_told[set.input]) continue;
            is_told[set.input] = true;
            warn(fmt::format("the listing has no input {}: what the stimuli say of it is left out",
                             input_name(named.grafcet, set.input)));
        }
    }
}

int run_listing(const Request& request) {
    if (!request.grafcet.empty() && request.io.empty()) {
        complain("--grafcet needs --io: the table that says which address is which step");
        return bad_request;
    }
    // Read the listing, the table of assignment, and the stimuli.
    std::optional<LoadedAssignment> io;
    if (!request.io.empty()) {
        io = load_assignment(request.io);
        if (!io) return bad_request;
    }
    const auto listing = load_listing(request.listing, request.cpu, io ? &io->assignment : nullptr);
    if (!listing) return bad_request;
    const auto named = name_columns(request, *listing, io);
    if (!named) return bad_request;
    const auto stimuli = load_stimuli(request.stimuli, named->grafcet);
    if (!stimuli) return bad_request;
    const auto period = parse_period(request.scan);
    if (!period) return bad_request;
    warn_of_lost_inputs(*named, *stimuli);
    // Execute it, scan by scan.
    s7::Machine machine(*listing, cpu_named(request.cpu));
    const s7::ListingRun run =
        s7::run_listing(machine, named->grafcet, named->binding, *stimuli, *period);
    if (run.failure) {
        complain(fmt::format("at {} ms, network {}, line {}: {}",
                             format_milliseconds(run.failure->at), run.failure->error.network,
                             run.failure->error.where.line, run.failure->error.message));
        return bad_request;
    }
    OutputFiles files({request.listing, request.stimuli, request.io, request.grafcet});
    request.output.add_files(files, run.trace, write_vcd(run.trace, "listing"));
    return finish(files, done);
}

}  // namespace

std::function<int()> declare_s7(const CommandLine& line, const Language&) {
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
        .one_of({"212", "214"})
        .shows_default();
    run.add("--grafcet", request->grafcet,
            "the GRAFCET whose columns the trace shall have; needs --io");
    request->output.declare(run);
    return [request] { return run_listing(*request); };
}

}  // namespace grafwire
