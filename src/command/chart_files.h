#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command/files.h"
#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// A file that a command is to work on.
struct ChartFile {
    std::string path;  ///< `-` for standard input
    /// What was written is a folder or a pattern in which nothing was found; `path` is that.
    std::optional<Localized> problem{};
};

/// The files that the words of a command line stand for.
struct ChartFiles {
    std::vector<ChartFile> files;
    /// Several words were written, or a folder, or a pattern. What is asked for does not depend on
    /// how many files there are at the moment, and neither does the form of what comes out.
    bool are_several = false;

    std::vector<std::string> paths() const;
};

/// Each word is a file, a folder (every `.grafcet` below it) or a pattern (path_pattern.h: what
/// fits; of folders that fit, what is below them). A file whose name looks like a pattern is a
/// file. Files keep the order of the words, and those of one word are sorted, name by name and byte
/// by byte, whatever the locale; a path that was there before is left out.
ChartFiles find_chart_files(const std::vector<std::string>& words);

/// The text of such a file; that nothing was found is reported as that it cannot be read.
SourceFile read_source(const ChartFile& file, Diagnostics& diagnostics);

}  // namespace grafwire
