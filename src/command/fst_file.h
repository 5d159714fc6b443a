#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "text/message.h"

namespace grafwire {

/// Whether this program was built with the library that writes FST.
bool can_write_fst();

/// Makes of a waveform in VCD, as VcdWriter gives it, one in FST, the compressed format of GTKWave
/// (its user's guide, appendix F). It passes through a folder for temporary files, since the
/// library only writes to paths. Returns what went wrong, or nothing. Not to be called unless
/// can_write_fst().
std::optional<Localized> make_fst(std::string_view vcd, std::string& fst);

}  // namespace grafwire
