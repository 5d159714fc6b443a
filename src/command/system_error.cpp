// The C library has these texts in French too, but only where that locale is installed, and then in
// the one language of the locale.

#include "command/system_error.h"

#include <cerrno>

#include "command/messages.h"

namespace grafwire {

namespace say = messages::command;

Localized reason_of(int error) {
    struct Row {
        int error;
        const Message<>& reason;
    };
    static constexpr Row rows[] = {
        {EPERM, say::not_permitted},
        {ENOENT, say::no_such_file},
        {EIO, say::input_output_error},
        {ENXIO, say::no_such_address},
        {ENOMEM, say::no_memory},
        {EACCES, say::permission_denied},
        {EBUSY, say::busy},
        {EEXIST, say::file_exists},
        {ENODEV, say::no_such_device},
        {ENOTDIR, say::not_a_directory},
        {EISDIR, say::is_directory},
        {EINVAL, say::invalid_argument},
        {ENFILE, say::too_many_in_system},
        {EMFILE, say::too_many_open},
        {ETXTBSY, say::text_busy},
        {EFBIG, say::too_large},
        {ENOSPC, say::no_space},
        {EROFS, say::read_only_system},
        {EPIPE, say::broken_pipe},
        {ENAMETOOLONG, say::name_too_long},
        {ELOOP, say::too_many_links},
        {EDQUOT, say::quota_exceeded},
    };
    for (const Row& row : rows) {
        if (row.error == error) return row.reason();
    }
    return say::other_system_error(error);
}

}  // namespace grafwire
