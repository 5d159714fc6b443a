#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "equations/equations.h"
#include "equations/report/write_equations.h"
#include "grafcet/grafcet.h"
#include "text/diagnostics.h"

namespace grafwire {

// The use cases of grafwire, from values to values and messages: what the command line, the library
// and any other front call. Nothing here reads or writes a file, prints, or ends the program.
//
// Messages about a text go into the Diagnostics handed over with it, with their places there.
// Messages about the request as a whole have no place.

/// A GRAFCET with the text it was read from.
struct Chart {
    SourceFile source;
    Grafcet grafcet;
    std::vector<Diagnostic> warnings;  ///< of the reader
};

/// Reads a GRAFCET; empty after an error.
std::optional<Chart> read_chart(SourceFile source, Diagnostics& diagnostics);

/// The text of a GRAFCET in the canonical layout, with its keywords in that language; empty after
/// an error.
std::optional<std::string> format_chart(const SourceFile& source, Language keywords,
                                        Diagnostics& diagnostics);

/// Adds what the plant never does, an expression as after `assume`; false after an error.
bool add_assumption(const SourceFile& source, Chart& chart, Diagnostics& diagnostics);

/// What the structure of the chart puts at risk in asynchronous wiring, by place.
Diagnostics wiring_warnings(const Chart& chart, CdxForm cdx);

/// The two forms of CDX by the names users write.
struct CdxRow {
    std::string_view name;
    CdxForm form;
};
inline constexpr CdxRow cdx_table[] = {
    {"successor", CdxForm::successor},
    {"transition", CdxForm::transition},
};
std::string_view name_of(CdxForm form);

/// The forms of a report on equations by the names users write.
struct EquationFormatRow {
    std::string_view name;
    std::string_view extension;  ///< of its files, with the dot
    EquationFormat format;
    /// The options that it uses, as they are called on the command line.
    std::string_view options;
};
inline constexpr EquationFormatRow equation_format_table[] = {
    {"text", ".txt", EquationFormat::text, "--karnaugh"},
    {"markdown", ".md", EquationFormat::markdown, "--karnaugh"},
    {"latex", ".tex", EquationFormat::latex, "--karnaugh --standalone"},
    {"csv", ".csv", EquationFormat::csv, ""},
    {"json", ".json", EquationFormat::json, "--karnaugh"},
};

/// Derives the equations of a chart and writes them down.
std::string equation_report(const Chart& chart, const EquationOptions& options,
                            const EquationReport& report);

}  // namespace grafwire
