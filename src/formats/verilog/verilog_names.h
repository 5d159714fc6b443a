#pragma once

#include <string>
#include <string_view>

#include "netlist/netlist.h"

namespace grafwire {

/// A name as a Verilog identifier: as it stands where the language allows it, else escaped (`\H+ `,
/// with its closing blank). White space, control characters and the backquote, which no escaped
/// identifier can hold, are written `%20` and so on, `%` itself `%25`; and what simulators stumble
/// over, `"` and the asterisk of `/*`, `(*` and at the beginning, `%22` and `%2A`.
void spell_verilog(std::string& out, std::string_view name);

/// An identifier with something added to its name.
void append_verilog_with_suffix(std::string& out, std::string_view spelled,
                                std::string_view suffix);

/// Writes `name` as the contents of a Verilog string for $display.
void append_verilog_text(std::string& out, std::string_view text);

/// Writes a comment to the end of the line. One that begins with the name of a tool has a dash
/// before it: there are tools that obey comments such as `// synopsys translate_off`.
void append_verilog_comment(std::string& out, std::string_view text);

/// The parameter for the scan period: `SCAN_PS`, with `$` added where a net is called that.
std::string verilog_scan_parameter(const Netlist& netlist);

/// The parameter for the delay of a gate: `GATE_NS`, likewise.
std::string verilog_gate_parameter(const Netlist& netlist);

/// Whether `word` is reserved in Verilog (IEEE 1364-2005) or SystemVerilog (IEEE 1800-2017).
bool is_verilog_keyword(std::string_view word);

}  // namespace grafwire
