// Texts with random damage are read without harm: there is a GRAFCET, or errors that point into the
// text.

#include <doctest/doctest.h>

#include <algorithm>

#include "grafcet/parse_grafcet.h"
#include "random/random_cases.h"
#include "random/random_source.h"
#include "random/read_text.h"
#include "trace/stimuli.h"

namespace grafwire::testing {

namespace {

const std::vector<std::string> scraps{
    "graph", "{",  "}",  "->",   ":",  ":=",   "(",      ")",     "[",      "]", ",",  "initial",
    "step",  "on", "if", "↑",    "/",  "3s",   "\"",     "#",     "macro",  "=", "do", "encloses",
    "INIT",  "*",  "..", "\xff", "\n", "\xc3", "assume", "entry", "999999", "X", "é",  "⊕"};

std::string damaged(RandomSource& random, std::string text) {
    for (std::size_t count = random.between(1, 4); count != 0 && !text.empty(); --count) {
        const std::size_t at = random.below(text.size());
        const std::size_t length = std::min(random.between(1, 12), text.size() - at);
        switch (random.below(5)) {
            case 0:
                text.erase(at, length);
                break;
            case 1:
                text.insert(at, random.pick(scraps));
                break;
            case 2:
                text.insert(random.below(text.size()), text.substr(at, length));
                break;
            case 3:
                text[at] = static_cast<char>(random.below(256));
                break;
            default:
                text.resize(std::max(at, text.size() / 2));
                break;
        }
    }
    return text;
}

/// Whether the outcome of a parser makes sense: a result if and only if there are no errors, and
/// every error within the text.
std::string fault_of_reading(bool has_result, const Diagnostics& diagnostics,
                             const SourceFile& source) {
    if (has_result == diagnostics.has_errors()) return "a result with errors, or neither";
    const auto lines =
        static_cast<std::uint32_t>(1 + std::count(source.text.begin(), source.text.end(), '\n'));
    for (const Diagnostic& item : diagnostics.items()) {
        if (item.message.english.empty()) return "an empty message";
        if (item.where.line > lines) return "a place behind the end: " + item.message.english;
        if (item.severity == Severity::error && !item.where.is_known()) {
            return "an error without a place: " + item.message.english;
        }
    }
    if (!diagnostics.items().empty() && format_diagnostics(diagnostics, source).empty()) {
        return "nothing is shown";
    }
    return {};
}

}  // namespace

TEST_CASE("damaged texts are read without harm") {
    const std::size_t count = case_count(8000);
    std::size_t refused = 0;
    for (std::uint64_t seed = 700'000; seed < 700'000 + count; ++seed) {
        RandomSource random(seed);
        const RandomCase whole = random_case(seed, Features(), 10);
        const SourceFile chart{"damaged.grafcet", damaged(random, whole.chart)};
        Diagnostics diagnostics;
        const auto grafcet = parse_grafcet(chart, diagnostics);
        std::string fault = fault_of_reading(grafcet.has_value(), diagnostics, chart);
        if (!fault.empty()) FAIL("seed " << seed << ": " << fault << "\n" << chart.text);
        if (!grafcet) ++refused;

        const auto intact = read_grafcet(whole.chart);
        const SourceFile stimuli{"damaged.stim", damaged(random, whole.stimuli)};
        Diagnostics of_stimuli;
        const auto read = parse_stimuli(stimuli, *intact, of_stimuli);
        fault = fault_of_reading(read.has_value(), of_stimuli, stimuli);
        if (!fault.empty()) FAIL("seed " << seed << ": " << fault << "\n" << stimuli.text);
    }
    // Most damage is noticed, but not all of it can be.
    CHECK(refused > count / 2);
    CHECK(refused < count);
}

}  // namespace grafwire::testing
