// The stimuli of an example walk through its whole life.

#include <doctest/doctest.h>

#include <vector>

#include "evolution/evolution.h"
#include "examples/example.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

/// What has been active, and what has been cleared, in any scan: also in those between two stable
/// situations.
class Visits {
  public:
    explicit Visits(const Grafcet& grafcet)
        : grafcet_(grafcet),
          evolution_(grafcet),
          steps_(grafcet.steps.size()),
          transitions_(grafcet.transitions.size()) {}

    void walk_until_stable(const Trace& trace) {
        EvolutionState state;
        for (std::size_t row = 0; row < trace.row_count(); ++row) {
            const InputValues inputs = inputs_of(trace, row);
            const Time now = trace.times[row];
            if (row == 0) {
                state = evolution_.start({inputs});
            } else {
                evolution_.end_delays(state, {inputs}, now);
            }
            EvolutionState before;
            do {
                before = state;
                scan(state, inputs, now);
            } while (!Evolution::is_settled(before, state));
            compare(state, trace, row);
        }
    }
    void walk_scans(const Trace& trace) {
        EvolutionState state = evolution_.start({inputs_of(trace, 0)});
        for (std::size_t row = 0; row < trace.row_count(); ++row) {
            scan(state, inputs_of(trace, row), trace.times[row]);
            compare(state, trace, row);
        }
    }

    /// The names of what is left, each followed by a blank.
    std::string steps_left_out() const {
        std::string names;
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            if (!steps_[i]) names += grafcet_.steps.items()[i].name + ' ';
        }
        return names;
    }
    std::string transitions_left_out() const {
        std::string names;
        for (std::size_t i = 0; i < transitions_.size(); ++i) {
            if (!transitions_[i]) names += grafcet_.transitions.items()[i].name + ' ';
        }
        return names;
    }

  private:
    InputValues inputs_of(const Trace& trace, std::size_t row) const {
        InputValues inputs;
        for (std::size_t i = 0; i < grafcet_.all_input_count(); ++i) {
            inputs.push_back(trace.values[row * trace.columns.size() + i] != 0);
        }
        return inputs;
    }
    void scan(EvolutionState& state, const InputValues& inputs, Time now) {
        for (const TransitionId id : evolution_.cleared_by_scan(state, {inputs}, now)) {
            transitions_[index_of(id)] = true;
        }
        evolution_.scan(state, {inputs}, now);
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            if (state.situation.test(i)) steps_[i] = true;
        }
    }
    /// The walk is the run.
    void compare(const EvolutionState& state, const Trace& trace, std::size_t row) const {
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            const std::size_t column = grafcet_.all_input_count() + i;
            CHECK(state.situation.test(i) ==
                  (trace.values[row * trace.columns.size() + column] != 0));
        }
    }

    const Grafcet& grafcet_;
    Evolution evolution_;
    std::vector<bool> steps_;
    std::vector<bool> transitions_;
};

}  // namespace

TEST_CASE("the stimuli of every example: always a stable situation, no assumption broken") {
    for (const Example& example : examples()) {
        INFO("example: " << example.name);
        CHECK(!example.reference.unstable_at.has_value());
        CHECK(example.reference.broken_assumptions.empty());
        CHECK(example.reference.trace.times.back() == example.stimuli.end);
        CHECK(example.reference.trace.row_count() > 20);
    }
}

TEST_CASE("the stimuli of every example visit every step and clear every transition") {
    for (const Example& example : examples()) {
        INFO("example: " << example.name);
        Visits visits(example.grafcet);
        visits.walk_until_stable(example.reference.trace);
        CHECK(visits.steps_left_out() == "");
        // The request for the position at hand has no stable situation while the button is held.
        const bool is_axis = example.name == "positioning-axis";
        CHECK(visits.transitions_left_out() == std::string(is_axis ? "4 " : ""));
    }
}

TEST_CASE("the scan-by-scan stimuli of the positioning axis clear what is left") {
    const Example& axis = example_named("positioning-axis");
    const Stimuli stimuli = load_stimuli(example("positioning-axis-scan.stim"), axis.grafcet);
    CHECK(run_until_stable(axis.grafcet, stimuli).unstable_at == 100 * millisecond);
    const RunResult scans = run_scans(axis.grafcet, stimuli, 10 * millisecond);
    CHECK(scans.broken_assumptions.empty());
    Visits visits(axis.grafcet);
    visits.walk_until_stable(axis.reference.trace);
    visits.walk_scans(scans.trace);
    CHECK(visits.steps_left_out() == "");
    CHECK(visits.transitions_left_out() == "");
}

TEST_CASE("the modes are part of every life") {
    for (const Example& example : examples()) {
        INFO("example: " << example.name);
        const std::size_t controls = example.grafcet.inputs.size();
        for (std::size_t i = controls; i < controls + control_input_count; ++i) {
            INFO("control input: " << input_name(example.grafcet, i));
            bool is_set = false;
            for (const Stimuli::Change& change : example.stimuli.changes) {
                for (const auto& item : change.assignments) is_set |= item.input == i && item.value;
            }
            CHECK(is_set);
        }
    }
}

}  // namespace grafwire::testing
