// Every command on every example.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "support/run_program.h"
#include "support/slow_build.h"

namespace grafwire::testing {

namespace {

std::vector<std::string> styles() {
    return choices_of("netlist", "--style");
}

bool has_counters(const std::string& name) {
    return name == "batch-counter" || name == "level-crossing" || name == "press";
}

/// All of them; every third where everything takes many times longer.
std::vector<std::string> sampled_examples() {
    std::vector<std::string> names = example_names();
    if (!is_slow_build) return names;
    std::vector<std::string> some;
    for (std::size_t i = 0; i < names.size(); i += 3) some.push_back(names[i]);
    return some;
}

/// Warnings may be, errors may not.
void check_no_error(const Ran& ran) {
    CHECK(!contains(ran.err, "error"));
    CHECK(ran.err.empty() == !contains(ran.err, ": warning: "));
}

/// Runs it twice: done both times, with the same bytes, which are not none.
std::string result_of(const std::vector<std::string>& request) {
    const Ran first = grafwire_with(request);
    INFO("standard error: " << first.err);
    CHECK(first.status == 0);
    check_no_error(first);
    CHECK(!first.out.empty());
    if (!is_slow_build) CHECK(grafwire_with(request).out == first.out);
    return first.out;
}

void check_refusal(const std::vector<std::string>& request, const std::string& style) {
    const Ran ran = grafwire_with(request);
    CHECK(ran.status == 2);
    CHECK(ran.out.empty());
    CHECK(contains(ran.err, "the " + style + " style "));
}

/// Counters are refused by all styles but clocked; handshake cannot have some other things either.
bool is_refused(const std::string& name, const std::string& style) {
    if (has_counters(name)) return style != "clocked";
    return style == "handshake" &&
           (name == "manipulator-modes" || name == "positioning-axis" || name == "rule-5");
}

}  // namespace

TEST_CASE("there are thirteen examples, each with stimuli and a row in the README") {
    const std::vector<std::string> names = example_names();
    CHECK(names.size() == 13);
    const std::string readme = text_of(example("README.md"));
    for (const std::string& name : names) {
        INFO("example: " << name);
        CHECK(std::filesystem::exists(example(name + ".stim")));
        CHECK(contains(readme, "\n| `" + name + "` |"));
    }
}

TEST_CASE("info on every example") {
    for (const std::string& name : example_names()) {
        INFO("example: " << name);
        CHECK(result_of({"info", example(name + ".grafcet")}).rfind("GRAFCET ", 0) == 0);
    }
}

TEST_CASE("equations of every example, in every form") {
    for (const std::string& name : sampled_examples()) {
        for (const std::string& form : choices_of("equations", "--to")) {
            for (const std::string cdx : {"successor", "transition"}) {
                for (const std::string modes : {"on", "off"}) {
                    INFO("example: " << name << ", form: " << form << ", cdx: " << cdx
                                     << ", modes: " << modes);
                    result_of({"equations", example(name + ".grafcet"), "--to", form, "--cdx", cdx,
                               "--modes", modes});
                }
            }
        }
    }
}

TEST_CASE("run and simulate every example") {
    for (const std::string& name : example_names()) {
        INFO("example: " << name);
        const std::string chart = example(name + ".grafcet");
        const std::string stim = example(name + ".stim");
        const std::string trace = result_of({"run", chart, stim});
        CHECK(trace.rfind("time_ms,", 0) == 0);
        result_of({"run", chart, stim, "--scan", "50ms"});
        CHECK(result_of({"simulate", chart, stim, "--style", "clocked"}) == trace);
        for (const std::string& style : styles()) {
            if (style == "clocked") continue;
            INFO("style: " << style);
            const std::vector<std::string> request{"simulate", chart, stim, "--style", style};
            if (is_refused(name, style)) {
                check_refusal(request, style);
                continue;
            }
            const Ran ran = grafwire_with(request);
            CHECK((ran.status == 0 || ran.status == 1));
            CHECK((ran.status == 1) == contains(ran.err, "does not settle at "));
            CHECK(ran.out.substr(0, ran.out.find('\n')) == trace.substr(0, trace.find('\n')));
        }
    }
}

TEST_CASE("the netlist of every example, in every style and format") {
    const std::vector<std::string> all = choices_of("netlist", "--to");
    for (const std::string format : {"verilog", "spice", "blif", "json", "dot"}) {
        CHECK(std::count(all.begin(), all.end(), format) == 1);
    }
    for (const std::string& name : sampled_examples()) {
        for (const std::string& style : styles()) {
            for (const std::string& format : all) {
                for (const std::string modes : {"on", "off"}) {
                    if (is_slow_build && modes == "off") continue;
                    INFO("example: " << name << ", style: " << style << ", format: " << format
                                     << ", modes: " << modes);
                    const std::vector<std::string> request{"netlist", example(name + ".grafcet"),
                                                           "--style", style,
                                                           "--to",    format,
                                                           "--modes", modes};
                    if (is_refused(name, style)) {
                        check_refusal(request, style);
                    } else {
                        result_of(request);
                    }
                }
            }
        }
    }
}

TEST_CASE("check every example, in every style, for a while") {
    for (const std::string& name : example_names()) {
        for (const std::string& style : styles()) {
            INFO("example: " << name << ", style: " << style);
            const std::vector<std::string> request{
                "check", example(name + ".grafcet"), "--style", style, "--max-cases", "500"};
            if (is_refused(name, style)) {
                check_refusal(request, style);
                continue;
            }
            const Ran ran = grafwire_with(request);
            check_no_error(ran);
            const std::string verdict = ran.status == 0   ? "equivalent"
                                        : ran.status == 1 ? "different"
                                                          : "undecided";
            CHECK(ran.status >= 0);
            CHECK(ran.status <= 3);
            CHECK(ran.status != 2);
            CHECK(contains(ran.out, name + ".grafcet: " + verdict + " (style " + style + ", "));
            CHECK(grafwire_with(request).out == ran.out);
        }
    }
}

}  // namespace grafwire::testing
