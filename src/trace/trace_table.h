#pragma once

#include <cstddef>
#include <string>

#include "grafcet/grafcet.h"
#include "text/message.h"
#include "trace/trace.h"

namespace grafwire {

/// How a table is shown.
struct TableLook {
    std::size_t width = 80;      ///< columns that a line may take
    bool is_emphasised = false;  ///< the head in bold (ECMA-48), which says nothing by itself
};

/// A trace for people, at a terminal. Where all columns fit, they stand side by side as in the CSV
/// text; else each group of columns becomes one that names what is 1 in it, and what does not fit
/// into a line of its cell goes on below:
///
///     time_ms  inputs      situation  outputs
///           0  top         X1         -
///        1000  start, top  X2         SPINDLE, DOWN
///
/// The trace has the columns of the GRAFCET (empty_trace). A word that is wider than its column is
/// cut in the middle of a line rather than lost.
std::string write_trace_table(const Trace& trace, const Grafcet& grafcet, const TableLook& look,
                              Language language);

}  // namespace grafwire
