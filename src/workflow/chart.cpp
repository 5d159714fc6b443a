// A chart is what every use case begins with.

#include "workflow/chart.h"

#include "equations/wiring_hazards.h"
#include "grafcet/format_grafcet.h"
#include "grafcet/parse_grafcet.h"

namespace grafwire {

std::optional<Chart> read_chart(SourceFile source, Diagnostics& diagnostics) {
    std::optional<Grafcet> grafcet = parse_grafcet(source, diagnostics);
    if (!grafcet) return std::nullopt;
    return Chart{std::move(source), std::move(*grafcet), diagnostics.items()};
}

std::optional<std::string> format_chart(const SourceFile& source, Language keywords,
                                        Diagnostics& diagnostics) {
    return format_grafcet(source, keywords, diagnostics);
}

bool add_assumption(const SourceFile& source, Chart& chart, Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.error_count();
    parse_assumption(source, chart.grafcet, diagnostics);
    return diagnostics.error_count() == errors;
}

Diagnostics wiring_warnings(const Chart& chart, CdxForm cdx) {
    Diagnostics diagnostics;
    warn_of_wiring(chart.grafcet, cdx, diagnostics);
    diagnostics.sort_by_place();
    return diagnostics;
}

std::string_view name_of(CdxForm form) {
    for (const CdxRow& row : cdx_table) {
        if (row.form == form) return row.name;
    }
    return {};
}

std::string equation_report(const Chart& chart, const EquationOptions& options,
                            const EquationReport& report) {
    return write_equations(chart.grafcet, equations_from(chart.grafcet, options), report);
}

}  // namespace grafwire
