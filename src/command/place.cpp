// Two spellings may mean one file: `x.csv` and `./x.csv`, a link and what it leads to, two hard
// links, /dev/stdout and what the shell has put there. So files are told apart by device and inode
// and never by their paths. A file that does not exist yet has neither; it is told apart by its
// folder, which must exist, and its name there.

#include "command/place.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "command/messages.h"
#include "command/system_error.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

constexpr int most_links = 40;  // as many as Linux follows

/// Device and inode: what a file is, whatever it is called.
FileIdentity identity_of(const struct stat& status) {
    return {status.st_dev, status.st_ino};
}

/// Standard output where a result goes, standard input where a file is read.
bool is_standard_name(const std::string& path) {
    return path.empty() || path == "-";
}

/// The path without links, of something that exists; empty otherwise, with errno set.
std::string real_path(const std::string& path) {
    const std::unique_ptr<char, void (*)(void*)> found(realpath(path.c_str(), nullptr), std::free);
    return found ? std::string(found.get()) : std::string();
}

/// Where a link that leads to nothing, or a path that is none, says that the file is to be. Empty,
/// with errno set, after too many links.
std::filesystem::path end_of_links(std::filesystem::path path) {
    struct stat status = {};
    for (int i = 0; lstat(path.c_str(), &status) == 0 && S_ISLNK(status.st_mode); ++i) {
        std::error_code error;
        const std::filesystem::path target = std::filesystem::read_symlink(path, error);
        if (i == most_links || error) {
            errno = ELOOP;
            return {};
        }
        path = path.parent_path() / target;  // an absolute target stands alone
    }
    return path;
}

/// Sets where a file stands; false, with errno set, where its folder does not exist.
bool set_folder(Place& place, const std::filesystem::path& path) {
    const std::filesystem::path parent = path.parent_path();
    place.folder = real_path(parent.empty() ? "." : parent.string());
    struct stat status = {};
    if (place.folder.empty() || stat(place.folder.c_str(), &status) != 0) return false;
    if (path.filename().empty()) {
        errno = ENOENT;
        return false;
    }
    place.folder_identity = identity_of(status);
    place.path = (std::filesystem::path(place.folder) / path.filename()).string();
    return true;
}

/// Something is there: what is it?
bool set_existing(Place& place) {
    struct stat output = {};
    if (fstat(STDOUT_FILENO, &output) == 0 && identity_of(output) == identity_of(place.status)) {
        place.kind = Place::Kind::std_output;
        return true;
    }
    place.kind = Place::Kind::stream;
    if (!S_ISREG(place.status.st_mode)) return true;
    // What has no path of its own, such as a removed file that is still open, is written through.
    const std::string real = real_path(place.asked);
    struct stat status = {};
    if (real.empty() || stat(real.c_str(), &status) != 0 ||
        identity_of(status) != identity_of(place.status)) {
        return true;
    }
    place.kind = Place::Kind::file;
    return set_folder(place, real);
}

}  // namespace

bool Place::is_same_as(const Place& other) const {
    const bool is_new = kind == Kind::new_file;
    if (is_new != (other.kind == Kind::new_file)) return false;
    if (is_new) return folder_identity == other.folder_identity && path == other.path;
    if (is_standard_name(asked) && is_standard_name(other.asked)) return true;
    // Everything may go to one terminal, or to /dev/null.
    return !S_ISCHR(status.st_mode) && identity_of(status) == identity_of(other.status);
}

bool Place::is_same_as(FileIdentity input) const {
    return kind != Kind::new_file && identity_of(status) == input;
}

/// What exists is asked what it is; of what does not exist yet, links are followed to where the
/// file would be made.
std::optional<Place> place_of(const std::string& path, Localized& problem) {
    Place place;
    place.asked = path;
    if (is_standard_name(path)) {
        place.kind = Place::Kind::std_output;
        if (fstat(STDOUT_FILENO, &place.status) != 0) place.status = {};
        return place;
    }
    bool is_good = true;
    if (stat(path.c_str(), &place.status) == 0) {
        if (S_ISDIR(place.status.st_mode)) {
            problem = messages::command::is_a_folder();
            return std::nullopt;
        }
        is_good = set_existing(place);
    } else if (errno == ENOENT) {
        const std::filesystem::path end = end_of_links(path);
        is_good = !end.empty() && set_folder(place, end);
    } else {
        is_good = false;
    }
    if (is_good) return place;
    problem = reason_of(errno);
    return std::nullopt;
}

std::optional<FileIdentity> identity_of_input(const std::string& path) {
    struct stat status = {};
    const int failure = path == "-" ? fstat(STDIN_FILENO, &status) : stat(path.c_str(), &status);
    if (failure != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return identity_of(status);
}

Localized shown_place(const std::string& path) {
    if (is_standard_name(path)) return messages::command::standard_output();
    return {visible(path), visible(path)};
}

}  // namespace grafwire
