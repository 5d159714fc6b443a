#pragma once

#include <string>
#include <vector>

#include "explain/gate_story.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "text/message.h"

namespace grafwire {

/// What the gates did, instant by instant, with an empty line between them:
///
///     At 1000 ms: dcy=1
///       X1 becomes 1 after 3 ns: dcy=1, rising-edge pulse cell dcy$rise0=1 (+1 ns), NAND gate
///       X1$set0=0 (+2 ns)
///       X0 becomes 0 after 6 ns: X1=1, NAND gate X0$reset0=1 (+4 ns), NAND gate X0$q=1 (+5 ns)
///       stable situation after 6 ns: X1
///       outputs at 1: V+
///
/// (A line is not broken here.)
std::string write_gate_stories(const Grafcet& grafcet, const Netlist& netlist,
                               const std::vector<GateStory>& stories, Language language);

}  // namespace grafwire
