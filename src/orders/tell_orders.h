#pragma once

#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "orders/interlock.h"
#include "text/message.h"

namespace grafwire {

// Races and interlocks in words. Sentences begin with a small letter and have no full stop, as
// messages do.

/// What races, and where.
Localized told_race(const Grafcet& grafcet, const OrderRace& race);
/// What it comes to, in both orders.
Localized told_ends(const Grafcet& grafcet, const OrderRace& race);
/// The place in the text that a race is about.
Location place_of(const Grafcet& grafcet, const OrderRace& race);

/// Which transition waits for which, and the receptivity that it has with all interlocks.
Localized told_interlock(const InterlockedChart& chart, const Interlock& interlock);
/// All of a chart, one a line, indented.
Localized told_interlocks(const InterlockedChart& chart);

}  // namespace grafwire
