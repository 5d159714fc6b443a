#pragma once

#include <memory>
#include <string>

#include "support/plc_machine.h"

namespace grafwire::testing {

/// An S7-300 with a program in Statement List: status bits /FC, RLO and OR, a stack of seven
/// parentheses, two accumulators, bit memory in bytes, S5 timers (SE, SA) and SFB 4 and 5. OB 100
/// runs once, OB 1 in every scan; bit memory and the states of timers before OB 100 are those of
/// retentive memory, whatever they are. Shares nothing with what writes such programs.
std::unique_ptr<PlcMachine> awl_machine(const std::string& text, const Grafcet& grafcet);
std::unique_ptr<PlcMachine> awl_machine_international(const std::string& text,
                                                      const Grafcet& grafcet);

}  // namespace grafwire::testing
