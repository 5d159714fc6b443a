#pragma once

#include <csignal>
#include <optional>
#include <string>
#include <vector>

#include "command/place.h"

namespace grafwire {

/// Holds back the signals that end the program while the object lives.
class HeldSignals {
  public:
    HeldSignals();
    ~HeldSignals();
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

  private:
    sigset_t before_;
};

/// Removes the files and folders that are not to outlive the program, in a program that ends in the
/// middle; calls nothing that a handler of signals may not call.
void remove_unfinished_files();

/// A file that is written beside its place, under a name that nobody can foresee, and then put
/// there. Unless kept it goes with the object, or with the signal that ends the program.
class NewFile {
  public:
    NewFile() = default;
    ~NewFile();
    NewFile(NewFile&& other) noexcept;
    NewFile& operator=(NewFile&&) = delete;

    /// Makes the file, whole, with the rights and the owner of the one that it is to replace;
    /// returns what went wrong, or nothing.
    std::optional<Localized> write(const Place& place, const std::string& text);
    /// Puts the file in its place; false, with errno set, where that cannot be. Where this is not
    /// for good, the object puts back what was there before, unless keep() is called; signals are
    /// to be held back meanwhile.
    bool put_in_place(bool for_good);
    void keep();

  private:
    /// What stands where.
    enum class State {
        beside,     ///< the new file under its other name
        exchanged,  ///< the new file in its place, the old one under the other name
        added,      ///< the new file in its place, where there was none
        kept,       ///< the new file in its place, for good; or there is none
    };

    std::optional<Localized> open(const Place& place, int& file);

    State state_ = State::kept;
    bool replaces_ = false;  ///< there was a file at the place
    std::string name_;
    std::string place_;
};

/// Folders that are made for results: they go with the object unless kept.
class NewFolders {
  public:
    NewFolders() = default;
    ~NewFolders();
    NewFolders(const NewFolders&) = delete;
    NewFolders& operator=(const NewFolders&) = delete;

    /// Makes a folder and those above it where they are missing; returns what went wrong, or
    /// nothing.
    std::optional<Localized> make(const std::string& path);
    void keep();

  private:
    std::vector<std::string> made_;
};

/// A folder for temporary files. It goes with the object, or with the signal that ends the program,
/// and with it those of its files that are there.
class TemporaryFolder {
  public:
    /// `files`: the names of all that may be made in it.
    explicit TemporaryFolder(const std::vector<std::string>& files);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    /// False, with errno set, where the folder could not be made.
    bool is_made() const { return is_made_; }
    std::string path_of(const std::string& file) const { return items_.front() + "/" + file; }

  private:
    bool is_made_ = false;
    std::vector<std::string> items_;  ///< the folder, then its files
};

/// Writes all of it to an open file; false, with errno set, on an error.
bool write_fully(int file, const std::string& text);

}  // namespace grafwire
