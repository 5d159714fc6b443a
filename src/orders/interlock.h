#pragma once

#include <cstdint>
#include <vector>

#include "grafcet/grafcet.h"
#include "orders/find_races.h"

namespace grafwire {

/// An extra condition in a receptivity, which lets one transition wait until another has been
/// cleared or cannot be.
struct Interlock {
    TransitionId waiting{};
    TransitionId awaited{};
    ExprId condition = no_expr;  ///< of the interlocked chart
};

/// A chart whose receptivities have interlocks.
struct InterlockedChart {
    Grafcet grafcet;
    std::vector<Interlock> interlocks;  ///< in the order in which they were found
    /// What is left of the races, and how far that was looked at.
    RaceReport left;
};

/// Adds interlocks until there is no race, or none that an interlock would cure. An interlock is
/// taken only if the chart with it comes to what the original comes to, in every case that is
/// looked at. `races`: those of the chart, as find_races() gives them. The bounds of `options` are
/// those of each search; once all have taken `max_cases_in_all` no further interlock is looked for
/// (0: no bound).
InterlockedChart with_interlocks(const Grafcet& grafcet, RaceReport races,
                                 const RaceOptions& options, std::uint64_t max_cases_in_all = 0);

/// The receptivity of one transition with the condition that it waits for another; no_expr where
/// that would keep it from ever being cleared, or say nothing. Adds to the expressions of the
/// chart.
ExprId waiting_condition(Grafcet& grafcet, TransitionId waiting, TransitionId awaited);

}  // namespace grafwire
