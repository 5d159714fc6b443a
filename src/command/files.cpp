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

bool write_stream(const std::string& path, const std::string& text) {
    if (!path.empty() && path != "-") return write_all(path, text);
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() &&
           std::fflush(stdout) == 0;
}

/// Standard output, and what is there but cannot be replaced by a file: a device, a pipe.
bool is_stream(const std::string& path) {
    if (path.empty() || path == "-") return true;
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
           !std::filesystem::is_directory(status);
}

/// The file itself where the path leads over symbolic links, so that no link is replaced.
std::string place_of(const std::string& path) {
    std::error_code error;
    const auto place = std::filesystem::weakly_canonical(path, error);
    return error || place.empty() ? path : place.string();
}

std::string cannot_write(const std::string& path) {
    return fmt::format("cannot write {}: {}",
                       path.empty() || path == "-" ? "to standard output" : path,
                       std::strerror(errno));
}

struct Result {
    std::string path;   ///< as asked for
    std::string place;  ///< where the file stands
    const std::string& text;
};

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
    // Where everything goes; what cannot be is found before anything is written.
    std::vector<Result> files;
    std::vector<Result> streams;
    for (const auto& [path, text] : files_) {
        const Result result{path, place_of(path), text};
        if (is_stream(path)) {
            streams.push_back(result);
            continue;
        }
        std::error_code error;
        if (std::filesystem::is_directory(result.place, error)) {
            return fmt::format("cannot write {}: it is a folder", path);
        }
        for (const Result& other : files) {
            if (other.place == result.place) {
                return fmt::format("cannot write {}: it is to hold two results", path);
            }
        }
        files.push_back(result);
    }
    // The files in full under other names, then all under their own.
    const std::string suffix = fmt::format(".{}.part", getpid());
    std::optional<std::string> problem;
    std::size_t made = 0;
    while (made < files.size() && !problem) {
        const Result& file = files[made++];
        if (!write_all(file.place + suffix, file.text)) problem = cannot_write(file.path);
    }
    for (std::size_t i = 0; i < files.size() && !problem; ++i) {
        if (std::rename((files[i].place + suffix).c_str(), files[i].place.c_str()) != 0) {
            problem = cannot_write(files[i].path);
        }
    }
    if (problem) {
        for (std::size_t i = 0; i < made; ++i) std::remove((files[i].place + suffix).c_str());
        return problem;
    }
    for (const Result& stream : streams) {
        if (!write_stream(stream.path, stream.text)) return cannot_write(stream.path);
    }
    return std::nullopt;
}

}  // namespace grafwire
