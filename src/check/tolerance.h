#pragma once

#include <functional>
#include <optional>
#include <string>

#include "check/check_result.h"
#include "grafcet/grafcet.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"

namespace grafwire {

/// The netlist that is checked under a delay model; one that is made from a GRAFCET is made for it.
using NetlistFor = std::function<std::optional<Netlist>(const DelayModel&)>;

/// The model in which the longest delay is so many tenths of the shortest, which is 1 ns.
DelayModel delays_of_ratio(int tenths);

/// How much the delays of gates may differ for an asynchronous netlist to be right. Of the options
/// the delays do not count, and many changes at once are not looked at besides those asked for;
/// bounds on cases are those of each check by itself.
Tolerance find_tolerance(const Grafcet& grafcet, const NetlistFor& netlist_for,
                         const CheckOptions& options);

}  // namespace grafwire
