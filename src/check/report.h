#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "check/check_result.h"
#include "check/told_witness.h"
#include "grafcet/grafcet.h"
#include "text/language.h"

namespace grafwire {

/// What a check was made of, for its report.
struct CheckSubject {
    std::string file;  ///< the GRAFCET's file
    /// What it was compared with, in the order in which it is said.
    struct Property {
        std::string key;      ///< in JSON
        std::string english;  ///< the words before the value
        std::string french;
        std::string value;
    };
    std::vector<Property> properties;
    std::vector<std::string> witness_files;  ///< what was written for the witness
    bool is_scanned = false;                 ///< compared scan by scan, not in stable situations
};

/// A netlist. `style`: `nand`, for a netlist from elsewhere its file; `cdx`: `successor` or
/// `transition`; `delay`: `unit`.
CheckSubject netlist_subject(const std::string& file, const std::string& style,
                             const std::string& cdx, const std::string& delay);
/// A program that is executed scan by scan. `program`: its file.
CheckSubject device_subject(const std::string& file, const std::string& program, Time period);

/// The report for people: verdict, coverage, the witness and what it shows.
std::string write_check_text(const CheckSubject& subject, const Grafcet& grafcet,
                             const CheckResult& result, const std::string& story,
                             Language language);

/// The report for programs; its form is fixed (see the README).
std::string write_check_json(const CheckSubject& subject, const Grafcet& grafcet,
                             const CheckResult& result, const ToldWitness& told = {});

/// One JUnit test suite with one test case: equivalent passes, different fails, undecided is an
/// error.
std::string write_check_junit(const CheckSubject& subject, const Grafcet& grafcet,
                              const CheckResult& result, const std::string& story);

}  // namespace grafwire
