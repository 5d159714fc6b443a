// The library that writes FST, by the author of GTKWave. Debian has no package of it; its source
// comes with Verilator, which includes it in a file of C++ in the same way.

#ifdef GRAFWIRE_HAS_FST

#include "command/fst_library.h"

#include <zlib.h>

#include <cerrno>
#include <cstdio>
#include <utility>

namespace grafwire {

namespace {

int writing_error = 0;

/// An error of an earlier write stays with the file until it is closed.
int close_noting_errors(std::FILE* file) {
    if (std::ferror(file) != 0) writing_error = EIO;
    const int result = std::fclose(file);
    if (result != 0) writing_error = errno;
    return result;
}

int close_noting_errors(gzFile file) {
    const int result = gzclose(file);
    if (result != Z_OK) writing_error = result == Z_ERRNO ? errno : EIO;
    return result;
}

}  // namespace

int fst_writing_error() {
    return std::exchange(writing_error, 0);
}

}  // namespace grafwire

#define fclose(file) grafwire::close_noting_errors(file)
#define gzclose(file) grafwire::close_noting_errors(file)
#define FST_CONFIG_INCLUDE "gtkwave/fst_config.h"
#include "gtkwave/fastlz.c"  // NOLINT(bugprone-suspicious-include)
#include "gtkwave/fstapi.c"  // NOLINT(bugprone-suspicious-include)
#include "gtkwave/lz4.c"     // NOLINT(bugprone-suspicious-include)

#endif
