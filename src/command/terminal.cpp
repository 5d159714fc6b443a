#include "command/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace grafwire {

namespace {

std::string_view environment(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

}  // namespace

std::optional<TableLook> look_of_terminal() {
    if (isatty(STDOUT_FILENO) != 1) return std::nullopt;
    TableLook look;
    struct winsize size {};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col != 0) look.width = size.ws_col;
    look.is_emphasised = environment("NO_COLOR").empty() && environment("TERM") != "dumb";
    return look;
}

std::size_t width_of_output() {
    return look_of_terminal().value_or(TableLook()).width;
}

std::string trace_text(const Trace& trace, const Grafcet& grafcet, const std::string& path,
                       Language language) {
    const auto look = path.empty() ? look_of_terminal() : std::nullopt;
    return look ? write_trace_table(trace, grafcet, *look, language) : write_csv(trace);
}

}  // namespace grafwire
