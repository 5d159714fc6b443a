#pragma once

#include <optional>

#include "core/arguments.h"
#include "core/check_progress.h"
#include "core/json.h"
#include "workflow/check.h"

namespace grafwire::playground {

struct Checked {
    Chart chart;
    Judgement judgement;
};

/// Checks the netlist that the arguments ask for, or the file `against`. Where it returns nothing
/// the reason is in `answer`.
std::optional<Checked> asked_judgement(const Arguments& arguments, const CheckProgress& progress,
                                       bool with_files, Json& answer);

}  // namespace grafwire::playground
