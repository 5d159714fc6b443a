#include "command/files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace grafwire {

namespace {

/// Reads to the end; false on an error.
bool read_all(std::FILE* file, std::string& text) {
    char buffer[1 << 16];
    while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, file)) {
        text.append(buffer, count);
    }
    return std::ferror(file) == 0;
}

bool write_all(const std::string& path, const std::string& text) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) return false;
    const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    return std::fclose(file) == 0 && written;
}

}  // namespace

SourceFile read_source(const std::string& path, Diagnostics& diagnostics) {
    SourceFile source{path == "-" ? "<stdin>" : path, {}};
    if (path == "-") {
        if (!read_all(stdin, source.text)) {
            diagnostics.error(Code::unreadable_file, {}, "cannot read standard input");
        }
        return source;
    }
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        diagnostics.error(Code::unreadable_file, {}, "is a directory, not a file");
        return source;
    }
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (file == nullptr || !read_all(file, source.text)) {
        diagnostics.error(Code::unreadable_file, {},
                          fmt::format("cannot read the file: {}", std::strerror(errno)));
    }
    if (file != nullptr) std::fclose(file);
    return source;
}

void OutputFiles::add(std::string path, std::string text) {
    files_.emplace_back(std::move(path), std::move(text));
}

std::optional<std::string> OutputFiles::write() {
    const std::string suffix = fmt::format(".{}.part", getpid());
    std::vector<std::string> made;
    std::optional<std::string> problem;
    for (const auto& [path, text] : files_) {
        if (path.empty() || path == "-" || problem) continue;
        made.push_back(path + suffix);
        if (!write_all(made.back(), text)) {
            problem = fmt::format("cannot write {}: {}", path, std::strerror(errno));
        }
    }
    for (const auto& [path, text] : files_) {
        if (path.empty() || path == "-" || problem) continue;
        if (std::rename((path + suffix).c_str(), path.c_str()) != 0) {
            problem = fmt::format("cannot write {}: {}", path, std::strerror(errno));
        }
    }
    if (problem) {
        for (const std::string& path : made) std::remove(path.c_str());
        return problem;
    }
    for (const auto& [path, text] : files_) {
        if (!path.empty() && path != "-") continue;
        if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() ||
            std::fflush(stdout) != 0) {
            return "cannot write to standard output";
        }
    }
    return std::nullopt;
}

}  // namespace grafwire
