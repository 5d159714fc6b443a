// All results are made before the first appears, and those that can be taken back (files, under
// other names until the end) before those that cannot (standard output, pipes, devices): so an exit
// status of 2 means that nothing has changed.

#include "command/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>

#include "command/messages.h"
#include "command/new_file.h"
#include "command/system_error.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

namespace say = messages::command;

/// Closes an open file in the end.
class OpenFile {
  public:
    explicit OpenFile(int file) : file_(file) {}
    ~OpenFile() {
        if (file_ >= 0) close(file_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    operator int() const { return file_; }

  private:
    int file_;
};

/// Reads to the end; false, with errno set, on an error.
bool read_all(int file, std::string& text) {
    char buffer[1 << 16];
    while (true) {
        const ssize_t count = read(file, buffer, sizeof buffer);
        if (count == 0) return true;
        if (count > 0) {
            text.append(buffer, static_cast<std::size_t>(count));
        } else if (errno != EINTR) {
            return false;
        }
    }
}

/// `cannot write out.csv: it is read-only`
Localized cannot_write(const std::string& path, const Localized& reason) {
    return say::cannot_write(shown_place(path), reason);
}

/// Writes to what cannot be replaced by a file: standard output, a device, a pipe.
bool write_stream(const Place& place, const std::string& text) {
    if (place.kind == Place::Kind::std_output) {
        return std::fflush(stdout) == 0 && write_fully(STDOUT_FILENO, text);
    }
    const int file = open(place.asked.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
    if (file < 0) return false;
    const bool is_written = write_fully(file, text);
    return close(file) == 0 && is_written;
}

}  // namespace

SourceFile read_source(const std::string& path, Diagnostics& diagnostics) {
    SourceFile source{path == "-" ? "<stdin>" : path, {}};
    if (path == "-") {
        if (!read_all(STDIN_FILENO, source.text)) {
            diagnostics.error(code::unreadable_file, {}, say::cannot_read_standard_input());
        }
        return source;
    }
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        diagnostics.error(code::unreadable_file, {}, say::is_a_directory());
        return source;
    }
    const OpenFile file(open(path.c_str(), O_RDONLY | O_NOCTTY | O_CLOEXEC));
    if (file < 0 || !read_all(file, source.text)) {
        diagnostics.error(code::unreadable_file, {}, say::cannot_read(reason_of(errno)));
    }
    return source;
}

void OutputFiles::add(std::string path, std::string text) {
    files_.emplace_back(std::move(path), std::move(text));
}

void OutputFiles::add_unless_there(std::string path, std::string text) {
    std::error_code error;
    const auto there = std::filesystem::symlink_status(path, error);
    if (there.type() == std::filesystem::file_type::not_found)
        add(std::move(path), std::move(text));
}

/// Which input stands at a place, as it is said in a message; nothing where none does.
std::optional<Localized> OutputFiles::input_at(const Place& place) const {
    for (const std::string& input : inputs_) {
        const auto identity = identity_of_input(input);
        if (!identity || !place.is_same_as(*identity)) continue;
        return input == "-" ? say::is_standard_input() : say::is_the_input(visible(input));
    }
    return std::nullopt;
}

/// Where everything goes; what cannot be is found before anything is written.
std::optional<Localized> OutputFiles::find_places(std::vector<Place>& places) const {
    for (const auto& [path, text] : files_) {
        Localized problem;
        const auto place = place_of(path, problem);
        if (!place) return cannot_write(path, problem);
        for (const Place& other : places) {
            if (place->is_same_as(other)) return cannot_write(path, say::is_to_hold_two_results());
        }
        if (const auto input = input_at(*place)) return cannot_write(path, *input);
        places.push_back(*place);
    }
    return std::nullopt;
}

/// The files to be removed that are there, by their own names: of a link only the link goes.
std::optional<Localized> OutputFiles::find_old_files(const std::vector<Place>& places,
                                                     std::vector<std::string>& old) const {
    for (const std::string& path : old_) {
        Localized problem;
        const auto file = place_of(path, problem);
        if (!file || !file->is_file()) continue;
        const auto cannot_remove = [&](const Localized& reason) {
            return say::cannot_remove_old(shown_place(path), reason);
        };
        for (const Place& place : places) {
            if (place.is_same_as(*file)) return cannot_remove(say::is_to_hold_a_result());
        }
        if (const auto input = input_at(*file)) return cannot_remove(*input);
        std::error_code error;
        if (!std::filesystem::exists(std::filesystem::symlink_status(path, error))) continue;
        const std::string folder = std::filesystem::path(path).parent_path().string();
        if (faccessat(AT_FDCWD, folder.empty() ? "." : folder.c_str(), W_OK, AT_EACCESS) != 0) {
            return cannot_remove(reason_of(errno));
        }
        old.push_back(path);
    }
    return std::nullopt;
}

std::optional<Localized> OutputFiles::write() {
    NewFolders new_folders;
    for (const std::string& folder : folders_) {
        if (const auto problem = new_folders.make(folder)) return cannot_write(folder, *problem);
    }
    std::vector<Place> places;
    std::vector<std::string> old;
    if (auto problem = find_places(places)) return problem;
    if (auto problem = find_old_files(places, old)) return problem;
    // The files in full, under other names; until these are undone signals must be held, once they
    // are.
    std::optional<HeldSignals> held;
    std::vector<std::pair<std::size_t, NewFile>> new_files;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!places[i].is_file()) continue;
        new_files.emplace_back(i, NewFile());
        if (const auto problem = new_files.back().second.write(places[i], files_[i].second)) {
            return cannot_write(places[i].asked, *problem);
        }
    }
    // What cannot be taken back goes out once nothing else is likely to fail.
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i].is_file() || write_stream(places[i], files_[i].second)) continue;
        return cannot_write(places[i].asked, reason_of(errno));
    }
    // All files under their own names; no signal comes in between.
    held.emplace();
    for (auto& [i, file] : new_files) {
        const bool is_last = &file == &new_files.back().second && old.empty();
        if (!file.put_in_place(is_last)) return cannot_write(places[i].asked, reason_of(errno));
    }
    for (const std::string& path : old) {
        if (unlink(path.c_str()) == 0 || errno == ENOENT) continue;
        return say::cannot_remove(shown_place(path), reason_of(errno));
    }
    for (auto& [i, file] : new_files) file.keep();
    new_folders.keep();
    return std::nullopt;
}

}  // namespace grafwire
