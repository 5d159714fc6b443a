#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "check/check_result.h"
#include "grafcet/grafcet.h"
#include "netlist/used_figures.h"
#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// How the steps of what is compared get their first values.
enum class PowerUp {
    init,            ///< from an input Init
    initial_values,  ///< they have values of their own
    given,           ///< nothing sets them; the initial situation is taken as given
    unknown,         ///< nothing sets them, and any values count
};

/// Of wiring in the style handshake: where the chart depends on the order in which its transitions
/// clear.
struct OrderRemarks {
    /// Two transitions by their names; `first` is empty where a time condition is the other party.
    struct Race {
        std::string kind;
        std::string first;
        std::string second;
        std::string stimuli;
    };
    /// One that was added: the names of the transition that waits and of the one it waits for, what
    /// was added, and the receptivity with it.
    struct Interlock {
        std::string transition;
        std::string awaited;
        std::string condition;
        std::string receptivity;
    };
    std::vector<Race> races;
    std::vector<Interlock> interlocks;
    std::uint64_t cases = 0;   ///< that were looked at for it
    bool is_complete = true;   ///< those are all
    Localized text;            ///< of the races, for people; empty where there is nothing to say
    Localized interlock_text;  ///< of the interlocks

    bool is_interlocked() const { return !interlocks.empty(); }
};

/// What was compared with a GRAFCET, and what the verdict rests on besides the assumptions of the
/// GRAFCET.
struct CheckSubject {
    std::string file;         ///< the GRAFCET's
    std::string style;        ///< of a generated netlist
    std::string cdx;          ///< likewise: `successor` or `transition`
    std::string against;      ///< the file of a netlist or a program from elsewhere, else empty
    bool is_program = false;  ///< executed scan by scan; else a netlist
    DelayModel delays{};      ///< of netlists: how long the gates take
    std::vector<UsedFigures> figures{};  ///< of a part family: what it says of their cells
    std::optional<Changes> changes;      ///< of asynchronous netlists
    /// Of clocked netlists and programs: the time from one scan to the next; `every` for any.
    std::string period;
    PowerUp power_up = PowerUp::init;
    /// What tells this check from others of the same GRAFCET, in JUnit.
    std::string name;
    std::vector<Diagnostic> warnings;        ///< those of the GRAFCET
    std::vector<std::string> witness_files;  ///< what was written for the witness
    std::optional<OrderRemarks> orders{};    ///< of the style handshake

    bool is_scanned() const { return !period.empty(); }
};

/// An X or output that changes too often in an instant, explained as the reports show it.
struct ExplainedPulse {
    std::string text;                 ///< for people, in their language
    std::vector<std::string> lines;   ///< for programs, in English, line by line
    std::vector<std::string> sooner;  ///< the gates that race, by the names of their nets
    std::vector<std::string> later;
    std::string delays;  ///< a `.delays` text for the gates; empty where all are nominal
};

/// A witness explained, as the reports show it.
struct ExplainedWitness {
    std::string text;   ///< for people, in their language, of a length to be read
    std::string cause;  ///< the identifier of a known cause (`two-step-loop`), or empty
    std::vector<std::string> lines;  ///< for programs: all of it, in English, line by line
    /// What memories hold at power-up, by the names of their nets, where the difference needs it.
    std::vector<std::pair<std::string, bool>> power_up;
    /// The same of the witness of a tolerance; one or none.
    std::vector<ExplainedWitness> at_tolerance{};
    std::vector<ExplainedPulse> pulses{};  ///< as in Pulses::found
};

/// The lines of a text, without their ends.
std::vector<std::string> lines_of(std::string_view text);

/// As the reports for programs write them.
std::string_view name_of(Verdict verdict);
std::string_view name_of(DifferenceKind kind);

/// The report for people: the verdict and what it rests on, coverage, remarks, the witness and what
/// it shows.
std::string write_check_text(const CheckSubject& subject, const Grafcet& grafcet,
                             const CheckResult& result, const ExplainedWitness& explained,
                             Language language);

/// The parts of the same after the verdict, for pages that lay them out; empty where there is
/// nothing to say.
struct CheckParts {
    std::string basis;     ///< what the verdict rests on
    std::string coverage;  ///< how much was compared
    std::string remarks;
    std::string witness;  ///< its stimuli, and what they show
};
CheckParts check_parts(const CheckSubject& subject, const Grafcet& grafcet,
                       const CheckResult& result, const ExplainedWitness& explained,
                       Language language);

/// The report for programs; its form is that of report.schema.json. Not a matter of language.
std::string write_check_json(const CheckSubject& subject, const Grafcet& grafcet,
                             const CheckResult& result, const ExplainedWitness& explained = {});

/// The same of a check that was not made, for one of several: the verdict is `error`, or `skipped`
/// where the style cannot hold the GRAFCET; `messages` say why.
std::string write_unchecked_json(const CheckSubject& subject, bool is_skipped,
                                 const std::vector<Diagnostic>& messages);

/// A test case of JUnit. In English.
struct JunitCase {
    enum class Outcome { passed, failed, error, skipped };
    Outcome outcome = Outcome::passed;
    std::string file;     ///< the GRAFCET's
    std::string name;     ///< what tells it from others of the same GRAFCET
    std::string message;  ///< unless it has passed: why, in a word or two
    std::string details;
    double seconds = 0;
};

/// Equivalent passes, different fails, undecided is an error. `seconds`: what the check took.
JunitCase junit_case(const CheckSubject& subject, const Grafcet& grafcet, const CheckResult& result,
                     const ExplainedWitness& explained, double seconds);

/// The same of a check that was not made, with the messages that say why: an error, or skipped
/// where the style cannot hold the GRAFCET. Of the subject, file and name count.
JunitCase unchecked_junit_case(const CheckSubject& subject, bool is_skipped, std::string messages,
                               double seconds);

/// A test suite of these cases. The time it took stands in it, as servers that build and test
/// expect, so it is the only report that is not the same every time.
std::string write_junit(std::span<const JunitCase> cases);

}  // namespace grafwire
