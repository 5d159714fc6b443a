#include "support/plc_machine.h"

#include <doctest/doctest.h>

#include "evolution/run.h"
#include "random/read_text.h"
#include "support/files.h"

namespace grafwire::testing {

namespace {

void add_row(const PlcMachine& machine, const Grafcet& grafcet, const std::vector<bool>& inputs,
             Time now, Trace& trace) {
    trace.times.push_back(now);
    for (const bool input : inputs) trace.values.push_back(input ? 1 : 0);
    for (std::uint32_t i = 0; i < grafcet.steps.size(); ++i) {
        trace.values.push_back(machine.step(i) ? 1 : 0);
    }
    for (std::uint32_t i = 0; i < grafcet.outputs.size(); ++i) {
        trace.values.push_back(machine.output(i) ? 1 : 0);
    }
    for (std::uint32_t i = 0; i < grafcet.vars.size(); ++i) {
        trace.values.push_back(machine.var(i) ? 1 : 0);
    }
    for (std::uint32_t i = 0; i < grafcet.counters.size(); ++i) {
        trace.values.push_back(machine.counter(i));
    }
}

}  // namespace

Trace run_machine(PlcMachine& machine, const Grafcet& grafcet, const Stimuli& stimuli,
                  Time period) {
    Trace trace = empty_trace(grafcet);
    std::vector<bool> inputs(grafcet.all_input_count(), false);
    std::size_t next = 0;
    for (Time now = 0; now <= stimuli.end; now += period) {
        for (; next < stimuli.changes.size() && stimuli.changes[next].at <= now; ++next) {
            for (const auto& [input, value] : stimuli.changes[next].assignments) {
                inputs[input] = value;
                machine.set_input(input, value);
            }
        }
        machine.scan(now);
        add_row(machine, grafcet, inputs, now, trace);
    }
    return trace;
}

std::string difference(const PlcLanguage& language, const Grafcet& grafcet, const Stimuli& stimuli,
                       const std::vector<Time>& periods, std::size_t* refused) {
    const PlcFormat* format = plc_format_named(language.format);
    REQUIRE(format != nullptr);
    Diagnostics diagnostics;
    const std::string text =
        format->write(grafcet, program_from(grafcet, {}), language.options, diagnostics);
    if (diagnostics.has_errors()) {
        if (!text.empty()) return "a refusal with a text";
        if (diagnostics.items().front().message.english.empty())
            return "a refusal without a message";
        if (refused == nullptr) return "refused: " + diagnostics.items().front().message.english;
        ++*refused;
        return {};
    }
    for (const Time period : periods) {
        const std::string expected = write_csv(run_scans(grafcet, stimuli, period).trace);
        std::string got;
        try {
            got = write_csv(run_machine(*language.make(text, grafcet), grafcet, stimuli, period));
        } catch (const PlcError& error) {
            return error.what() + ("\n" + text);
        }
        if (expected != got) return "reference\n" + expected + "program\n" + got + text;
    }
    return {};
}

std::size_t check_examples(const PlcLanguage& language) {
    std::size_t count = 0;
    std::size_t refused = 0;
    for (const std::string& name : example_names()) {
        ++count;
        const auto grafcet = read_grafcet(example_text(name + ".grafcet"));
        REQUIRE(grafcet);
        const auto stimuli = read_stimuli(example_text(name + ".stim"), *grafcet);
        REQUIRE(stimuli);
        const std::string found =
            difference(language, *grafcet, *stimuli, {10 * millisecond, 7 * millisecond}, &refused);
        CHECK_MESSAGE(found.empty(), name << ": " << found);
    }
    CHECK(count == 13);
    return refused;
}

}  // namespace grafwire::testing
