#include "plc/long_times.h"

#include <regex>

namespace grafwire::testing {

std::string with_long_times(const std::string& chart) {
    static const std::regex microseconds("\\b1500us");
    static const std::regex seconds("\\b0\\.01s");
    static const std::regex milliseconds("\\b([1-5])ms");
    std::string longer = std::regex_replace(chart, microseconds, "20ms");
    longer = std::regex_replace(longer, seconds, "0.1s");
    // Two digits, lest the 0 behind it be taken for one of the group.
    return std::regex_replace(longer, milliseconds, "$010ms");
}

Stimuli ten_times_as_long(Stimuli stimuli) {
    for (Stimuli::Change& change : stimuli.changes) change.at *= 10;
    stimuli.end *= 10;
    return stimuli;
}

}  // namespace grafwire::testing
