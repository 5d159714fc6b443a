#pragma once

#include <string>

#include "grafcet/grafcet.h"

namespace grafwire::testing {

/// The first part in which two GRAFCETs differ, locations aside; empty where there is none.
/// Expressions are compared by their structure, whatever their ids.
std::string model_difference(const Grafcet& a, const Grafcet& b);

}  // namespace grafwire::testing
