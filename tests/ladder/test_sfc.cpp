// The sequential function chart of a PLCopen project, executed from the file alone, is the
// reference scan for scan, whichever way the standard is read; where it cannot be, the file says
// so.

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

#include "evolution/run.h"
#include "grafcet/write_grafcet.h"
#include "ladder/run_sfc.h"
#include "ladder/sequence_chart.h"
#include "ladder/sfc_editor.h"
#include "random/random_cases.h"
#include "random/random_stimuli.h"
#include "random/read_text.h"
#include "sfc/remarks.h"
#include "support/chart_files.h"
#include "support/iec_grammar.h"

namespace grafwire::testing {

namespace {

using Kind = sfc::Remark::Kind;
using Remarks = std::vector<sfc::Remark>;

bool has(const Remarks& remarks, Kind kind) {
    return std::any_of(remarks.begin(), remarks.end(),
                       [&](const auto& remark) { return remark.kind == kind; });
}

struct Counts {
    std::size_t beyond = 0;    ///< charts that SFC cannot say, which are not run
    std::size_t complete = 0;  ///< that ran to the end in every way
    std::size_t cut_short = 0;
    std::size_t scans = 0;
    std::map<std::string, std::size_t> qualifiers;  ///< of the actions of those run
};

std::vector<SfcDialect> all_dialects() {
    std::vector<SfcDialect> dialects;
    for (int bits = 0; bits < 8; ++bits) {
        dialects.push_back({(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0});
    }
    return dialects;
}

/// The first rows of a trace.
Trace shortened(Trace trace, std::size_t rows) {
    trace.times.resize(rows);
    trace.values.resize(rows * trace.columns.size());
    return trace;
}

/// The name in the chart of what the file calls by an identifier.
std::string name_of(const WrittenSfc& written, const std::string& identifier) {
    for (const auto& [name, other] : written.names) {
        if (lower_case(other) == identifier) return quoted_where_needed(name);
    }
    return "nothing";
}

std::string unquoted(std::string name) {
    std::erase(name, '"');
    return name;
}

bool is_told(const Remarks& remarks, Kind kind, const std::string& beginning) {
    return std::any_of(remarks.begin(), remarks.end(), [&](const auto& remark) {
        return remark.kind == kind &&
               remark.text.english.compare(0, beginning.size(), beginning) == 0;
    });
}

/// What a scan left to order and no remark speaks of.
std::string untold(const WrittenSfc& written, const Remarks& remarks, const SfcScanReport& report) {
    for (const auto& [a, b] : report.selections) {
        const std::vector<std::size_t>& of_b = written.sfc.transitions[b].preceding;
        for (const std::size_t step : written.sfc.transitions[a].preceding) {
            if (std::find(of_b.begin(), of_b.end(), step) == of_b.end()) continue;
            // Without the X of its variable.
            std::string name = name_of(written, written.sfc.steps[step].name);
            name.erase(name.find('X'), 1);
            const std::string text = "step " + quoted_where_needed(unquoted(name)) + ":";
            if (!is_told(remarks, Kind::selection, text)) return "a selection after " + text;
        }
    }
    for (const SfcScanReport::Meeting& meeting : report.meetings) {
        for (const std::string& variable : meeting.variables) {
            const std::string text = name_of(written, variable) + " can be written";
            if (!is_told(remarks, Kind::meeting_writes, text)) return "a meeting: " + text;
        }
    }
    return {};
}

/// What differs in one run.
std::string compare_run(const Grafcet& grafcet, const WrittenSfc& written, const Remarks& remarks,
                        const SfcRun& run, const Trace& expected) {
    const std::string found = untold(written, remarks, run.left_open);
    if (!found.empty()) return found + " is not in the remarks\n" + written.xml;
    const std::string want = write_csv(shortened(expected, run.trace.row_count()));
    const std::string got = write_csv(run.trace);
    if (want == got) return {};
    return "reference\n" + want + "SFC\n" + got + written.xml.substr(written.xml.find("<SFC>")) +
           grafcet.name;
}

std::string compare(const RandomCase& item, Counts& counts) {
    const auto grafcet = read_grafcet(item.chart);
    const auto stimuli = without_modes(*read_stimuli(item.stimuli, *grafcet), *grafcet);
    const Remarks remarks = sfc::remarks_of(*grafcet);
    std::string at;
    try {
        const WrittenSfc written(*grafcet);
        const std::string text = sfc_as_text(written.xml);
        const std::string undeclared = undeclared_step_in(text);
        if (!undeclared.empty()) return undeclared + " stands above its step\n" + text;
        if (written.sfc.comments.size() != remarks.size()) return "comments that are no remarks";
        for (std::size_t r = 0; r < remarks.size(); ++r) {
            if (written.sfc.comments[r] != remarks[r].text.english)
                return "a remark is not in the file";
        }
        if (has(remarks, Kind::order) || has(remarks, Kind::enclosure) ||
            has(remarks, Kind::clearing)) {
            ++counts.beyond;
            return {};
        }
        bool is_complete = true;
        for (const Time period : {millisecond, 1500 * microsecond}) {
            const Trace expected = run_scans(*grafcet, stimuli, period).trace;
            for (const SfcDialect& dialect : all_dialects()) {
                const SfcRun run = run_sfc(*grafcet, written, dialect, stimuli, period);
                const std::string found = compare_run(*grafcet, written, remarks, run, expected);
                if (!found.empty()) {
                    return std::string(dialect.final_scan ? "final scan, " : "no final scan, ") +
                           (dialect.pulse_at_start ? "pulse at start, " : "no pulse at start, ") +
                           (dialect.restarts_time ? "time restarts: " : "time goes on: ") + found;
                }
                if (run.trace.row_count() != expected.row_count()) is_complete = false;
                counts.scans += run.trace.row_count();
            }
        }
        ++(is_complete ? counts.complete : counts.cut_short);
        for (const SfcPou::Action& action : written.sfc.actions) {
            ++counts.qualifiers[action.qualifier + (action.reference.empty() ? " ST" : "")];
        }
    } catch (const PlcError& error) {
        return error.what();
    }
    return {};
}

void say(const Counts& counts) {
    std::string text = std::to_string(counts.complete) + " to the end, " +
                       std::to_string(counts.cut_short) + " cut short, " +
                       std::to_string(counts.beyond) + " not run; " + std::to_string(counts.scans) +
                       " scans; actions";
    for (const auto& [qualifier, count] : counts.qualifiers) {
        text += " " + qualifier + " " + std::to_string(count);
    }
    MESSAGE(text);
}

/// Random charts of a kind; gives what became of them.
Counts check_random(const Features& features, std::uint64_t first_seed, std::size_t count) {
    Counts counts;
    check_property([&](const RandomCase& item) { return compare(item, counts); }, features,
                   first_seed, count, 15);
    say(counts);
    CHECK(counts.complete + counts.cut_short + counts.beyond == case_count(count));
    return counts;
}

std::string misfit_of(const std::string& chart) {
    const std::string text = sfc_as_text(WrittenSfc(*read_grafcet(chart)).xml);
    const std::string misfit = misfit_in_iec(text, "sfc_program");
    return misfit.empty() ? misfit : misfit + "\n" + text;
}

}  // namespace

TEST_CASE("SFC: an editor makes a text of the standard of it") {
    for (const ChartFiles& example : example_charts()) {
        CAPTURE(example.name);
        CHECK(misfit_of(example.chart) == "");
    }
    for (std::uint64_t seed = 995'000; seed < 995'060; ++seed) {
        CAPTURE(seed);
        CHECK(misfit_of(random_case(seed, Features(), 1).chart) == "");
    }
}

TEST_CASE("SFC: the examples are the reference") {
    Counts counts;
    for (const ChartFiles& example : example_charts()) {
        CAPTURE(example.name);
        CHECK(compare({example.chart, example.stimuli}, counts) == "");
    }
    say(counts);
    CHECK(counts.complete >= 8);
    CHECK(counts.cut_short == 0);
}

// How much of what is tried must come to something; few cases say nothing of that.
TEST_CASE("SFC: random charts without what SFC cannot say are the reference") {
    Features features;
    features.orders = false;
    features.enclosures = false;
    features.clearing = false;
    const Counts counts = check_random(features, 960'000, 600);
    CHECK(counts.beyond == 0);
    if (case_count(600) >= 100) CHECK(5 * counts.complete >= 2 * case_count(600));
}

TEST_CASE("SFC: random charts of any kind are the reference, or the file says why not") {
    const Counts counts = check_random(Features::small(), 970'000, 400);
    if (case_count(400) >= 100) CHECK(5 * counts.complete >= case_count(400));
}

TEST_CASE("SFC: random sequences are the reference to the end") {
    Counts counts;
    const Property property = [&](const RandomCase& item) { return compare(item, counts); };
    const std::size_t count = case_count(300);
    for (std::uint64_t seed = 990'000; seed < 990'000 + count; ++seed) {
        RandomSource random(seed);
        RandomCase item{sequence_chart(random), ""};
        std::string messages;
        const auto grafcet = read_grafcet(item.chart, &messages);
        REQUIRE_MESSAGE(grafcet, messages << item.chart);
        item.stimuli = random_stimuli(random, *grafcet, 30);
        if (property(item).empty()) continue;
        const RandomCase small = shrunk(item, property);
        FAIL("seed " << seed << ": " << property(small) << "\n--- chart\n"
                     << small.chart << "--- stimuli\n"
                     << small.stimuli << "--- end");
    }
    say(counts);
    CHECK(counts.complete == count);
}

TEST_CASE("SFC: plain random charts are the reference") {
    const Counts counts = check_random(Features::plain_chart(), 980'000, 100);
    CHECK(counts.beyond == 0);
}

}  // namespace grafwire::testing
