// What replaces a file is made beside it and then renamed: half a file is never seen. The
// other name is drawn at random and must be new: in a folder that others may write to, a name that
// can be foreseen could be a link to a file of ours that we would then overwrite. It is short and
// does not hold the name of the result, which may be as long as a name can be.
//
// A signal that ends the program would leave that file behind. Its handler removes what is in a
// list (unlink and rmdir are among the few calls that a handler may make) and then lets the signal
// end the program as it would have. The list changes only while the signals are held back.

#include "command/new_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <random>
#include <utility>
#include <vector>

#include "command/messages.h"
#include "command/system_error.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

namespace say = messages::command;

constexpr int ending_signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU};

/// Of names drawn at random, which may be taken.
constexpr int most_tries = 100;

/// Files and folders that are not to outlive the program.
std::vector<std::string> unfinished;

extern "C" void remove_unfinished(int signal) {
    remove_unfinished_files();
    std::signal(signal, SIG_DFL);
    std::raise(signal);  // arrives when this returns
}

/// Those that users, shells and systems end programs with.
sigset_t set_of_ending_signals() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : ending_signals) sigaddset(&set, signal);
    return set;
}

/// A signal that is ignored (nohup) stays so. One for a file beyond the limit (ulimit -f) is no
/// end: the write fails, and that is reported.
void catch_signals() {
    static bool is_done = false;
    if (std::exchange(is_done, true)) return;
    std::signal(SIGXFSZ, SIG_IGN);
    struct sigaction action = {};
    action.sa_handler = remove_unfinished;
    action.sa_mask = set_of_ending_signals();
    for (const int signal : ending_signals) {
        struct sigaction before = {};
        if (sigaction(signal, nullptr, &before) != 0 || before.sa_handler == SIG_IGN) continue;
        sigaction(signal, &action, nullptr);
    }
}

/// Takes a name from the list: the file stands in its place, or is gone.
void forget(const std::string& name) {
    const HeldSignals held;
    unfinished.erase(std::remove(unfinished.begin(), unfinished.end(), name), unfinished.end());
}

/// Two files change places in one step, so that at no moment one is missing.
bool change_places(const std::string& one, const std::string& other) {
    return renameat2(AT_FDCWD, one.c_str(), AT_FDCWD, other.c_str(), RENAME_EXCHANGE) == 0;
}

std::string random_name() {
    std::random_device source;
    return fmt::format(".grafwire-{:08x}{:08x}", source(), source());
}

/// Why the last call of the system failed.
Localized reason() {
    return reason_of(errno);
}

/// Why the file at the place cannot be replaced by a new one, or nothing.
std::optional<Localized> objection(const Place& place) {
    if (place.kind != Place::Kind::file) return std::nullopt;
    // Its owner has said so; root, who may write everything, should not do it in passing either.
    if ((place.status.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0) return say::is_read_only();
    if (faccessat(AT_FDCWD, place.path.c_str(), W_OK, AT_EACCESS) != 0) return reason();
    if (place.status.st_nlink > 1) {
        return say::has_hard_links();
    }
    return std::nullopt;
}

/// Gives a new file the owner and the rights of the one at the place.
std::optional<Localized> inherit(int file, const Place& place) {
    struct stat status = {};
    if (fstat(file, &status) != 0) return reason();
    const bool is_ours =
        status.st_uid == place.status.st_uid && status.st_gid == place.status.st_gid;
    if (!is_ours && fchown(file, place.status.st_uid, place.status.st_gid) != 0) {
        return say::belongs_to_others();
    }
    const mode_t rights = place.status.st_mode & 07777;
    if ((!is_ours || (status.st_mode & 07777) != rights) && fchmod(file, rights) != 0) {
        return reason();
    }
    return std::nullopt;
}

}  // namespace

void remove_unfinished_files() {
    for (auto item = unfinished.rbegin(); item != unfinished.rend(); ++item) {
        if (unlink(item->c_str()) != 0) rmdir(item->c_str());
    }
}

HeldSignals::HeldSignals() {
    const sigset_t set = set_of_ending_signals();
    pthread_sigmask(SIG_BLOCK, &set, &before_);
}

HeldSignals::~HeldSignals() {
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

bool write_fully(int file, const std::string& text) {
    for (std::size_t at = 0; at < text.size();) {
        const ssize_t count = ::write(file, text.data() + at, text.size() - at);
        if (count < 0 && errno != EINTR) return false;
        if (count > 0) at += static_cast<std::size_t>(count);
    }
    return true;
}

NewFile::NewFile(NewFile&& other) noexcept
    : state_(std::exchange(other.state_, State::kept)),
      replaces_(other.replaces_),
      name_(std::move(other.name_)),
      place_(std::move(other.place_)) {}

NewFile::~NewFile() {
    if (state_ == State::added) unlink(place_.c_str());
    if (state_ == State::exchanged && change_places(name_, place_)) state_ = State::beside;
    if (state_ != State::beside) return;
    unlink(name_.c_str());
    forget(name_);
}

void NewFile::keep() {
    if (state_ == State::exchanged) unlink(name_.c_str());  // the old one
    state_ = State::kept;
}

std::optional<Localized> NewFile::open(const Place& place, int& file) {
    // A file that nobody else may read must not be so while it is being written either.
    const mode_t rights = place.kind == Place::Kind::file ? 0600 : 0666;
    const HeldSignals held;
    for (int i = 0; i < most_tries; ++i) {
        std::string name = (std::filesystem::path(place.folder) / random_name()).string();
        file = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, rights);
        if (file < 0 && errno == EEXIST) continue;
        if (file < 0) break;
        name_ = std::move(name);
        state_ = State::beside;
        unfinished.push_back(name_);
        return std::nullopt;
    }
    return say::no_file_in_folder(visible(place.folder), reason());
}

/// The file is complete on return, but not yet seen under its own name.
std::optional<Localized> NewFile::write(const Place& place, const std::string& text) {
    catch_signals();
    if (auto problem = objection(place)) return problem;
    place_ = place.path;
    replaces_ = place.kind == Place::Kind::file;
    int file = -1;
    if (auto problem = open(place, file)) return problem;
    std::optional<Localized> problem;
    if (replaces_) problem = inherit(file, place);
    if (!problem && !write_fully(file, text)) problem = reason();
    if (::close(file) != 0 && !problem) problem = reason();
    return problem;
}

/// A file system that cannot exchange two files only has the way that is for good.
bool NewFile::put_in_place(bool for_good) {
    if (!for_good && replaces_) {
        if (change_places(name_, place_)) {
            state_ = State::exchanged;
            forget(name_);  // what bears that name now must outlive a sudden end
            return true;
        }
        if (errno != EINVAL && errno != ENOSYS) return false;
        for_good = true;
    }
    if (std::rename(name_.c_str(), place_.c_str()) != 0) return false;
    state_ = for_good ? State::kept : State::added;
    forget(name_);
    return true;
}

NewFolders::~NewFolders() {
    for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) {
        rmdir(folder->c_str());
        forget(*folder);
    }
}

std::optional<Localized> NewFolders::make(const std::string& path) {
    catch_signals();
    std::vector<std::filesystem::path> missing;
    std::error_code error;
    for (std::filesystem::path folder = path; !folder.empty() && !is_directory(folder, error);
         folder = folder.parent_path()) {
        missing.push_back(folder);
        if (folder == folder.parent_path()) break;
    }
    // Once a folder is made nothing may keep it from being noted, not even a lack of memory.
    made_.reserve(made_.size() + missing.size());
    unfinished.reserve(unfinished.size() + missing.size());
    for (auto folder = missing.rbegin(); folder != missing.rend(); ++folder) {
        std::string name = folder->string();
        std::string again = name;
        const HeldSignals held;
        if (mkdir(name.c_str(), 0777) == 0) {
            made_.push_back(std::move(name));
            unfinished.push_back(std::move(again));
        } else if (!is_directory(*folder, error)) {  // a path may end in a slash
            errno = errno == EEXIST ? ENOTDIR : errno;
            return reason();
        }
    }
    return std::nullopt;
}

/// Whatever needs memory comes before there is a folder.
TemporaryFolder::TemporaryFolder(const std::vector<std::string>& files) {
    catch_signals();
    std::error_code error;
    const std::filesystem::path all = std::filesystem::temp_directory_path(error);
    if (error) {
        errno = error.value();
        return;
    }
    std::string folder;
    for (int i = 0; i < most_tries && !is_made_; ++i) {
        folder = (all / random_name()).string();
        items_ = {folder};
        for (const std::string& file : files) items_.push_back(path_of(file));
        std::vector<std::string> noted = unfinished;
        noted.insert(noted.end(), items_.begin(), items_.end());
        const HeldSignals held;
        is_made_ = mkdir(folder.c_str(), 0700) == 0;
        if (is_made_) unfinished.swap(noted);
        if (!is_made_ && errno != EEXIST) break;
    }
}

TemporaryFolder::~TemporaryFolder() {
    if (!is_made_) return;
    for (auto item = items_.rbegin(); item != items_.rend(); ++item) {
        if (unlink(item->c_str()) != 0) rmdir(item->c_str());
        forget(*item);
    }
}

void NewFolders::keep() {
    for (const std::string& folder : made_) forget(folder);
    made_.clear();
}

}  // namespace grafwire
