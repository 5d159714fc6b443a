#pragma once

#include <string>
#include <string_view>

#include "grafcet/parse_grafcet.h"
#include "simulate/simulate.h"
#include "support/small_netlist.h"
#include "trace/stimuli.h"

namespace grafwire::testing {

inline constexpr std::string_view two_steps_text = R"(
grafcet two
input a, b
output V
var k
counter c : -2..1
graph G {
  initial 0
  step 1 : V, set k
  0 -> 1 : a
  1 -> 0 : b + 3ms/X1
}
)";

Grafcet grafcet_of(std::string_view text);
Stimuli stimuli_of(std::string_view text, const Grafcet& grafcet);

/// The chart above wired by hand from latches: c is -2 + X1 + 2.k, for want of a true counter.
SmallNetlist two_steps_netlist(bool modes);

/// The same from flip-flops; k is left out, as is b.
SmallNetlist two_steps_clocked();

/// The trace as CSV.
std::string traced(const SimulateResult& result);

}  // namespace grafwire::testing
