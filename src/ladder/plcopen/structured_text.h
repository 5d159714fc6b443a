#pragma once

#include <string>
#include <vector>

#include "grafcet/grafcet.h"

namespace grafwire::ladder {

/// The names that a sequential function chart gives to the things of a GRAFCET: identifiers, those
/// of the chart's own variables the same as in the ladder diagram.
struct SfcNames {
    std::vector<std::string> inputs;  ///< with Init, AUdur, AUdoux
    std::vector<std::string> outputs;
    std::vector<std::string> steps;  ///< `X5`; its flag is `X5.X`, its time `X5.T`
    std::vector<std::string> vars;
    std::vector<std::string> counters;
    std::vector<std::string> edges;  ///< bits that the action `observe` works out
    std::vector<std::string> times;
};

SfcNames sfc_names(const Grafcet& grafcet);

/// An expression or a sum in Structured Text (IEC 61131-3).
std::string structured_text(const Grafcet& grafcet, const SfcNames& names, ExprId id);
std::string structured_text(const SfcNames& names, const Sum& sum);
/// A stored write as a statement.
std::string structured_text(const Grafcet& grafcet, const SfcNames& names, const Write& write);
/// The statements that work out edges and time conditions, once a scan; empty where there are none.
/// Their function blocks are named edge0, timer0 ….
std::string observing_text(const Grafcet& grafcet, const SfcNames& names);

/// A time condition that asks for nothing but the time of a step: `5s/X13`.
bool is_step_time(const Grafcet& grafcet, const TimeCondition& condition);

}  // namespace grafwire::ladder
