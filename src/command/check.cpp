#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>

#include "check/check_equivalence.h"
#include "check/compare_ports.h"
#include "check/netlist_witness.h"
#include "check/report.h"
#include "command/command.h"
#include "evolution/run.h"
#include "grafcet/parse_grafcet.h"
#include "simulate/simulate.h"

namespace grafwire {

namespace {

using Clock = std::chrono::steady_clock;

struct Request {
    std::string path;
    NetlistRequest netlist;
    std::string against;
    std::string delay = "unit";
    std::string format = "text";
    std::string witness;
    std::vector<std::string> assumptions;
    std::uint64_t max_cases = 0;
    double max_seconds = 0;
    std::string output;
};

/// Shows how far the exploration is, on a terminal, once it takes more than a moment; and ends it
/// when its time is up.
class Progress {
  public:
    explicit Progress(double max_seconds)
        : max_seconds_(max_seconds), is_terminal_(isatty(STDERR_FILENO) == 1) {}
    ~Progress() {
        if (shown_) fmt::print(stderr, "\r\033[K");
    }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    bool goes_on(const Coverage& coverage) {
        const double elapsed = std::chrono::duration<double>(Clock::now() - begin_).count();
        if (is_terminal_ && elapsed > next_) {
            fmt::print(stderr, "\r\033[K{} cases, {} situations, {} states waiting", coverage.cases,
                       coverage.situations, coverage.waiting);
            shown_ = true;
            next_ = elapsed + 0.5;
        }
        return max_seconds_ == 0 || elapsed < max_seconds_;
    }

  private:
    Clock::time_point begin_ = Clock::now();
    double max_seconds_;
    double next_ = 1.0;
    bool is_terminal_;
    bool shown_ = false;
};

bool add_assumptions(const std::vector<std::string>& texts, Grafcet& grafcet) {
    bool good = true;
    for (const std::string& text : texts) {
        Diagnostics diagnostics;
        const SourceFile source{"--assume", text};
        parse_assumption(source, grafcet, diagnostics);
        std::fputs(format_diagnostics(diagnostics, source).c_str(), stderr);
        good = good && !diagnostics.has_errors();
    }
    return good;
}

/// A netlist from elsewhere, if its ports allow a comparison.
std::optional<Netlist> netlist_to_compare(const Request& request, const LoadedGrafcet& loaded,
                                          Language language) {
    if (request.against.empty()) return make_netlist(loaded, request.netlist);
    auto netlist = load_netlist(request.against);
    if (!netlist) return std::nullopt;
    const PortComparison ports = compare_ports(loaded.grafcet, *netlist);
    if (!ports.fits()) {
        fmt::print(stderr, "{}: the ports do not fit {}:\n{}", request.against, request.path,
                   write_port_table(ports, language));
    }
    if (!ports.can_compare()) return std::nullopt;
    adopt_ports(loaded.grafcet, *netlist);
    return netlist;
}

/// The files that show a witness: stimuli, what reference and netlist make of them, the story.
std::vector<std::string> add_witness_files(const std::string& folder, const Grafcet& grafcet,
                                           const Netlist& netlist, const CellDelays& delays,
                                           const Witness& witness, const std::string& story,
                                           OutputFiles& files) {
    const Stimuli& stimuli = witness.stimuli;
    const RunResult run = witness.scan_period == 0
                              ? run_until_stable(grafcet, stimuli)
                              : run_scans(grafcet, stimuli, witness.scan_period);
    SimulateOptions options;
    options.waveform = true;
    options.scan_period = witness.scan_period;
    const SimulateResult simulated = simulate(grafcet, netlist, delays, stimuli, options);
    std::vector<std::string> names;
    const auto add = [&](std::string_view name, std::string text) {
        names.push_back((std::filesystem::path(folder) / name).string());
        files.add(names.back(), std::move(text));
    };
    add("witness.stim", write_stimuli(stimuli, grafcet));
    add("witness.txt", story);
    add("expected.csv", write_csv(run.trace));
    add("expected.vcd", write_vcd(run.trace, grafcet.name));
    add("got.csv", write_csv(simulated.trace));
    add("got.vcd", simulated.waveform);
    return names;
}

int exit_status(Verdict verdict) {
    switch (verdict) {
        case Verdict::equivalent:
            return done;
        case Verdict::different:
            return answer_is_no;
        case Verdict::undecided:
            return out_of_bounds;
    }
    return bad_request;
}

int report(const Request& request, const LoadedGrafcet& loaded, const Netlist& netlist,
           const CellDelays& delays, const CheckResult& result, Language language) {
    CheckSubject subject = netlist_subject(
        request.path, request.against.empty() ? request.netlist.style : request.against,
        std::string(request.netlist.cdx_name()), request.delay);
    OutputFiles files;
    std::string story;
    if (result.witness) {
        story = tell_witness(loaded.grafcet, netlist, delays, *result.witness, language);
        if (!request.witness.empty()) {
            std::error_code error;
            std::filesystem::create_directories(request.witness, error);
            subject.witness_files = add_witness_files(request.witness, loaded.grafcet, netlist,
                                                      delays, *result.witness, story, files);
        }
    }
    if (request.format == "json") {
        files.add(request.output, write_check_json(subject, loaded.grafcet, result));
    } else if (request.format == "junit") {
        files.add(request.output, write_check_junit(subject, loaded.grafcet, result, story));
    } else {
        files.add(request.output,
                  write_check_text(subject, loaded.grafcet, result, story, language));
    }
    return finish(files, exit_status(result.verdict));
}

void declare_options(CLI::App& app, Request& request) {
    app.add_option("FILE", request.path, "the GRAFCET, - for standard input")->required();
    request.netlist.declare(app, false);
    app.add_option("--delay", request.delay, "delay of every gate: unit (1 ns)")
        ->check(CLI::IsMember({"unit"}))
        ->capture_default_str();
    app.add_option("--against", request.against,
                   "compare this .blif or .json (Yosys) netlist instead of a generated one");
    app.add_option("--to", request.format, "form of the report")
        ->check(CLI::IsMember({"text", "json", "junit"}))
        ->capture_default_str();
    app.add_option("-o", request.output, "file for the report (default: standard output)");
    app.add_option("--witness", request.witness,
                   "folder for the stimuli, traces and waveforms that show a difference");
    app.add_option("--assume", request.assumptions,
                   "what the plant never does, besides what the file assumes: an expression that "
                   "is never 0");
    app.add_option("--max-cases", request.max_cases, "give up after so many cases");
    app.add_option("--max-seconds", request.max_seconds, "give up after so much time")
        ->check(CLI::NonNegativeNumber);
}

}  // namespace

std::function<int()> declare_check(CLI::App& app, const Language& language) {
    const auto request = std::make_shared<Request>();
    declare_options(app, *request);
    return [request, &language] {
        // Read the GRAFCET, and what the plant never does.
        auto loaded = load_grafcet(request->path);
        if (!loaded || !add_assumptions(request->assumptions, loaded->grafcet)) {
            return static_cast<int>(bad_request);
        }
        // Make the netlist, or read the one to compare with.
        const auto netlist = netlist_to_compare(*request, *loaded, language);
        if (!netlist) return static_cast<int>(bad_request);
        const CellDelays delays = unit_delays(*netlist);
        // Compare it with the reference in every reachable case.
        CheckResult result;
        {
            Progress progress(request->max_seconds);
            CheckOptions options;
            options.max_cases = request->max_cases;
            options.keep_going = [&](const Coverage& coverage) {
                return progress.goes_on(coverage);
            };
            result = check_equivalence(loaded->grafcet, *netlist, delays, options);
        }
        // Report.
        return report(*request, *loaded, *netlist, delays, result, language);
    };
}

}  // namespace grafwire
