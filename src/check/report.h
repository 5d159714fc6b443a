#pragma once

#include <string>
#include <string_view>

#include "check/check_equivalence.h"
#include "text/language.h"

namespace grafwire {

/// What a check was made of, for its report.
struct CheckSubject {
    std::string file;   ///< the GRAFCET's file
    std::string style;  ///< `nand`; for a netlist from elsewhere its file
    std::string cdx;    ///< `successor` or `transition`
    std::string delay = "unit";
    std::vector<std::string> witness_files;  ///< what was written for the witness
};

/// The report for people: verdict, coverage, the witness and what it shows.
std::string write_check_text(const CheckSubject& subject, const Grafcet& grafcet,
                             const CheckResult& result, const std::string& story,
                             Language language);

/// The report for programs; its form is fixed (see the README).
std::string write_check_json(const CheckSubject& subject, const Grafcet& grafcet,
                             const CheckResult& result);

/// One JUnit test suite with one test case: equivalent passes, different fails, undecided is an
/// error.
std::string write_check_junit(const CheckSubject& subject, const Grafcet& grafcet,
                              const CheckResult& result, const std::string& story);

}  // namespace grafwire
