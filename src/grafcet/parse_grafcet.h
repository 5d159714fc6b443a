#pragma once

#include <optional>
#include <string_view>

#include "grafcet/grafcet.h"
#include "text/diagnostics.h"

namespace grafwire {

/// Reads a GRAFCET in the `.grafcet` language. All errors and warnings of the text go into
/// `diagnostics`, in the order of their places; the result is empty if there is any error.
std::optional<Grafcet> parse_grafcet(const SourceFile& source, Diagnostics& diagnostics);

/// Reads one expression over the inputs and control inputs of a GRAFCET, as written after `assume`,
/// and adds it to its assumptions. Errors (edges and time conditions included) go into
/// `diagnostics`; the GRAFCET is unchanged then.
void parse_assumption(const SourceFile& source, Grafcet& grafcet, Diagnostics& diagnostics);

}  // namespace grafwire
