#pragma once

#include "core/json.h"
#include "grafcet/grafcet.h"
#include "text/time.h"
#include "trace/stimuli.h"

namespace grafwire::playground {

/// Times are numbers of milliseconds in answers.
double in_milliseconds(Time time);

/// Stimuli as values: `{"instants":[{"at_ms":0,"set":{"a":1}}],"end_ms":0}`.
Json script_answer(const Stimuli& stimuli, const Grafcet& grafcet);

}  // namespace grafwire::playground
