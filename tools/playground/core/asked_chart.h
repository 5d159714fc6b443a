#pragma once

#include <optional>
#include <string>

#include "core/arguments.h"
#include "core/json.h"
#include "text/diagnostics.h"
#include "trace/stimuli.h"
#include "workflow/chart.h"
#include "workflow/netlists.h"

namespace grafwire::playground {

// What many requests begin with. All of these put the reason into `answer`, as `error` and what
// belongs to it, where they return nothing.

/// The messages about a text, with their places in it.
Json diagnostics_answer(const Diagnostics& diagnostics, std::string_view text, Language language);
/// The messages that have no place, as one text.
std::string texts_of(const Diagnostics& diagnostics, Language language);

/// `text`, under the name `file`; with what `assume` says of the plant.
std::optional<Chart> asked_chart(const Arguments& arguments, Json& answer);

/// `style`, `cdx`, `modes` and `delay`.
std::optional<NetlistOptions> asked_options(const Arguments& arguments, Json& answer);
/// The netlist that they ask for.
std::optional<Netlist> asked_netlist(const Arguments& arguments, const Chart& chart,
                                     const NetlistOptions& options, Json& answer);

/// `stimuli`, read for a chart.
std::optional<Stimuli> asked_stimuli(const Arguments& arguments, const Chart& chart, Json& answer);

/// A duration; where the argument is missing `value` is none, and `is_good` all the same.
struct AskedPeriod {
    std::optional<Time> value;
    bool is_good = true;
};
AskedPeriod asked_period(const Arguments& arguments, std::string_view name, Json& answer);

/// `at`, a moment of a run: `500ms`, or `0`.
std::optional<Time> asked_moment(const Arguments& arguments, Json& answer);

/// The row of a table that an argument names; the first one where it is missing.
template <typename Rows>
auto asked_row(const Arguments& arguments, std::string_view name, const Rows& rows, Json& answer)
    -> decltype(&*std::begin(rows));

/// What an `answer` says where an argument has a value that is not known.
Json unknown_value_answer(const Arguments& arguments, std::string_view name);

// Implementation.

template <typename Rows>
auto asked_row(const Arguments& arguments, std::string_view name, const Rows& rows, Json& answer)
    -> decltype(&*std::begin(rows)) {
    const std::string value = arguments.text(name);
    if (value.empty()) return &*std::begin(rows);
    for (const auto& row : rows) {
        if (row.name == value) return &row;
    }
    answer = unknown_value_answer(arguments, name);
    return nullptr;
}

}  // namespace grafwire::playground
