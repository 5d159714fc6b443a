#pragma once

#include <optional>
#include <string>
#include <vector>

#include "text/diagnostics.h"
#include "text/source.h"

namespace grafwire {

// `grafwire.toml`: options that all who work on a folder of charts share, a table for each command,
// in TOML 1.0 (toml.io).
//
//     [check]
//     style = "all"
//     strict = true

/// `style = "nand"`, below `[check]`.
struct SharedOption {
    std::string name;  ///< as on the command line: `--style`, `-j`
    Location where;
    /// What is written behind it: one text, or several of a list. Of true or false none.
    std::vector<std::string> values;
    std::optional<bool> truth;
};

struct SharedOptions {
    std::string command;
    Location where;
    std::vector<SharedOption> options;
};

/// Where the file is that belongs to a word of the command line that stands for charts (a file, a
/// folder, a pattern, `-`): in its folder, or in the nearest one above it that has one, but not
/// above the root of a repository (a folder with `.git`). Empty where there is none.
std::string config_file_for(const std::string& word);

/// Reads such a file, a table after the other; what is none of it goes into `diagnostics`.
std::vector<SharedOptions> read_config(const SourceFile& source, Diagnostics& diagnostics);

}  // namespace grafwire
