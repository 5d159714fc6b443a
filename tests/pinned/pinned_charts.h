#pragma once

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <utility>

#include "support/slow_build.h"
#include "workflow/chart.h"

namespace grafwire::testing {

/// Under the sanitizers one chart of so many is tried.
inline constexpr std::uint64_t pinned_stride = is_slow_build ? 9 : 1;

/// A chart as the use cases take it; the test fails where the text has errors.
inline Chart pinned_chart(const std::string& text) {
    Diagnostics diagnostics;
    auto chart = read_chart({"chart.grafcet", text}, diagnostics);
    REQUIRE_MESSAGE(chart, text);
    return std::move(*chart);
}

}  // namespace grafwire::testing
