#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "command/place.h"
#include "text/diagnostics.h"

namespace grafwire {

/// The text of a file, or of standard input for "-". A file that cannot be read is reported in
/// `diagnostics` (code::unreadable_file).
SourceFile read_source(const std::string& path, Diagnostics& diagnostics);

/// The results of a command: they appear all together at the end, whole, or not at all.
class OutputFiles {
  public:
    /// `inputs` are the paths that the command has read, none of which may be overwritten; empty
    /// ones count for nothing, "-" stands for standard input.
    explicit OutputFiles(std::vector<std::string> inputs) : inputs_(std::move(inputs)) {}

    /// "-" and the empty path stand for standard output.
    void add(std::string path, std::string text);
    /// The same where there is nothing at this path yet, else nothing.
    void add_unless_there(std::string path, std::string text);
    /// A folder that is made, with those above it, where it is missing.
    void add_folder(std::string path) { folders_.push_back(std::move(path)); }
    /// A file of an earlier time that goes, if it is there, once the others have come.
    void remove(std::string path) { old_.push_back(std::move(path)); }

    /// Writes every file beside its place under another name; then what goes to standard output,
    /// devices and pipes; then moves all files to their places. Returns what went wrong, or
    /// nothing.
    ///
    /// A file that is there is replaced: it keeps its rights and its owner, and a link to it stays
    /// a link, one that leads to nothing as well. It is left alone, which is an error, where that
    /// cannot be: a file that is read-only, that has other names (hard links), that cannot keep its
    /// owner, or stands in a folder where no file can be made; and where it is an input, or is to
    /// hold two results.
    std::optional<Localized> write();

  private:
    std::optional<Localized> input_at(const Place& place) const;
    std::optional<Localized> find_places(std::vector<Place>& places) const;
    std::optional<Localized> find_old_files(const std::vector<Place>& places,
                                            std::vector<std::string>& old) const;

    std::vector<std::string> inputs_;
    std::vector<std::pair<std::string, std::string>> files_;
    std::vector<std::string> folders_;
    std::vector<std::string> old_;
};

}  // namespace grafwire
