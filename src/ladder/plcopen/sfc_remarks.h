#pragma once

#include <string>
#include <vector>

#include "ladder/plcopen/sfc_names.h"
#include "ladder/plcopen/sfc_plan.h"

namespace grafwire::ladder {

/// What the reader of a sequential function chart is told in its file.
struct SfcRemark {
    enum class Kind : std::uint8_t {
        scope,           ///< the first: what the chart is, and that it has no Init, AUdur, AUdoux
        observer,        ///< the step whose action must be executed last
        order,           ///< a forcing or freezing order, which SFC cannot say
        enclosure,       ///< likewise
        clearing,        ///< an action on clearing, likewise
        selection,       ///< transitions after one step that a GRAFCET can clear at once
        meeting_writes,  ///< actions that can write a variable in one scan, in an order left open
        initial_steps,   ///< a graph without one initial step, or with several: exact, but many
                         ///< tools refuse it
    };
    Kind kind = Kind::scope;
    std::string text;
};

/// The remarks in the order in which they stand in the file.
std::vector<SfcRemark> sfc_remarks(const SfcPlan& plan, const SfcNames& names);
std::vector<SfcRemark> sfc_remarks(const Grafcet& grafcet);

}  // namespace grafwire::ladder
