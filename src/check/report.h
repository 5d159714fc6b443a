#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/check_result.h"
#include "check/told_witness.h"
#include "grafcet/grafcet.h"
#include "text/diagnostics.h"
#include "text/language.h"

namespace grafwire {

/// How the steps of what is compared get their first values.
enum class PowerUp {
    init,            ///< from an input Init
    initial_values,  ///< they have values of their own
    given,           ///< nothing sets them; the initial situation is taken as given
    unknown,         ///< nothing sets them, and any values count
};

/// What was compared with a GRAFCET, and what the verdict rests on besides the assumptions of the
/// GRAFCET.
struct CheckSubject {
    std::string file;         ///< the GRAFCET's
    std::string style;        ///< of a generated netlist
    std::string cdx;          ///< likewise: `successor` or `transition`
    std::string against;      ///< the file of a netlist or a program from elsewhere, else empty
    bool is_program = false;  ///< executed scan by scan; else a netlist
    std::string delay;        ///< of netlists: `unit`
    std::optional<Changes> changes;  ///< of asynchronous netlists
    /// Of clocked netlists and programs: the time from one scan to the next; `every` for any.
    std::string period;
    PowerUp power_up = PowerUp::init;
    /// What tells this check from others of the same GRAFCET, in JUnit.
    std::string name;
    std::vector<Diagnostic> warnings;        ///< those of the GRAFCET
    std::vector<std::string> witness_files;  ///< what was written for the witness

    bool is_scanned() const { return !period.empty(); }
};

/// As the reports for programs write them.
std::string_view name_of(Verdict verdict);
std::string_view name_of(DifferenceKind kind);

/// The report for people: the verdict and what it rests on, coverage, remarks, the witness and what
/// it shows.
std::string write_check_text(const CheckSubject& subject, const Grafcet& grafcet,
                             const CheckResult& result, const ToldWitness& told, Language language);

/// The report for programs; its form is that of report.schema.json. Not a matter of language.
std::string write_check_json(const CheckSubject& subject, const Grafcet& grafcet,
                             const CheckResult& result, const ToldWitness& told = {});

/// One JUnit test suite with one test case: equivalent passes, different fails, undecided is an
/// error. In English. `seconds`: what the check took.
std::string write_check_junit(const CheckSubject& subject, const Grafcet& grafcet,
                              const CheckResult& result, const ToldWitness& told, double seconds);

/// The same of a check that could not be made: an error, with the messages that say why. Of the
/// subject, file and name count.
std::string write_refused_junit(const CheckSubject& subject, std::string_view messages,
                                double seconds);

}  // namespace grafwire
