#include "command/check_request.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "check/exercised.h"
#include "check/partial_inputs.h"
#include "check/scan_check.h"
#include "command/exit_status.h"
#include "evolution/run.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

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

/// Adds the files to their folder, and says where they will stand; those of an earlier difference
/// go, so that what is there always belongs to the last verdict.
std::vector<std::string> add_witness(OutputFiles& files, const std::string& folder,
                                     const std::vector<WitnessFile>& witness_files) {
    std::vector<std::string> paths;
    if (!witness_files.empty()) files.add_folder(folder);
    for (const std::string_view name : witness_file_names) {
        const std::string path = (std::filesystem::path(folder) / name).string();
        const auto file = std::find_if(witness_files.begin(), witness_files.end(),
                                       [&](const WitnessFile& item) { return item.name == name; });
        if (file == witness_files.end()) {
            files.remove(path);
        } else {
            files.add(path, file->text);
            paths.push_back(path);
        }
    }
    return paths;
}

}  // namespace

namespace {

volatile std::sig_atomic_t is_interrupted = 0;

void note_interrupt(int) {
    is_interrupted = 1;
}

/// What the program holds in memory, in bytes; 0 where the system does not tell.
std::uint64_t memory_held() {
    std::ifstream file("/proc/self/statm");
    std::uint64_t whole = 0;
    std::uint64_t held = 0;
    file >> whole >> held;
    return held * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

Progress::Progress(double max_seconds, std::uint64_t max_memory)
    : max_seconds_(max_seconds), max_memory_(max_memory), is_terminal_(isatty(STDERR_FILENO) == 1) {
    is_interrupted = 0;
    struct sigaction once {};
    once.sa_handler = note_interrupt;
    once.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &once, nullptr);
}

Progress::~Progress() {
    std::signal(SIGINT, SIG_DFL);
    if (shown_) fmt::print(stderr, "\r\033[K");
}

bool Progress::goes_on(const Coverage& coverage) {
    const double elapsed = std::chrono::duration<double>(Clock::now() - begin_).count();
    is_over_ = is_over_ || is_interrupted != 0 || (max_seconds_ != 0 && elapsed >= max_seconds_);
    if (max_memory_ != 0 && elapsed >= next_look_at_memory_) {
        is_over_ = is_over_ || memory_held() >= max_memory_;
        next_look_at_memory_ = elapsed + 0.05;
    }
    if (is_terminal_ && elapsed > next_) {
        fmt::print(stderr, "\r\033[K{} cases, {} situations, {} states waiting", coverage.cases,
                   coverage.situations, coverage.waiting);
        shown_ = true;
        next_ = elapsed + 0.5;
    }
    return !is_over_;
}

std::optional<std::uint64_t> parse_memory(const std::string& text) {
    std::uint64_t amount = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), amount);
    const std::string unit(end, text.data() + text.size());
    const int shift = unit == "k" ? 10 : unit == "M" || unit.empty() ? 20 : unit == "G" ? 30 : 0;
    if (error != std::errc() || shift == 0 || amount == 0 || amount > (UINT64_MAX >> shift)) {
        complain(fmt::format("'{}' is no amount of memory: write 500M or 2G", visible(text)));
        return std::nullopt;
    }
    return amount << shift;
}

namespace {

/// An option that would have no effect is refused rather than ignored.
bool refuse(bool is_given, std::string_view option, std::string_view why) {
    if (is_given) complain(fmt::format("{} has no effect here: {}", option, why));
    return is_given;
}

}  // namespace

bool can_check(const CheckRequest& request, const Grafcet& grafcet, const CheckSubject& subject,
               bool has_modes) {
    if (refuse(subject.is_scanned() && !request.changes.empty(), "--changes",
               "inputs are sampled, and any of them change between two scans")) {
        return false;
    }
    if (refuse(!subject.is_scanned() && !request.scan.empty(), "--scan", "nothing is scanned"))
        return false;
    const bool is_set =
        subject.power_up == PowerUp::init || subject.power_up == PowerUp::initial_values;
    if (refuse(is_set && !request.power_up.empty(), "--power-up",
               "it is for a netlist from elsewhere without an input Init")) {
        return false;
    }
    if (!can_ever_act(grafcet)) {
        complain(
            fmt::format("{}: no step is initial and no source transition activates any, so nothing "
                        "ever happens in this GRAFCET: make a step initial",
                        visible(request.path)));
        return false;
    }
    if (!Assumptions(grafcet).can_hold(open_inputs(grafcet, has_modes))) {
        complain("the assumptions leave no input: without modes Init, AUdur and AUdoux stay 0");
        return false;
    }
    return true;
}

std::uint64_t memory_of(const CheckRequest& request) {
    return request.max_memory.empty() ? 0 : parse_memory(request.max_memory).value_or(0);
}

CheckOptions check_options(const CheckRequest& request, Progress& progress) {
    CheckOptions options;
    options.max_cases = request.max_cases;
    options.changes = request.changes == "many" ? Changes::many : Changes::one;
    options.keep_going = [&progress](const Coverage& coverage) {
        return progress.goes_on(coverage);
    };
    return options;
}

std::optional<Time> scan_period(const CheckRequest& request, const Grafcet& grafcet,
                                const ScannedDevice& device) {
    if (request.scan.empty()) return natural_period(grafcet, device);
    return parse_period(request.scan);
}

CheckSubject subject_of(const CheckRequest& request) {
    CheckSubject subject;
    subject.file = request.path;
    subject.against = request.against;
    if (request.against.empty()) {
        subject.style = request.netlist.style;
        subject.cdx = request.netlist.cdx_name();
    }
    subject.delay = request.delay;
    subject.name = request.against.empty() ? subject.style + " " + subject.cdx : request.against;
    for (const std::string* asked : {&request.changes, &request.power_up, &request.scan}) {
        if (!asked->empty()) subject.name += " " + *asked;
    }
    return subject;
}

CheckSubject program_subject(const CheckRequest& request, const LoadedGrafcet& loaded,
                             const ScannedDevice& device, Time period) {
    CheckSubject subject = subject_of(request);
    subject.is_program = true;
    subject.period = format_duration(period);
    subject.power_up = device.has_modes() ? PowerUp::init : PowerUp::initial_values;
    subject.warnings = loaded.warnings;
    return subject;
}

int report_check(const CheckRequest& request, const Grafcet& grafcet, Judgement judgement,
                 double seconds, Language language) {
    auto& [subject, result, told, witness_files] = judgement;
    OutputFiles files({request.path, request.against, request.io});
    if (!request.witness.empty()) {
        subject.witness_files = add_witness(files, request.witness, witness_files);
    }
    if (request.format == "json") {
        files.add(request.output, write_check_json(subject, grafcet, result, told));
    } else if (request.format == "junit") {
        files.add(request.output, write_check_junit(subject, grafcet, result, told, seconds));
    } else {
        files.add(request.output, write_check_text(subject, grafcet, result, told, language));
    }
    return finish(files, exit_status(result.verdict));
}

int report_refused(const CheckRequest& request, const std::string& messages, double seconds) {
    if (request.format != "junit") return bad_request;
    OutputFiles files({request.path, request.against, request.io});
    files.add(request.output, write_refused_junit(subject_of(request), messages, seconds));
    return finish(files, bad_request);
}

ToldWitness told_by(const std::function<std::string(Language)>& tell, Language language) {
    return {tell(language), "", lines_of(tell(Language::english)), {}};
}

CheckResult compare_scans(const CheckRequest& request, const Grafcet& grafcet,
                          const ScannedDevice& device, Time period) {
    Progress progress(request.max_seconds, memory_of(request));
    return check_scans(grafcet, device, period, check_options(request, progress));
}

std::vector<WitnessFile> files_of_scans(const Grafcet& grafcet, const ScannedDevice& device,
                                        const Witness& witness, const std::string& story) {
    const RunResult expected = run_scans(grafcet, witness.stimuli, witness.scan_period);
    const Trace got = run_device(grafcet, device, witness.stimuli, witness.scan_period);
    return {{"witness.stim", write_stimuli(witness.stimuli, grafcet)},
            {"witness.txt", story},
            {"expected.csv", write_csv(expected.trace)},
            {"expected.vcd", write_vcd(expected.trace, grafcet.name)},
            {"got.csv", write_csv(got)},
            {"got.vcd", write_vcd(got, grafcet.name)}};
}

}  // namespace grafwire
