#include "evolution/run.h"

#include <fmt/format.h>

#include "command/command.h"
#include "command/exit_status.h"
#include "command/inputs.h"
#include "command/trace_output.h"

namespace grafwire {

namespace {

struct Request {
    std::string path;
    std::string stimuli;
    std::string scan;
    TraceOutput output;
};

}  // namespace

std::function<int()> declare_run(const CommandLine& line, const Language& language) {
    const auto request = std::make_shared<Request>();
    line.add("FILE", request->path, "the GRAFCET, - for standard input").required();
    line.add("STIM", request->stimuli, "the stimuli (.stim), - for standard input").required();
    line.add("--scan", request->scan,
             "scan by scan with this period (default: until stable at every instant)");
    request->output.declare(line);
    return [request, &language] {
        // Read the GRAFCET and the stimuli.
        if (share_standard_input(request->path, request->stimuli)) {
            return static_cast<int>(bad_request);
        }
        const auto loaded = load_grafcet(request->path);
        if (!loaded) return static_cast<int>(bad_request);
        const auto stimuli = load_stimuli(request->stimuli, loaded->grafcet);
        if (!stimuli) return static_cast<int>(bad_request);
        Time period = 0;
        if (!request->scan.empty()) {
            const auto parsed = parse_period(request->scan);
            if (!parsed) return static_cast<int>(bad_request);
            period = *parsed;
        }
        // Let the reference evolve.
        const RunResult result = period == 0 ? run_until_stable(loaded->grafcet, *stimuli)
                                             : run_scans(loaded->grafcet, *stimuli, period);
        warn_of_broken_assumptions(loaded->grafcet, result.broken_assumptions);
        // Write the trace, up to the instant without a stable situation if there is one.
        if (result.unstable_at) {
            complain(fmt::format(
                fmt::runtime(language == Language::french
                                 ? "pas de situation stable à {} ms ; changent sans cesse : {}"
                                 : "no stable situation at {} ms; these keep changing: {}"),
                format_milliseconds(*result.unstable_at), fmt::join(result.changing, ", ")));
        }
        OutputFiles files({request->path, request->stimuli});
        request->output.add_files(files, result.trace,
                                  write_vcd(result.trace, loaded->grafcet.name));
        return finish(files, result.unstable_at ? answer_is_no : done);
    };
}

}  // namespace grafwire
