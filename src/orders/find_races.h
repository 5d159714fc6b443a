#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "grafcet/grafcet.h"
#include "orders/order_case.h"
#include "text/keep_going.h"
#include "trace/stimuli.h"

namespace grafwire {

/// What is asked of a search for races.
struct RaceOptions {
    bool has_modes = true;        ///< whether Init, AUdur and AUdoux change as well
    std::uint64_t max_cases = 0;  ///< to end after this many; 0: no bound
    KeepGoing keep_going{};       ///< to end once it says no
    /// A chart with the same names that is to come to the same in every case; nullptr: none. It
    /// must outlive the search.
    const Grafcet* like = nullptr;
};

/// A race, and stimuli that lead there: it is at their last instant.
struct FoundRace {
    OrderRace race;
    Stimuli stimuli;
};

/// What came of a search.
struct RaceReport {
    /// Of every two transitions and kind the case that takes the fewest instants, in the order in
    /// which they were found.
    std::vector<FoundRace> races;
    std::uint64_t cases = 0;
    bool is_complete = false;  ///< every case that can be reached was looked at, in every order
    /// The last instant is the first at which the chart and the one it is to be like differ.
    std::optional<Stimuli> unlike;
};

/// Looks for races in every case that can be reached, with one change of an input, or the end of
/// delays, at a time.
RaceReport find_races(const Grafcet& grafcet, const RaceOptions& options = {});

}  // namespace grafwire
