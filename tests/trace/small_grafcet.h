#pragma once

#include <doctest/doctest.h>

#include <string>
#include <string_view>

#include "grafcet/parse_grafcet.h"

namespace grafwire::testing {

/// Reads a GRAFCET that has no errors; fails the test with the messages otherwise.
inline Grafcet read_grafcet(std::string_view text) {
    const SourceFile source{"test.grafcet", std::string(text)};
    Diagnostics diagnostics;
    std::optional<Grafcet> grafcet = parse_grafcet(source, diagnostics);
    if (!grafcet) FAIL(format_diagnostics(diagnostics, source));
    return std::move(*grafcet);
}

}  // namespace grafwire::testing
