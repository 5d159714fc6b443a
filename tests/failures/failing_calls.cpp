// A library that is loaded before the C library (LD_PRELOAD) and lets calls of it fail: the n-th of
// a kind, and those after it as well where it is to stay so. What is asked for stands in the
// environment:
//
//     GRAFWIRE_FAIL=KIND:N:once   the N-th call of this kind fails; those are counted from 1
//     GRAFWIRE_FAIL=KIND:N:ever   all from the N-th on fail
//     GRAFWIRE_CALLS=FILE         how many calls of this kind there were is written here in the end
//
// Calls that the C library makes itself do not come by: its streams read and write unseen.

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdlib>
#include <cstring>

extern "C" {
// The allocators of the GNU C library under the names that nobody else defines.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
}

namespace {

enum class Kind { memory, read, write, rename, open, folder, none };

constexpr const char* names[] = {"memory", "read", "write", "rename", "open", "folder"};

Kind wanted = Kind::none;
unsigned long failing = 0;
bool goes_on = false;
unsigned long calls = 0;

/// Before anything of the program runs; needs no memory itself.
__attribute__((constructor)) void read_wish() {
    const char* wish = std::getenv("GRAFWIRE_FAIL");
    if (wish == nullptr) return;
    for (int kind = 0; kind < static_cast<int>(Kind::none); ++kind) {
        const std::size_t length = std::strlen(names[kind]);
        if (std::strncmp(wish, names[kind], length) != 0 || wish[length] != ':') continue;
        char* end = nullptr;
        failing = std::strtoul(wish + length + 1, &end, 10);
        goes_on = std::strcmp(end, ":ever") == 0;
        wanted = static_cast<Kind>(kind);
    }
}

__attribute__((destructor)) void tell_calls() {
    const char* path = std::getenv("GRAFWIRE_CALLS");
    if (path == nullptr) return;
    char digits[24];
    std::size_t at = sizeof digits;
    unsigned long rest = calls;
    do {
        digits[--at] = static_cast<char>('0' + rest % 10);
        rest /= 10;
    } while (rest != 0);
    const long file = syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    syscall(SYS_write, file, digits + at, sizeof digits - at);
    syscall(SYS_close, file);
}

bool fails(Kind kind, int error) {
    if (kind != wanted) return false;
    ++calls;
    if (calls != failing && !(goes_on && calls > failing)) return false;
    errno = error;
    return true;
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) {
    return fails(Kind::memory, ENOMEM) ? nullptr : __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
    return fails(Kind::memory, ENOMEM) ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size) {
    return fails(Kind::memory, ENOMEM) ? nullptr : __libc_realloc(memory, size);
}

ssize_t read(int file, void* buffer, std::size_t size) {
    return fails(Kind::read, EIO) ? -1 : syscall(SYS_read, file, buffer, size);
}

ssize_t write(int file, const void* buffer, std::size_t size) {
    // What goes to standard error is for people, and nothing depends on it.
    if (file != STDERR_FILENO && fails(Kind::write, ENOSPC)) return -1;
    return syscall(SYS_write, file, buffer, size);
}

int rename(const char* from, const char* to) {
    if (fails(Kind::rename, EACCES)) return -1;
    return static_cast<int>(syscall(SYS_rename, from, to));
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to,
              unsigned int flags) {
    if (fails(Kind::rename, EACCES)) return -1;
    return static_cast<int>(syscall(SYS_renameat2, from_folder, from, to_folder, to, flags));
}

int open(const char* path, int flags, ...) {
    std::va_list arguments;
    va_start(arguments, flags);
    const int rights = (flags & O_CREAT) != 0 ? va_arg(arguments, int) : 0;
    va_end(arguments);
    if (fails(Kind::open, EMFILE)) return -1;
    return static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, flags, rights));
}

int mkdir(const char* path, mode_t rights) {
    if (fails(Kind::folder, EACCES)) return -1;
    return static_cast<int>(syscall(SYS_mkdirat, AT_FDCWD, path, rights));
}

}  // extern "C"
