#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "text/diagnostics.h"

namespace grafwire {

/// The text of a file, or of standard input for "-". A file that cannot be read is reported in
/// `diagnostics` (Code::unreadable_file).
SourceFile read_source(const std::string& path, Diagnostics& diagnostics);

/// The output files of a command: they appear all together at the end, whole, or not at all.
class OutputFiles {
  public:
    /// "-" and the empty path stand for standard output.
    void add(std::string path, std::string text);

    /// Writes every file beside its place under another name, then moves all of them there; devices
    /// and pipes, standard output among them, come last. Returns what went wrong, or nothing.
    std::optional<std::string> write();

  private:
    std::vector<std::pair<std::string, std::string>> files_;
};

}  // namespace grafwire
