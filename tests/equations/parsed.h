#pragma once

#include <doctest/doctest.h>

#include <string>
#include <string_view>

#include "equations/equations.h"
#include "equations/minimise.h"
#include "equations/report/write_equations.h"
#include "grafcet/parse_grafcet.h"
#include "grafcet/write_grafcet.h"

namespace grafwire::testing {

/// A GRAFCET without errors.
inline Grafcet parsed(std::string_view text) {
    const SourceFile source{"test.grafcet", std::string(text)};
    Diagnostics diagnostics;
    std::optional<Grafcet> grafcet = parse_grafcet(source, diagnostics);
    INFO(format_diagnostics(diagnostics, source));
    REQUIRE(grafcet.has_value());
    return *std::move(grafcet);
}

/// The report of a GRAFCET in CSV.
inline std::string csv(std::string_view text, const EquationOptions& options) {
    const Grafcet grafcet = parsed(text);
    return write_equations(grafcet, equations_from(grafcet, options),
                           {.format = EquationFormat::csv});
}

inline constexpr EquationOptions with_modes{};
inline constexpr EquationOptions without_modes{.modes = false};

}  // namespace grafwire::testing
