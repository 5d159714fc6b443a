#pragma once

#include <string_view>

namespace grafwire {

// Patterns as shells write them, for where no shell has expanded them: `*` stands for any
// characters of one name, `?` for one, `**` as a whole name for any number of folders, also none.

/// Whether a path, or one name of it, holds `*` or `?`.
bool has_wildcards(std::string_view path);

/// Whether a name of a file or a folder fits a pattern without `/`. As in shells, a dot at the
/// beginning has to be written.
bool name_fits(std::string_view name, std::string_view pattern);

}  // namespace grafwire
