#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "check/check_result.h"
#include "check/report.h"
#include "check/scanned_device.h"
#include "command/netlist_request.h"

namespace grafwire {

/// What `check` is asked to do.
struct CheckRequest {
    std::string path;
    NetlistRequest netlist;
    std::string against;
    std::string program;
    std::string io;
    std::string cpu = "214";
    std::string scan;
    std::string delay = "unit";
    std::string changes;   ///< empty: one
    std::string power_up;  ///< empty: unknown
    std::string format = "text";
    std::string witness;
    std::vector<std::string> assumptions;
    std::uint64_t max_cases = 0;
    double max_seconds = 0;
    std::string max_memory;  ///< empty: no bound
    std::string output;
};

/// Shows how far the exploration is, on a terminal, once it takes more than a moment; and ends it
/// when its time or its memory is used up, or when the user wants it to end (Ctrl-C, once; the
/// second time ends the program).
class Progress {
  public:
    /// `max_memory` in bytes; 0 stands for no bound, likewise for the seconds.
    Progress(double max_seconds, std::uint64_t max_memory);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    bool goes_on(const Coverage& coverage);

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point begin_ = Clock::now();
    double max_seconds_;
    std::uint64_t max_memory_;
    double next_ = 1.0;
    double next_look_at_memory_ = 0;
    bool is_over_ = false;
    bool is_terminal_;
    bool shown_ = false;
};

/// The names of the files that show a witness.
inline constexpr std::string_view witness_file_names[] = {
    "witness.stim", "witness.txt", "expected.csv", "expected.vcd", "got.csv", "got.vcd"};

/// One of these names, and the text of that file.
struct WitnessFile {
    std::string name;
    std::string text;
};

/// What a check came to, and all that its reports say.
struct Judgement {
    CheckSubject subject;
    CheckResult result;
    ToldWitness told;
    std::vector<WitnessFile> witness_files;  ///< for the folder, if one is asked for
};

/// What the reports say of a request before anything has been read.
CheckSubject subject_of(const CheckRequest& request);
/// The same of a program, which is scanned.
CheckSubject program_subject(const CheckRequest& request, const LoadedGrafcet& loaded,
                             const ScannedDevice& device, Time period);

/// Writes the report, and the files of the witness into the folder asked for, if one is, where
/// those of an earlier witness go; returns what the program ends with. `seconds`: what the check
/// took.
int report_check(const CheckRequest& request, const Grafcet& grafcet, Judgement judgement,
                 double seconds, Language language);

/// Where no check could be made for the reasons that the messages say: a JUnit report, if one is
/// asked for, has them too, since whoever reads these reports may see nothing else. Returns what
/// the program ends with.
int report_refused(const CheckRequest& request, const std::string& messages, double seconds);

/// Whether the request makes sense for what is compared, and the GRAFCET gives a check something to
/// say; shows why not. A clocked netlist and a program are scanned.
bool can_check(const CheckRequest& request, const Grafcet& grafcet, const CheckSubject& subject,
               bool has_modes);

/// The bounds of an exploration, as asked for.
CheckOptions check_options(const CheckRequest& request, Progress& progress);
/// In bytes; 0: no bound. The request must hold an amount or nothing.
std::uint64_t memory_of(const CheckRequest& request);
/// `500M`, `2G`, a number of MiB without a unit; in bytes. Empty (and shown) if it is none.
std::optional<std::uint64_t> parse_memory(const std::string& text);

/// The period of a comparison scan by scan: the one asked for, or the device's natural one; empty
/// (and shown) if it is wrong.
std::optional<Time> scan_period(const CheckRequest& request, const Grafcet& grafcet,
                                const ScannedDevice& device);

/// Compares a program with the reference after every scan, in every state that can be reached.
CheckResult compare_scans(const CheckRequest& request, const Grafcet& grafcet,
                          const ScannedDevice& device, Time period);

/// A witness as the reports tell it, put into words by `tell`.
ToldWitness told_by(const std::function<std::string(Language)>& tell, Language language);

/// The files that show the witness of a program: stimuli, what reference and program make of them,
/// the story.
std::vector<WitnessFile> files_of_scans(const Grafcet& grafcet, const ScannedDevice& device,
                                        const Witness& witness, const std::string& story);

/// Compares an S7-200 listing with the GRAFCET; empty, with the reason shown, where that is not
/// possible.
std::optional<Judgement> judge_listing(const CheckRequest& request, const LoadedGrafcet& loaded,
                                       Language language);

/// The same of a ladder diagram in a PLCopen project.
std::optional<Judgement> judge_ladder(const CheckRequest& request, const LoadedGrafcet& loaded,
                                      Language language);

}  // namespace grafwire
