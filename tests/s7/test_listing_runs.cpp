// A generated listing, run in the machine, is the reference: on random charts over the whole
// language, on every example, and in wide tables.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>

#include "evolution/run.h"
#include "program/messages.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "s7/check_listing.h"
#include "s7/messages.h"
#include "s7/run_generated.h"
#include "s7/write_listing.h"
#include "support/listings.h"

namespace grafwire::testing {

namespace {

/// How many charts ran, and how many the generator refused for want of timers.
struct Count {
    std::size_t run = 0;
    std::size_t refused = 0;
};

std::string told(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& item : diagnostics.items()) text += item.message.english + "\n";
    return text;
}

/// What is wrong with reading the text of a listing back; empty where nothing is.
std::string read_back(s7::Listing listing) {
    listing.head.clear();
    const std::string text = s7::write_listing(listing, {});
    Diagnostics diagnostics;
    const auto read = s7::parse_listing({"generated.awl", text}, {}, diagnostics);
    if (!read) {
        const bool is_long = diagnostics.items().front().code == code::program_too_long;
        return is_long ? "" : "not read: " + told(diagnostics);
    }
    if (!diagnostics.items().empty()) return "read with warnings: " + told(diagnostics);
    return s7::write_listing(*read, {}) == text ? "" : "read otherwise\n" + text;
}

/// What is wrong with the listing of a chart; empty where nothing is.
std::string compare(const Grafcet& grafcet, const Stimuli& stimuli,
                    const s7::ListingOptions& options, std::initializer_list<Time> periods,
                    Count& count) {
    const ScanProgram program = program_from(grafcet, {});
    Diagnostics diagnostics;
    const auto generated = s7::listing_from(grafcet, program, options, diagnostics);
    if (!generated) {
        for (const Diagnostic& item : diagnostics.items()) {
            const bool for_timers = item.message.english.find("timer") != std::string::npos;
            if (item.code != code::beyond_limit || !for_timers)
                return "refused: " + item.message.english;
        }
        ++count.refused;
        return {};
    }
    ++count.run;
    Diagnostics checked;
    s7::check_listing(generated->listing, s7::Cpu::cpu_214, checked);
    for (const Diagnostic& item : checked.items()) {
        if (item.code != code::program_too_long) return "not accepted: " + told(checked);
    }
    const std::string reading = read_back(generated->listing);
    if (!reading.empty()) return reading;
    for (const Time period : periods) {
        std::string problem;
        const std::string expected = write_csv(run_scans(grafcet, stimuli, period).trace);
        const std::string got =
            write_csv(run_generated(*generated, grafcet, stimuli, period, problem));
        if (!problem.empty()) return problem;
        if (expected != got) {
            return "reference\n" + expected + "listing\n" + got +
                   s7::write_listing(generated->listing, {});
        }
    }
    return {};
}

std::string compare(const RandomCase& item, const s7::ListingOptions& options, Count& count) {
    const auto grafcet = read_grafcet(item.chart);
    const auto stimuli = read_stimuli(item.stimuli, *grafcet);
    return compare(*grafcet, *stimuli, options, {millisecond, 1500 * microsecond}, count);
}

}  // namespace

TEST_CASE("the listing of a chart without much time is the reference") {
    Features features;
    features.time_conditions = 1;
    features.off_delays = false;
    Count count;
    check_property([&](const RandomCase& item) { return compare(item, {}, count); }, features,
                   930'000, 600, 15);
    CHECK(count.run > 0);
    CHECK(count.refused < count.run);
}

TEST_CASE("the listing of any chart is the reference") {
    Count count;
    check_property([&](const RandomCase& item) { return compare(item, {}, count); }, Features(),
                   940'000, 600, 15);
    CHECK(count.run > 0);
    CHECK(count.refused > 0);  // there are two timers of 1 ms
}

TEST_CASE("the listing with wide tables is the reference") {
    s7::ListingOptions options;
    options.wide_tables = true;
    Features features;
    features.time_conditions = 2;
    Count count;
    check_property([&](const RandomCase& item) { return compare(item, options, count); }, features,
                   950'000, 300, 15);
    CHECK(count.run > 0);
}

TEST_CASE("the listings of all examples are the reference") {
    std::size_t examples = 0;
    Count count;
    for (const auto& entry : std::filesystem::directory_iterator(GRAFWIRE_ROOT "/examples")) {
        if (entry.path().extension() != ".stim") continue;
        std::string name = entry.path().stem().string();
        if (name == "positioning-axis-scan") name = "positioning-axis";
        CAPTURE(entry.path().string());
        const auto grafcet = read_grafcet(example_text(name + ".grafcet"));
        REQUIRE(grafcet);
        const auto stimuli = read_stimuli(example_text(entry.path().filename().string()), *grafcet);
        REQUIRE(stimuli);
        CHECK(compare(*grafcet, *stimuli, {}, {10 * millisecond, 7 * millisecond}, count) == "");
        ++examples;
    }
    CHECK(examples == 14);
    CHECK(count.run == examples);
}

TEST_CASE("a ring of 300 steps runs in wide tables") {
    std::string chart = "input a, b\noutput o, p\ngraph ring {\n  initial 0 : o\n";
    for (int s = 1; s < 300; ++s)
        chart += fmt::format("  step {}{}\n", s, s % 7 == 0 ? " : p" : "");
    for (int s = 0; s < 300; ++s) {
        chart += fmt::format("  {} -> {} : {}\n", s, (s + 1) % 300, s % 3 == 0 ? "↑a" : "a + b");
    }
    const auto grafcet = read_grafcet(chart + "}\n");
    REQUIRE(grafcet);
    std::string changes;
    for (int t = 0; t < 400; ++t)
        changes += fmt::format("{}ms : a={} b={}\n", 3 * t, t % 2, t % 3 % 2);
    const auto stimuli = read_stimuli(changes + "1300ms : end\n", *grafcet);
    REQUIRE(stimuli);
    s7::ListingOptions options;
    options.wide_tables = true;
    Count count;
    CHECK(compare(*grafcet, *stimuli, options, {millisecond, 2 * millisecond}, count) == "");
    CHECK(count.run == 1);
    Diagnostics diagnostics;
    CHECK_FALSE(s7::listing_from(*grafcet, program_from(*grafcet, {}), {}, diagnostics));
    CHECK(told(diagnostics) ==
          "the chart has 300 steps, and the tables of the method hold 80: wide tables (--tables "
          "wide) hold them all\n"
          "the chart has 300 transitions, and the tables of the method hold 160: wide tables "
          "(--tables wide) hold them all\n");
}

TEST_CASE("conditions deeper than the stack run") {
    std::string deep = "c ⊕ d";
    for (int i = 0; i < 9; ++i)
        deep = i % 2 == 0 ? "d + a.(" + deep + ")" : "/(b + /c.(" + deep + "))";
    const auto grafcet = read_grafcet("input a, b, c, d\noutput o\ngraph G {\n  initial 0 : o if " +
                                      deep + "\n  0 -> 0 : ↑(" + deep + ")\n}\n");
    REQUIRE(grafcet);
    std::string changes;
    for (int t = 0; t < 48; ++t) {
        changes +=
            fmt::format("{}ms : a={} b={} c={} d={}\n", t, t % 2, t / 2 % 2, t / 4 % 2, t / 8 % 2);
    }
    const auto stimuli = read_stimuli(changes + "60ms : end\n", *grafcet);
    REQUIRE(stimuli);
    Count count;
    CHECK(compare(*grafcet, *stimuli, {}, {millisecond}, count) == "");
    CHECK(count.run == 1);
}

TEST_CASE("more than 16 graphs run in wide tables") {
    std::string chart = "input a, b\noutput o\ngraph master {\n  initial 0\n  step 1 : ";
    for (int g = 1; g < 20; ++g) {
        chart += fmt::format("{}H{}{}", g == 1 ? "" : ", ", g, g % 2 == 0 ? "{*}" : "{INIT}");
    }
    chart += "\n  0 -> 1 : b\n  1 -> 0 : /b\n}\n";
    for (int g = 1; g < 20; ++g) {
        chart += fmt::format(
            "graph H{0} {{\n  initial {0}0 : o\n  step {0}1\n"
            "  {0}0 -> {0}1 : ↑a\n  {0}1 -> {0}0 : ↑a\n}}\n",
            g);
    }
    const auto grafcet = read_grafcet(chart);
    REQUIRE(grafcet);
    const auto stimuli = read_stimuli(
        "0ms : a=0\n10ms : a=1\n20ms : a=0 b=1\n30ms : a=1\n40ms : a=0\n50ms : b=0\n"
        "60ms : a=1\n80ms : end\n",
        *grafcet);
    REQUIRE(stimuli);
    s7::ListingOptions options;
    options.wide_tables = true;
    Count count;
    CHECK(compare(*grafcet, *stimuli, options, {millisecond}, count) == "");
    CHECK(count.run == 1);
}

TEST_CASE("counters beyond 16 bits run in double words") {
    const auto grafcet = read_grafcet(R"(
        input a
        output o
        counter n : -10000..50000
        counter m : 0..9
        graph G {
          initial 0 : n := n + 30000 + m on ↑a, m := m + 1 on ↓a
          step 1 : o, n := 5 - n + m + n - n
          0 -> 1 : [n + n > m + 39999]
          1 -> 0 : [n - m < 3 - m]
        })");
    REQUIRE(grafcet);
    std::string changes;
    for (int t = 0; t < 60; ++t) changes += fmt::format("{}ms : a={}\n", 2 * t, t % 2);
    const auto stimuli = read_stimuli(changes + "130ms : end\n", *grafcet);
    REQUIRE(stimuli);
    Count count;
    CHECK(compare(*grafcet, *stimuli, {}, {millisecond}, count) == "");
    CHECK(count.run == 1);
}

}  // namespace grafwire::testing
