#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grafwire/netlist.h"
#include "grafwire/read.h"

namespace grafwire::api {

/// How far an exploration is.
struct Coverage {
    std::uint64_t situations = 0;  ///< distinct situations reached
    std::uint64_t cases = 0;       ///< changes of the inputs, or scans, that were compared
    std::uint64_t waiting = 0;     ///< states reached but not yet left
};

struct CheckOptions {
    /// Asynchronous netlists: many inputs may change in one instant, rather than one.
    bool many_changes = false;
    /// Clocked netlists: the only scan period that the verdict is for (none: every one). Programs:
    /// the scan period (none: one that divides all delays). It is positive.
    std::optional<std::chrono::nanoseconds> period;
    std::uint64_t max_cases = 0;  ///< give up, undecided, after so many; 0: never
    /// Called many times a second, if there is one; the check ends undecided once it says no.
    std::function<bool(const Coverage&)> keep_going;
    Language language = Language::english;  ///< of the report
};

enum class Verdict {
    equivalent,  ///< in every case that can be reached
    different,   ///< there is a witness
    undecided,   ///< within the bounds
};

/// A file as it would be written.
struct NamedText {
    std::string name;
    std::string text;
};

/// What a check came to.
struct CheckResult {
    Verdict verdict = Verdict::undecided;
    Coverage coverage;
    std::string report;  ///< for people
    std::string json;    ///< for programs, as report.schema.json says
    /// Where there is a difference: stimuli that show it, what reference and netlist make of them,
    /// and the explanation.
    std::vector<NamedText> witness;
};

/// Compares a netlist with the reference evolution of its chart. Errors: the check makes no sense,
/// such as that of a chart in which nothing ever happens.
Result<CheckResult> check(const Netlist& netlist, const CheckOptions& options = {});

/// The same of an S7-200 listing for a controller (`212`, `214`), scan by scan; the table of
/// assignment says which address stands for which name.
Result<CheckResult> check_listing(const Chart& chart, std::string listing, std::string assignment,
                                  const std::string& cpu, const CheckOptions& options = {});

/// The same of a ladder diagram in a PLCopen project; `program`: which one, where it holds several,
/// else empty.
Result<CheckResult> check_ladder(const Chart& chart, std::string project,
                                 const std::string& program, const CheckOptions& options = {});

}  // namespace grafwire::api
