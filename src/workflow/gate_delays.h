#pragma once

#include <utility>

#include "netlist/delay_model.h"
#include "netlist/delay_schedule.h"

namespace grafwire {

/// How long the gates of a simulation take: what a model says, and what a schedule says of single
/// gates.
struct GateDelays {
    DelayModel model;
    DelaySchedule schedule;

    // NOLINTNEXTLINE(google-explicit-constructor): a model alone is such delays too.
    GateDelays(const DelayModel& of_all, DelaySchedule of_some = {})
        : model(of_all), schedule(std::move(of_some)) {}
};

}  // namespace grafwire
