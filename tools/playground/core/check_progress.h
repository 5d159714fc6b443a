#pragma once

#include <functional>

#include "check/check_result.h"

namespace grafwire::playground {

/// Shown how far a check is, many times a second; the check ends undecided once it says no.
using CheckProgress = std::function<bool(const Coverage&)>;

}  // namespace grafwire::playground
