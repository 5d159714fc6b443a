#pragma once

#include <string>
#include <string_view>

#include "formats/shared/append.h"
#include "netlist/delay_model.h"
#include "text/time.h"

namespace grafwire {

/// A time as an expression that grows with the delay of the gates, for formats whose files have a
/// parameter for that: `gate`, `3 * gate`. The unit is that of the parameter.
inline std::string in_gate_delays(Time time, const DelayModel& delays, std::string_view parameter) {
    std::string text;
    if (time % delays.gate.max != 0) {
        append(text, '(', time, ".0 / ", delays.gate.max, ") * ");
    } else if (time != delays.gate.max) {
        append(text, time / delays.gate.max, " * ");
    }
    return text += parameter;
}

}  // namespace grafwire
