#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plc/shared/plc_options.h"
#include "plc/shared/program_names.h"
#include "plc/shared/source_text.h"
#include "program/program.h"
#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

// What the programs in C, Pascal and Python share.

/// The name of the function, procedure or method that does a section: `test_conditions`.
std::string_view section_function(SectionKind section);

/// What holds the bits of a kind, in every language: the table of the method (`Ts`, `Tt`, `Tfig`
/// …), or `inputs`, `outputs`, `vars`, `edge`, `memory`, `time`.
std::string_view holder_name(BitKind kind);

/// A delay in whole microseconds, the unit of the programs' clocks. One that is finer counts as the
/// next whole one: a clock of whole microseconds cannot tell the two apart.
std::int64_t microseconds(Time delay);

/// Whether all integers of the program fit in 64 bits; where they do not, says which do not.
bool check_integers(const Grafcet& grafcet, const ScanProgram& program, std::string_view language,
                    Diagnostics& diagnostics);

/// The comment at the head of a file: the chart's name and title, then what the file is and how it
/// was made.
void write_title(SourceText& out, const Grafcet& grafcet, const Localized& kind,
                 const PlcOptions& options);
/// And at its end: the names that differ from those of the chart.
void write_changed_names(SourceText& out, const ProgramNames& names, Language language);

/// Whether the comment of a statement says more than the statement itself, where that works on
/// whole tables: `Tp = Ts` does not.
bool says_more(const Statement& statement);

/// The heading of the trace (Trace, `time_ms,…`), cut at commas into parts of some 70 bytes.
std::vector<std::string> trace_heading(const Grafcet& grafcet);

}  // namespace grafwire
