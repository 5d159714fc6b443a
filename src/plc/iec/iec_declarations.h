#pragma once

#include <string>
#include <string_view>

#include "plc/iec/iec_names.h"
#include "program/program.h"
#include "text/diagnostics.h"
#include "text/language.h"

namespace grafwire {

/// What a program in a textual language of IEC 61131-3 begins with: a comment that says what it is
/// and which names had to be changed, then `FUNCTION_BLOCK …` and its variables. The inputs and
/// outputs of the block are those of the chart, in its order, with Init, AUdur and AUdoux after the
/// declared inputs; the first block of internal variables holds the vars and counters of the chart.
/// `textual_language` is what the comment calls the language of IEC 61131-3, in the language of all
/// comments.
///
/// An error where an integer needs more than the 64 bits of LINT; empty then.
std::string iec_declarations(const Grafcet& grafcet, const ScanProgram& program,
                             const IecNames& names, const Localized& textual_language,
                             Language language, Diagnostics& diagnostics);

}  // namespace grafwire
