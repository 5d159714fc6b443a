#pragma once

#include <optional>

#include "core/arguments.h"
#include "core/json.h"
#include "workflow/drawings.h"

namespace grafwire::playground {

/// `notation`, `paper`, and what is shown of a run: `situation`, or the moment `at` of `stimuli`.
/// Where it returns nothing the reason is in `answer`.
std::optional<ChartDrawing> asked_drawing(const Arguments& arguments, const Chart& chart,
                                          Json& answer);

}  // namespace grafwire::playground
