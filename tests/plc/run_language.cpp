#include "plc/run_language.h"

#include <doctest/doctest.h>

#include <stdexcept>

#include "evolution/run.h"
#include "plc/formats.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "support/run_program.h"
#include "support/slow_build.h"

namespace grafwire::testing {

namespace {

/// The first columns of a trace.
Trace first_columns(const Trace& trace, std::size_t count) {
    Trace result;
    result.columns.assign(trace.columns.begin(),
                          trace.columns.begin() + static_cast<std::ptrdiff_t>(count));
    result.times = trace.times;
    for (std::size_t row = 0; row < trace.row_count(); ++row) {
        for (std::size_t c = 0; c < count; ++c) {
            result.values.push_back(trace.values[row * trace.columns.size() + c]);
        }
    }
    return result;
}

std::size_t external_columns(const Grafcet& grafcet) {
    return grafcet.all_input_count() + grafcet.steps.size() + grafcet.outputs.size();
}

}  // namespace

std::string heading_without_internals(const Grafcet& grafcet) {
    return write_csv(first_columns(empty_trace(grafcet), external_columns(grafcet)));
}

std::string compare_with_reference(const RandomCase& item, const LanguageRunner& run,
                                   bool with_internals, const ProgramOptions& options,
                                   const std::vector<Time>& periods) {
    const auto grafcet = read_grafcet(item.chart);
    REQUIRE(grafcet);
    const auto stimuli = read_stimuli(item.stimuli, *grafcet);
    REQUIRE(stimuli);
    std::vector<std::string> scans;
    std::vector<std::string> expected;
    for (const Time period : periods) {
        const Trace trace = run_scans(*grafcet, *stimuli, period).trace;
        expected.push_back(
            write_csv(with_internals ? trace : first_columns(trace, external_columns(*grafcet))));
        scans.push_back(write_csv(first_columns(trace, grafcet->all_input_count())));
    }
    std::vector<std::string> got;
    try {
        got = run(*grafcet, program_from(*grafcet, options), scans);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (got.at(i) != expected[i]) {
            return "reference\n" + expected[i] + "program\n" + got[i];
        }
    }
    return {};
}

RandomCase example_case(const std::string& name) {
    return {text_of(example(name + ".grafcet")), text_of(example(name + ".stim"))};
}

std::string written(const std::string& format, const Grafcet& grafcet, const ScanProgram& program,
                    const PlcOptions& options) {
    const PlcFormat* row = plc_format_named(format);
    REQUIRE(row != nullptr);
    Diagnostics diagnostics;
    std::string text = row->write(grafcet, program, options, diagnostics);
    if (diagnostics.has_errors()) {
        CHECK(text == "");
        throw std::runtime_error(format_diagnostics(diagnostics, {"chart", ""}));
    }
    return text;
}

void check_language(const LanguageRunner& run, std::uint64_t first_seed, std::size_t random_cases,
                    bool with_internals) {
    const std::vector<std::string> examples = example_names();
    CHECK(examples.size() >= 13);
    for (const std::string& name : examples) {
        INFO("example " << name);
        CHECK(compare_with_reference(example_case(name), run, with_internals) == "");
    }
    // What the sanitizers watch is the writer alone: the program is compiled without them.
    const std::size_t count = is_slow_build ? random_cases / 4 : random_cases;
    check_property(
        [&](const RandomCase& item) { return compare_with_reference(item, run, with_internals); },
        Features(), first_seed, count, 15);
}

}  // namespace grafwire::testing
