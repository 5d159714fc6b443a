#pragma once

#include <vector>

#include "sfc/names.h"
#include "sfc/plan.h"
#include "text/message.h"

namespace grafwire::sfc {

/// What the reader of a sequential function chart is told in its file.
struct Remark {
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
    Localized text;
};

/// The remarks in the order in which they stand in the file.
std::vector<Remark> remarks_of(const Plan& plan, const Names& names);
std::vector<Remark> remarks_of(const Grafcet& grafcet);

}  // namespace grafwire::sfc
