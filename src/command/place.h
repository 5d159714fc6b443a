#pragma once

#include <sys/stat.h>

#include <optional>
#include <string>

#include "text/message.h"

namespace grafwire {

/// Which file it is, whatever its name: two paths lead to one file where these are equal.
struct FileIdentity {
    dev_t device = 0;
    ino_t inode = 0;

    bool operator==(const FileIdentity&) const = default;
};

/// Where a result goes.
struct Place {
    enum class Kind {
        new_file,   ///< nothing is there yet
        file,       ///< a file that is to be replaced
        stream,     ///< a device, a pipe: can be written to, not replaced
        std_output  ///< standard output, whatever it is
    };
    Kind kind = Kind::new_file;
    std::string asked;   ///< the path as it was asked for
    std::string path;    ///< of a file: its own, behind all links
    std::string folder;  ///< of a file: where it stands, or will stand
    /// Of a file that is there: its rights and its owner. Of a stream as well.
    struct stat status = {};
    FileIdentity folder_identity;

    bool is_file() const { return kind == Kind::new_file || kind == Kind::file; }
    bool is_same_as(const Place& other) const;
    bool is_same_as(FileIdentity input) const;
};

/// Where `path` leads; "-" and the empty path stand for standard output. Empty, with the reason in
/// `problem`, where no file can be: in a folder that is not there, at a folder, over links that go
/// round in a circle.
std::optional<Place> place_of(const std::string& path, Localized& problem);

/// The file that an input is read from; empty where it is no file (or none that can be reached).
/// "-" stands for standard input.
std::optional<FileIdentity> identity_of_input(const std::string& path);

/// `path` in a message: "to standard output", or the path with what is not printable replaced.
Localized shown_place(const std::string& path);

}  // namespace grafwire
