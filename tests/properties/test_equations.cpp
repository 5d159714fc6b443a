// The equations against the reference.
//
// Transition form: one evaluation of all right-hand sides on the situation before a scan gives the
// situation after it, for every GRAFCET without orders and enclosures (those act on the new
// situation, which no single evaluation sees).
//
// Successor form: right-hand sides evaluated again and again, as gates would, lead to the stable
// situation of the reference, for plain charts.

#include <doctest/doctest.h>

#include "equations/equations.h"
#include "properties/evaluate_equations.h"
#include "random/random_cases.h"
#include "random/read_text.h"

namespace grafwire::testing {

namespace {

std::vector<bool> bits_of(const BitTable& table) {
    std::vector<bool> bits;
    for (std::size_t i = 0; i < table.size(); ++i) bits.push_back(table.test(i));
    return bits;
}

struct StepExpressions {
    Equations equations;
    std::vector<ExprId> steps;

    StepExpressions(const Grafcet& grafcet, CdxForm form)
        : equations(equations_from(grafcet, {form, true})) {
        for (std::size_t i = 0; i < grafcet.steps.size(); ++i) {
            const StepId step = grafcet.steps.id_at(i);
            steps.push_back(step_expression(equations, step, equations.expressions));
        }
    }
    std::vector<bool> next(const EquationValues& values) const {
        std::vector<bool> situation;
        for (const ExprId id : steps) situation.push_back(equation_value(equations, id, values));
        return situation;
    }
};

std::string transition_form_is_a_scan(const RandomCase& item) {
    const auto grafcet = read_grafcet(item.chart);
    const auto stimuli = read_stimuli(item.stimuli, *grafcet);
    const StepExpressions form(*grafcet, CdxForm::transition);
    const Evolution evolution(*grafcet);
    InputValues inputs(grafcet->all_input_count(), 0);
    EvolutionState state = evolution.start({inputs});
    for (const Stimuli::Change& change : stimuli->changes) {
        for (const auto& set : change.assignments) inputs[set.input] = set.value;
        for (int scan = 0; scan < 3; ++scan) {
            EvolutionState read = state;
            evolution.scan(state, {inputs}, change.at);
            read.edges = state.edges;  // of this scan; all else is as it was before
            const std::vector<bool> computed = form.next({bits_of(read.situation), &read, &inputs});
            if (computed != bits_of(state.situation)) {
                return "another situation after scan " + std::to_string(scan) + " at " +
                       format_milliseconds(change.at) + " ms";
            }
            const OutputValues outputs = evolution.outputs(state, {inputs});
            for (const OutputEquation& output : form.equations.outputs) {
                const bool value = equation_value(form.equations, output.value,
                                                  {bits_of(state.situation), &state, &inputs});
                if (value != outputs.test(index_of(output.output))) return "another output";
            }
        }
    }
    return {};
}

std::string successor_form_settles(const RandomCase& item) {
    const auto grafcet = read_grafcet(item.chart);
    const auto stimuli = read_stimuli(item.stimuli, *grafcet);
    const StepExpressions form(*grafcet, CdxForm::successor);
    const Evolution evolution(*grafcet);
    InputValues inputs(grafcet->all_input_count(), 0);
    EvolutionState state = evolution.start({inputs});
    std::vector<bool> wired = bits_of(state.situation);
    for (const Stimuli::Change& change : stimuli->changes) {
        for (const auto& set : change.assignments) inputs[set.input] = set.value;
        if (!evolution.settle(state, {inputs}, change.at).stable) return {};
        std::size_t rounds = 0;
        for (;; ++rounds) {
            const std::vector<bool> next = form.next({wired, &state, &inputs});
            if (next == wired) break;
            if (rounds > 4 * wired.size() + 4) return "does not settle";
            wired = next;
        }
        if (wired != bits_of(state.situation)) {
            return "settles elsewhere at " + format_milliseconds(change.at) + " ms";
        }
    }
    return {};
}

}  // namespace

TEST_CASE("the equations in transition form are one scan") {
    Features features;
    features.orders = false;
    features.enclosures = false;
    check_property(transition_form_is_a_scan, features, 800'000, 6000, 20);
}

TEST_CASE("the equations in successor form settle where the reference does, for plain charts") {
    check_property(successor_form_settles, Features::plain_chart(), 900'000, 6000, 20);
}

}  // namespace grafwire::testing
