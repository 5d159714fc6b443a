#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "check/check_result.h"
#include "check/report.h"
#include "check/tolerance.h"
#include "draw/scene.h"
#include "ladder/ladder.h"
#include "netlist/netlist.h"
#include "s7/machine/binding.h"
#include "text/diagnostics.h"
#include "text/keep_going.h"
#include "text/message.h"
#include "text/time.h"
#include "workflow/chart.h"
#include "workflow/programs.h"

namespace grafwire {

/// What a check is asked to do.
struct CheckRequest {
    /// What is known of the subject before: file, style, cdx, against, delays, name.
    CheckSubject subject;
    Changes changes = Changes::one;  ///< of asynchronous netlists
    /// Clocked netlists: the only scan period that the verdict is for (none: every one). Programs:
    /// the scan period (none: one that divides all delays).
    std::optional<Time> period;
    Workers* workers = nullptr;   ///< as in CheckOptions
    std::uint64_t max_cases = 0;  ///< give up after this many; 0: never
    /// As in CheckOptions: shown how far the exploration is, and asked whether to go on.
    std::function<void(const Coverage&)> progress;
    KeepGoing keep_going;
    Language language = Language::english;  ///< of the explanation
    bool with_files = false;                ///< whether the files of a witness are wanted
    bool looks_for_pulses = false;          ///< as in CheckOptions
    /// Asynchronous netlists: to find how much delays may differ as well, what to check then under
    /// a model; none: not wanted.
    NetlistFor tolerance_of{};
};

/// A file as it would be written: its name and its text.
struct NamedText {
    std::string name;
    std::string text;
};

/// The names of the files that show a witness.
inline constexpr std::string_view witness_file_names[] = {
    "witness.stim",  "witness.txt", "witness.svg", "expected.csv", "expected.vcd",
    "expected.gtkw", "got.csv",     "got.vcd",     "got.gtkw",     "witness.delays"};

/// What a check came to, and all that its reports say.
struct Judgement {
    CheckSubject subject;
    CheckResult result;
    ExplainedWitness explained;
    std::vector<NamedText> witness_files;
    std::vector<Sheet> witness_picture{};  ///< as in its file
};

struct CheckList;

/// The form of a report by the name users write.
struct ReportRow {
    std::string_view name;
    std::string_view extension;  ///< of its files, with the dot
    std::string (*write)(const Judgement& judgement, const Chart& chart, double seconds,
                         Language language);
    /// The report about several checks, also about those that were not made.
    std::string (*write_several)(const CheckList& list, Language language);
    /// It tells why a single check was not made; else there is no report about that one.
    bool tells_errors = false;
};
/// All forms, in the order in which help shows them.
std::span<const ReportRow> report_forms();

/// How the steps of a netlist get their first values; one from elsewhere may leave that open.
PowerUp power_up_of(const Chart& chart, const Netlist& netlist, bool is_from_elsewhere);

/// Compares a netlist, generated or from elsewhere and made to fit, with the chart. Empty, with the
/// reasons in `messages`, where that makes no sense.
std::optional<Judgement> check_netlist(const Chart& chart, const Netlist& netlist,
                                       const CheckRequest& request, Diagnostics& messages);

/// Reads the ladder diagram of a PLCopen project; `program`: which one, where it holds several.
std::optional<ladder::Ladder> read_ladder(const SourceFile& source, const std::string& program,
                                          Diagnostics& diagnostics);

/// The same of a ladder diagram, scan by scan.
std::optional<Judgement> check_ladder(const Chart& chart, const ladder::Ladder& ladder,
                                      const CheckRequest& request, Diagnostics& messages);

/// The same of an S7-200 listing; the binding says where it keeps what the chart names.
std::optional<Judgement> check_listing(const Chart& chart, const s7::Listing& listing, s7::Cpu cpu,
                                       const s7::Binding& binding, const CheckRequest& request,
                                       Diagnostics& messages);

}  // namespace grafwire
