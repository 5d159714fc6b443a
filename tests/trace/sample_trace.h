#pragma once

#include "text/time.h"
#include "trace/trace.h"

namespace grafwire::testing {

/// Three rows of an input, an output whose name needs quoting, and a counter; an unknown value, a
/// negative one, a time of half a millisecond.
inline Trace sample_trace() {
    using Kind = Trace::Column::Kind;
    Trace trace;
    trace.columns = {{"a", 1, Kind::input}, {"a,b \"c\"", 1, Kind::output}, {"count", 4}};
    trace.times = {0, 1500 * microsecond, 2 * second};
    trace.values = {0, 1, -3, 1, Trace::unknown, 5, 1, 0, 5};
    return trace;
}

}  // namespace grafwire::testing
