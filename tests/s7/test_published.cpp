// The corrected listings of the three applications do what their GRAFCETs say, scan by scan: X and
// outputs; what the table of assignment has no address for is not compared. (They know no Init,
// AUdur and AUdoux; the stimuli go without.)

#include <doctest/doctest.h>

#include "evolution/run.h"
#include "random/read_text.h"
#include "s7/machine/binding.h"
#include "s7/machine/run_listing.h"
#include "support/listings.h"

namespace grafwire::testing {

using namespace s7;

namespace {

Stimuli without_control_inputs(Stimuli stimuli, const Grafcet& grafcet) {
    for (Stimuli::Change& change : stimuli.changes) {
        std::erase_if(change.assignments, [&](const Stimuli::Assignment& set) {
            return set.input >= grafcet.inputs.size();
        });
    }
    return stimuli;
}

struct Application {
    Application(const std::string& chart, const std::string& listing_name)
        : grafcet(*read_grafcet(example_text(chart + ".grafcet"))),
          listing(read_listing(example_text("s7-200/" + listing_name + ".awl"))),
          machine(listing, Cpu::cpu_214) {
        Diagnostics diagnostics;
        binding =
            *bind(grafcet, read_assignment(example_text("s7-200/" + chart + ".io")), diagnostics);
    }
    /// The traces of the reference and of the listing.
    std::pair<std::string, std::string> run(const std::string& stimuli_name, Time period) {
        const Stimuli stimuli = without_control_inputs(
            *read_stimuli(example_text(stimuli_name + ".stim"), grafcet), grafcet);
        const auto got = run_listing(machine, grafcet, binding, stimuli, period);
        CHECK_FALSE(got.failure);
        Trace expected = run_scans(grafcet, stimuli, period).trace;
        const std::size_t first_var = expected.columns.size() - grafcet.vars.size();
        for (std::size_t i = 0; i < expected.values.size(); ++i) {
            const std::size_t column = i % expected.columns.size();
            if (column >= first_var && !binding.vars[column - first_var]) expected.values[i] = 0;
        }
        return {write_csv(expected), write_csv(got.trace)};
    }
    Grafcet grafcet;
    Listing listing;
    Machine machine;
    Binding binding;
};

void check_same(const std::string& chart, const std::string& stimuli) {
    Application application(chart, chart);
    for (const Time period : {10 * millisecond, 35 * millisecond}) {
        const auto [expected, got] = application.run(stimuli, period);
        CHECK(expected == got);
    }
}

}  // namespace

TEST_CASE("corrected: the positioning axis") {
    check_same("positioning-axis", "positioning-axis");
    check_same("positioning-axis", "positioning-axis-scan");
}

TEST_CASE("corrected: the manipulator") {
    check_same("manipulator", "manipulator");
}

TEST_CASE("corrected: the manipulator with modes") {
    check_same("manipulator-modes", "manipulator-modes");
}

TEST_CASE("as printed none of them does") {
    for (const std::string chart : {"positioning-axis", "manipulator", "manipulator-modes"}) {
        Application application(chart, chart + ".printed");
        const auto [expected, got] = application.run(chart, 10 * millisecond);
        CHECK(expected != got);
    }
}

}  // namespace grafwire::testing
