// Shells expand patterns into files before a program sees them, but not everywhere (quotes, scripts
// of CI, other systems), and differ in `**` and in order. So what is still a pattern is expanded
// here, into what a shell would make of it; folders in it are looked through as far as the pattern
// reaches. Links to folders are not followed below what was written: they may lead in circles.

#include "command/chart_files.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "command/messages.h"
#include "command/path_pattern.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

namespace fs = std::filesystem;
namespace say = messages::command;

using Paths = std::vector<fs::path>;

/// What is in a folder; nothing where it cannot be read.
Paths entries_of(const fs::path& folder) {
    Paths entries;
    std::error_code error;
    const fs::path opened = folder.empty() ? "." : folder;
    for (fs::directory_iterator at(opened, error), end; !error && at != end; at.increment(error)) {
        entries.push_back(folder / at->path().filename());
    }
    return entries;
}

/// Whether it is a folder, and no link to one.
bool is_own_folder(const fs::path& path) {
    std::error_code error;
    return fs::symlink_status(path, error).type() == fs::file_type::directory;
}

bool is_folder(const fs::path& path) {
    std::error_code error;
    return fs::is_directory(path, error);
}

/// Every chart in a folder and in those below it.
void add_charts_below(const fs::path& folder, Paths& found) {
    for (const fs::path& entry : entries_of(folder)) {
        if (is_own_folder(entry)) {
            add_charts_below(entry, found);
        } else if (entry.extension() == ".grafcet" && !is_folder(entry)) {
            found.push_back(entry);
        }
    }
}

using Names = std::vector<std::string>;

/// What the names of a pattern from number `at` on stand for in a folder.
void expand(const fs::path& folder, const Names& pattern, std::size_t at, Paths& found) {
    if (at == pattern.size()) {
        found.push_back(folder);
        return;
    }
    const std::string& name = pattern[at];
    const bool is_any_depth = name == "**";
    if (!has_wildcards(name)) {
        std::error_code error;
        if (fs::exists(folder / name, error)) expand(folder / name, pattern, at + 1, found);
        return;
    }
    if (is_any_depth && at + 1 < pattern.size()) expand(folder, pattern, at + 1, found);
    for (const fs::path& entry : entries_of(folder)) {
        if (!name_fits(entry.filename().string(), name)) continue;
        const bool is_last = at + 1 == pattern.size();
        if (is_any_depth && is_own_folder(entry)) {
            expand(entry, pattern, at, found);
        } else if (is_last || (!is_any_depth && is_folder(entry))) {
            expand(entry, pattern, at + 1, found);
        }
    }
}

/// The files that fit a pattern, and the charts below folders that do.
Paths files_that_fit(const std::string& pattern) {
    const fs::path whole(pattern);
    Names names;
    for (const fs::path& name : whole.relative_path()) {
        if (!name.empty()) names.push_back(name.string());
    }
    Paths fitting;
    expand(whole.root_path(), names, 0, fitting);
    Paths files;
    for (const fs::path& path : fitting) {
        if (is_folder(path)) {
            add_charts_below(path, files);
        } else {
            files.push_back(path);
        }
    }
    return files;
}

enum class Kind { file, folder, pattern };

Kind kind_of(const std::string& word) {
    std::error_code error;
    if (word == "-") return Kind::file;
    if (is_folder(word)) return Kind::folder;
    return has_wildcards(word) && !fs::exists(word, error) ? Kind::pattern : Kind::file;
}

Localized nothing_in(Kind kind) {
    return kind == Kind::folder ? say::no_chart_in_folder() : say::nothing_fits();
}

}  // namespace

std::vector<std::string> ChartFiles::paths() const {
    std::vector<std::string> paths;
    for (const ChartFile& file : files) paths.push_back(file.path);
    return paths;
}

ChartFiles find_chart_files(const std::vector<std::string>& words) {
    ChartFiles found;
    found.are_several = words.size() > 1;
    std::set<std::string> known;
    const auto add = [&](ChartFile file) {
        const std::string normal = fs::path(file.path).lexically_normal().string();
        if (known.insert(normal).second) found.files.push_back(std::move(file));
    };
    for (const std::string& word : words) {
        const Kind kind = kind_of(word);
        if (kind == Kind::file) {
            add({word});
            continue;
        }
        found.are_several = true;
        Paths paths;
        if (kind == Kind::folder) {
            add_charts_below(word, paths);
        } else {
            paths = files_that_fit(word);
        }
        std::sort(paths.begin(), paths.end());
        for (const fs::path& path : paths) add({path.string()});
        if (paths.empty()) add({word, nothing_in(kind)});
    }
    return found;
}

SourceFile read_source(const ChartFile& file, Diagnostics& diagnostics) {
    if (!file.problem) return read_source(file.path, diagnostics);
    diagnostics.error(code::unreadable_file, {}, *file.problem);
    return {file.path, {}};
}

}  // namespace grafwire
