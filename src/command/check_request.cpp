#include "command/check_request.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "check/scan_check.h"
#include "command/exit_status.h"
#include "evolution/run.h"

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

}  // namespace

Progress::Progress(double max_seconds)
    : max_seconds_(max_seconds), is_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (shown_) fmt::print(stderr, "\r\033[K");
}

bool Progress::goes_on(const Coverage& coverage) {
    const double elapsed = std::chrono::duration<double>(Clock::now() - begin_).count();
    if (is_terminal_ && elapsed > next_) {
        fmt::print(stderr, "\r\033[K{} cases, {} situations, {} states waiting", coverage.cases,
                   coverage.situations, coverage.waiting);
        shown_ = true;
        next_ = elapsed + 0.5;
    }
    return max_seconds_ == 0 || elapsed < max_seconds_;
}

CheckOptions check_options(const CheckRequest& request, Progress& progress) {
    CheckOptions options;
    options.max_cases = request.max_cases;
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

int report_check(const CheckRequest& request, const Grafcet& grafcet, CheckSubject subject,
                 const CheckResult& result, const ToldWitness& told,
                 const std::vector<WitnessFile>& witness_files, Language language) {
    OutputFiles files;
    if (result.witness && !request.witness.empty()) {
        std::error_code error;
        std::filesystem::create_directories(request.witness, error);
        for (const WitnessFile& file : witness_files) {
            subject.witness_files.push_back(
                (std::filesystem::path(request.witness) / file.name).string());
            files.add(subject.witness_files.back(), file.text);
        }
    }
    if (request.format == "json") {
        files.add(request.output, write_check_json(subject, grafcet, result, told));
    } else if (request.format == "junit") {
        files.add(request.output, write_check_junit(subject, grafcet, result, told.text));
    } else {
        files.add(request.output, write_check_text(subject, grafcet, result, told.text, language));
    }
    return finish(files, exit_status(result.verdict));
}

CheckResult compare_scans(const CheckRequest& request, const Grafcet& grafcet,
                          const ScannedDevice& device, Time period) {
    Progress progress(request.max_seconds);
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
