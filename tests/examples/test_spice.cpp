// The decks of the examples in ngspice, in batch.

#include <doctest/doctest.h>

#include <map>
#include <sstream>
#include <vector>

#include "examples/example.h"
#include "formats/netlist_formats.h"
#include "formats/shared/bench.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

/// Which node of the deck carries which name: the head says so, as `*   x1 = X1`.
std::map<std::string, std::string> nodes_of(const std::string& deck) {
    std::map<std::string, std::string> nodes;
    std::istringstream lines(deck);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t equals = line.find(" = ");
        if (line.rfind("*   ", 0) != 0 || equals == std::string::npos) continue;
        nodes[line.substr(equals + 3)] = line.substr(4, equals - 4);
    }
    return nodes;
}

/// The values of the sampled nodes, instant after instant: those in the rows of a table of `eprint`
/// in which the first node, the one that samples, has come back to 0.
using Samples = std::vector<std::map<std::string, std::string>>;
Samples samples_in(const std::string& output) {
    Samples samples;
    std::vector<std::string> names;
    std::size_t sample = 0;
    bool in_head = false;
    bool was_up = false;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        if (line == "Time or Step") {
            in_head = true;
            was_up = false;
            sample = 0;
            names.clear();
        } else if (in_head) {
            in_head = !line.empty();
            if (in_head) names.push_back(line);
        } else if (!names.empty() && !line.empty() && line[0] >= '0' && line[0] <= '9') {
            std::istringstream words(line);
            std::string moment;
            words >> moment;
            std::map<std::string, std::string> row;
            for (const std::string& name : names) words >> row[name];
            const bool is_up = row[names[0]] == "1s";
            if (was_up && !is_up) {
                if (sample == samples.size()) samples.emplace_back();
                samples[sample++].insert(row.begin(), row.end());
            }
            was_up = is_up;
        }
    }
    return samples;
}

/// A scan period that makes some hundred scans of the stimuli: ngspice takes seconds for a
/// thousand.
Time period_for(const Stimuli& stimuli) {
    constexpr Time most_scans = 400;
    return (stimuli.end / (most_scans * scan_period) + 1) * scan_period;
}

void check_in_ngspice(const AgreeingNetlist& item) {
    const Example& example = *item.example;
    const Time period = period_for(example.stimuli);
    const Trace trace = item.netlist.is_clocked()
                            ? run_scans(example.grafcet, example.stimuli, period).trace
                            : example.reference.trace;
    const Bench bench = bench_from(item.netlist, item.example->stimuli, trace.times);
    const std::string deck = write_netlist(*netlist_format_named("spice"), item.netlist,
                                           {.scan_period = period, .bench = bench});
    const ScratchFolder folder;
    const Ran ran = run_program({"ngspice", "-b", folder.file("deck.cir", deck)});
    INFO("standard error: " << ran.err);
    CHECK(ran.status == 0);
    auto nodes = nodes_of(deck);
    Samples samples = samples_in(ran.out);
    REQUIRE(samples.size() == trace.row_count());
    for (std::size_t row = 0; row < samples.size(); ++row) {
        INFO("at " << format_milliseconds(trace.times[row]) << " ms");
        std::string ones;
        for (const Port& port : item.netlist.outputs) {
            const std::string value = samples[row]["_" + nodes[port.name]];
            CHECK((value == "0s" || value == "1s"));
            if (value == "1s") ones += port.name + ' ';
        }
        CHECK(ones == ones_of(item.example->grafcet, trace, row));
    }
}

bool has_clocked_timers(const AgreeingNetlist& item) {
    return item.netlist.is_clocked() &&
           !item.example->grafcet.expressions.time_conditions().empty();
}

}  // namespace

TEST_CASE("ngspice gives the reference's situations and outputs") {
    std::size_t count = 0;
    std::size_t with_clocked_timers = 0;
    for (const AgreeingNetlist& item : agreeing_netlists()) {
        INFO("netlist: " << item.name());
        check_in_ngspice(item);
        ++count;
        if (has_clocked_timers(item)) ++with_clocked_timers;
        if (is_slow_build && count == 4) break;
    }
    CHECK(count == (is_slow_build ? 4U : 55U));
    if (!is_slow_build) CHECK(with_clocked_timers == 4);
}

}  // namespace grafwire::testing
