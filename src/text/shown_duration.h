#pragma once

#include "text/message.h"
#include "text/time.h"

namespace grafwire {

/// A duration in a sentence: `1.5ms` as it is written in a chart; in French as it is written in
/// print, `1,5 ms`.
Localized shown_duration(Time duration);

}  // namespace grafwire
