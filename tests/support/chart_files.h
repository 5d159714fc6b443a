#pragma once

#include <string>
#include <vector>

namespace grafwire::testing {

/// A chart of examples/ and its stimuli, as text.
struct ChartFiles {
    std::string name;
    std::string chart;
    std::string stimuli;
};

/// All of them, in the order of their names; a chart with two stimuli occurs once.
const std::vector<ChartFiles>& example_charts();

}  // namespace grafwire::testing
