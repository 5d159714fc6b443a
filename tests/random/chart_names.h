#pragma once

#include <string>
#include <vector>

#include "random/features.h"
#include "random/random_source.h"

namespace grafwire::testing {

/// The names that a random GRAFCET declares, as they are written (quoted where they have to be).
struct ChartNames {
    std::vector<std::string> inputs;
    std::vector<std::string> continuous_outputs;
    std::vector<std::string> stored_outputs;
    std::vector<std::string> vars;
    std::vector<std::string> counters;
    std::vector<std::string> x_variables;  ///< of steps, macro-steps and graphs
};

/// A name that ends in `number`, which makes it unique: `a7`, `été7`, `"the 7"`. Never begins with
/// X, so that it is no variable of a step.
std::string random_name(RandomSource& random, const Features& features, const std::string& stem,
                        std::size_t number);
/// The name of a step: a number or such a name.
std::string random_step_name(RandomSource& random, const Features& features, std::size_t number);
/// The variable of a step, macro-step or graph.
std::string x_variable(const std::string& name);

}  // namespace grafwire::testing
