#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "check/check_equivalence.h"
#include "check/compare_ports.h"
#include "check/netlist_witness.h"
#include "command/check_request.h"
#include "command/command.h"
#include "evolution/run.h"
#include "explain/explain.h"
#include "explain/tell_witness.h"
#include "grafcet/parse_grafcet.h"
#include "simulate/simulate.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

/// Of the way through the gates, what a report for people shows.
constexpr std::size_t most_links = 36;

bool add_assumptions(const std::vector<std::string>& texts, Grafcet& grafcet) {
    bool good = true;
    for (const std::string& text : texts) {
        Diagnostics diagnostics;
        const SourceFile source{"--assume", text};
        parse_assumption(source, grafcet, diagnostics);
        show_diagnostics(diagnostics, source);
        good = good && !diagnostics.has_errors();
    }
    return good;
}

/// A netlist from elsewhere, if its ports allow a comparison.
std::optional<Netlist> netlist_to_compare(const CheckRequest& request, const LoadedGrafcet& loaded,
                                          Language language) {
    if (request.against.empty()) return make_netlist(loaded, request.netlist);
    auto netlist = load_netlist(request.against);
    if (!netlist) return std::nullopt;
    const PortComparison ports = compare_ports(loaded.grafcet, *netlist);
    if (!ports.fits()) {
        show(fmt::format("{}: the ports do not fit {}:\n{}", visible(request.against),
                         visible(request.path), write_port_table(ports, language)));
    }
    if (!ports.can_compare()) return std::nullopt;
    adopt_ports(loaded.grafcet, *netlist);
    netlist->starts_initially = request.power_up == "initial";
    return netlist;
}

/// The files that show a witness: stimuli, what reference and netlist make of them, the story.
std::vector<WitnessFile> files_of_witness(const Grafcet& grafcet, const Netlist& netlist,
                                          const CellDelays& delays, const Witness& witness,
                                          const std::string& story) {
    const Stimuli& stimuli = witness.stimuli;
    const RunResult run = witness.scan_period == 0
                              ? run_until_stable(grafcet, stimuli)
                              : run_scans(grafcet, stimuli, witness.scan_period);
    SimulateOptions options;
    options.waveform = true;
    options.scan_period = witness.scan_period;
    const SimulateResult simulated = simulate(grafcet, netlist, delays, stimuli, options);
    return {{"witness.stim", write_stimuli(stimuli, grafcet)},
            {"witness.txt", story},
            {"expected.csv", write_csv(run.trace)},
            {"expected.vcd", write_vcd(run.trace, grafcet.name)},
            {"got.csv", write_csv(simulated.trace)},
            {"got.vcd", simulated.waveform}};
}

/// How the steps of a netlist get their first values.
PowerUp power_up_of(const CheckRequest& request, const Grafcet& grafcet, const Netlist& netlist) {
    const NetId init = map_ports(grafcet, netlist).inputs[grafcet.inputs.size()];
    if (init != no_net) return PowerUp::init;
    if (request.against.empty()) return PowerUp::initial_values;
    return netlist.starts_initially ? PowerUp::given : PowerUp::unknown;
}

CheckSubject netlist_subject(const CheckRequest& request, const LoadedGrafcet& loaded,
                             const Netlist& netlist) {
    CheckSubject subject = subject_of(request);
    if (netlist.is_clocked()) {
        subject.period = request.scan.empty() ? "every" : request.scan;
    } else {
        subject.changes = request.changes == "many" ? Changes::many : Changes::one;
    }
    subject.power_up = power_up_of(request, loaded.grafcet, netlist);
    subject.warnings = loaded.warnings;
    return subject;
}

/// Compares a netlist with the GRAFCET; empty, with the reason shown, where that is not possible.
std::optional<Judgement> judge_netlist(const CheckRequest& request, const LoadedGrafcet& loaded,
                                       Language language) {
    // Make the netlist, or read the one to compare with.
    const Grafcet& grafcet = loaded.grafcet;
    const auto netlist = netlist_to_compare(request, loaded, language);
    if (!netlist) return std::nullopt;
    Judgement judgement{netlist_subject(request, loaded, *netlist), {}, {}, {}};
    if (!can_check(request, grafcet, judgement.subject, netlist->has_modes)) return std::nullopt;
    const CellDelays delays = unit_delays(*netlist);
    // Compare it with the reference in every reachable case.
    {
        Progress progress(request.max_seconds, memory_of(request));
        CheckOptions options = check_options(request, progress);
        if (!request.scan.empty()) {
            options.scan_period = parse_period(request.scan);
            if (!options.scan_period) return std::nullopt;
            judgement.subject.period = format_duration(*options.scan_period);
        }
        judgement.result = check_equivalence(grafcet, *netlist, delays, options);
    }
    // Tell a difference.
    if (const auto& witness = judgement.result.witness) {
        const Netlist powered = with_power_up(*netlist, witness->power_up);
        const Explanation explanation = explain(grafcet, powered, delays, *witness);
        const auto tell = [&](Language in, std::size_t links) {
            return tell_witness(grafcet, powered, *witness, explanation,
                                {in, links, request.against});
        };
        judgement.told.text = tell(language, most_links);
        for (const Netlist::InitialValue& initial : witness->power_up) {
            judgement.told.power_up.emplace_back(netlist->names[initial.net], initial.value);
        }
        if (explanation.cause) judgement.told.cause = identifier_of(explanation.cause->kind);
        judgement.told.story = lines_of(tell(Language::english, 0));
        if (!request.witness.empty()) {
            judgement.witness_files =
                files_of_witness(grafcet, powered, delays, *witness, tell(language, 0));
        }
    }
    return judgement;
}

std::optional<Judgement> judge(const CheckRequest& request, const LoadedGrafcet& loaded,
                               Language language) {
    const std::filesystem::path extension = std::filesystem::path(request.against).extension();
    if (extension == ".awl") return judge_listing(request, loaded, language);
    if (extension == ".xml") return judge_ladder(request, loaded, language);
    return judge_netlist(request, loaded, language);
}

/// The GRAFCET, with all that the plant never does; empty, and shown, if that or a bound of the
/// exploration is wrong.
std::optional<LoadedGrafcet> load_plant(const CheckRequest& request) {
    auto loaded = load_grafcet(request.path);
    if (!loaded || !add_assumptions(request.assumptions, loaded->grafcet) ||
        (!request.max_memory.empty() && !parse_memory(request.max_memory))) {
        return std::nullopt;
    }
    return loaded;
}

void declare_options(const CommandLine& line, CheckRequest& request) {
    line.add("FILE", request.path, "the GRAFCET, - for standard input").required();
    request.netlist.declare(line, false);
    line.add("--delay", request.delay, "delay of every gate: unit (1 ns)")
        .one_of({"unit"})
        .shows_default();
    line.add("--against", request.against,
             "compare this .blif or .json (Yosys) netlist, this .awl listing (S7-200), or this "
             ".xml ladder diagram (PLCopen), instead of a generated netlist");
    line.add("--program", request.program,
             "ladder diagrams: which program of the project, where it holds several");
    line.add("--io", request.io,
             "listings: table of assignment, which address stands for which name");
    line.add("--changes", request.changes,
             "asynchronous netlists: what changes in one instant: one input, or delays end, and "
             "the netlist settles before the next (the default); or many")
        .one_of({"one", "many"});
    line.add("--power-up", request.power_up,
             "netlists from elsewhere without Init: how their steps start: unknown (the default), "
             "or initial, taken as given")
        .one_of({"unknown", "initial"});
    line.add("--scan", request.scan,
             "clocked netlists: the only time from one scan to the next that the verdict is for "
             "(default: every one); listings and ladder diagrams: that time (default: one that "
             "divides all delays)");
    line.add("--cpu", request.cpu, "listings: the controller, 212 or 214")
        .one_of({"212", "214"})
        .shows_default();
    line.add("--to", request.format, "form of the report")
        .one_of({"text", "json", "junit"})
        .shows_default();
    line.add("-o", request.output, "file for the report (default: standard output)");
    line.add("--witness", request.witness,
             "folder for the stimuli, traces and waveforms that show a difference; those of an "
             "earlier one go");
    line.add("--assume", request.assumptions,
             "what the plant never does, besides what the file assumes: an expression that "
             "is never 0");
    line.add("--max-cases", request.max_cases, "give up after so many cases (0: never)");
    line.add("--max-seconds", request.max_seconds, "give up after so much time (0: never)");
    line.add("--max-memory", request.max_memory,
             "give up once so much memory is held, such as 500M or 2G");
}

}  // namespace

std::function<int()> declare_check(const CommandLine& line, const Language& language) {
    const auto request = std::make_shared<CheckRequest>();
    declare_options(line, *request);
    return [request, &language] {
        const auto began = std::chrono::steady_clock::now();
        const MessageRecord messages;
        // Read the GRAFCET, and judge what is to be compared with it.
        const auto loaded = load_plant(*request);
        auto judgement = loaded ? judge(*request, *loaded, language) : std::nullopt;
        // Report.
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
        if (!judgement) return report_refused(*request, messages.text(), seconds);
        return report_check(*request, loaded->grafcet, std::move(*judgement), seconds, language);
    };
}

}  // namespace grafwire
