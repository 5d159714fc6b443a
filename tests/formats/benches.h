#pragma once

#include <utility>
#include <vector>

#include "formats/shared/bench.h"
#include "text/time.h"

namespace grafwire::testing {

constexpr Time ms = millisecond;

/// A bench that changes inputs and reads the outputs, without more.
inline Bench bench_of(std::vector<Stimuli::Change> changes, std::vector<Time> instants) {
    Bench bench;
    bench.stimuli.changes = std::move(changes);
    bench.instants = std::move(instants);
    return bench;
}

}  // namespace grafwire::testing
