#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace grafwire::testing {

/// A GRAFCET and stimuli for it, both as text.
struct RandomCase {
    std::string chart;
    std::string stimuli;
};

/// Says in words what is wrong with a case; empty where nothing is.
using Property = std::function<std::string(const RandomCase&)>;

/// A smaller case, without errors, that still fails the property: lines (graphs, steps,
/// transitions, stimuli) and words (actions, parts of expressions) are dropped for as long as
/// something can be dropped, in at most `tries` runs of the property. The case given fails it.
RandomCase shrunk(const RandomCase& failing, const Property& property, std::size_t tries = 20'000);

}  // namespace grafwire::testing
