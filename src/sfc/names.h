#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sfc/plan.h"

namespace grafwire::sfc {

/// The names in a sequential function chart: identifiers, those of the chart's own variables the
/// same as in the ladder diagram.
struct Names {
    std::vector<std::string> inputs;  ///< with Init, AUdur, AUdoux
    std::vector<std::string> outputs;
    std::vector<std::string> steps;  ///< `X5`, its flag is `X5.X`; the auxiliary ones at the end
    std::vector<std::string> vars;
    std::vector<std::string> counters;
    std::string observer;  ///< the step whose action is executed last
    std::string started;   ///< 0 in the first scan only
    /// By the operand of an edge: what it was in the scan before, `dcy_before`.
    std::map<ExprId, std::string> before;
    // Per time condition, empty where nothing reads it.
    std::vector<std::string> times;  ///< its bit
    std::vector<std::string> timers;
    std::vector<std::string> off_timers;
    std::map<Variable, std::string> copies;  ///< `X5_then`: when the scan began
    std::map<std::size_t, std::string> time_copies;
};

Names names_of(const Plan& plan);

}  // namespace grafwire::sfc
