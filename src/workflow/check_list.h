#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "text/file_messages.h"
#include "text/message.h"
#include "workflow/chart.h"
#include "workflow/check.h"

namespace grafwire {

// Several checks, of files and styles: what is planned, what came of each, and the reports about
// all. Who runs them, in which order, and where the texts come from is not known here.

/// The styles that a user names: `nand`, `nand,rs`, or `all`, in the order of the table of styles.
/// Empty where a word is none.
std::vector<std::string> styles_in(std::string_view words);

/// One check of several.
struct PlannedCheck {
    std::size_t file = 0;  ///< its number
    std::string style;     ///< empty where something from elsewhere is compared
};

/// Every file with every style, file by file.
std::vector<PlannedCheck> plan_checks(std::size_t files, const std::vector<std::string>& styles);

/// One of several parts of a plan: `2/3` is the second of three.
struct Shard {
    std::size_t number = 1;
    std::size_t count = 1;
};
std::optional<Shard> parse_shard(std::string_view text);

/// That part: the plan is sorted by the names of files, then by styles, both byte by byte, and cut
/// into parts whose sizes differ by one at the most. So machines that each make one make all, as
/// long as they see the same names.
std::vector<PlannedCheck> part_of(std::vector<PlannedCheck> plan,
                                  const std::vector<std::string>& names, Shard shard);

/// A file that was to be checked.
struct CheckedFile {
    std::optional<Chart> chart;          ///< none: it cannot be read, or is wrong
    Localized text;                      ///< the messages about it, as they are shown
    std::vector<FileMessages> messages;  ///< the same, one by one
};

/// What came of a check.
enum class CheckOutcome {
    equivalent,
    different,
    undecided,
    skipped,  ///< the style cannot hold the chart, and was one of all styles
    error     ///< it could not be made
};

struct CheckedCase {
    std::size_t file = 0;
    CheckSubject subject;                ///< file, name, and style or against
    std::optional<Judgement> judgement;  ///< none: skipped, or an error
    bool is_skipped = false;
    Localized text;                      ///< messages about the check, likewise
    std::vector<FileMessages> messages;  ///< those of its file are there
    double seconds = 0;                  ///< that it took

    CheckOutcome outcome() const;
};

struct CheckList {
    std::vector<CheckedFile> files;
    std::vector<CheckedCase> cases;  ///< in the order of the plan
    std::string folder;              ///< SARIF: what files are named relative to
};

/// A file that is skipped in every style has no verdict at all, and nobody may take that for a good
/// one: its cases become errors. Returns these files.
std::vector<std::size_t> refuse_skipped_files(CheckList& list);

// The reports about all; each is like that about one, but the last, which is for people: a line per
// check with its file, what was compared, what came of it, cases and seconds, and how many there
// are of each outcome.
std::string write_texts(const CheckList& list, Language language);
std::string write_json_lines(const CheckList& list, Language language);
std::string write_junit_suite(const CheckList& list, Language language);
/// The messages about the charts, and beside them what the verdicts say: a difference is an error.
std::string write_check_sarif(const CheckList& list, Language language);
Localized outcome_table(const CheckList& list);

}  // namespace grafwire
